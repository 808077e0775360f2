#include <mien/device_pixels.h>
#include "lib/base/memory_ran_out.h"
#include "render/device/packed_row.h"
#include "render/render_error.h"
#include "render/rows/drawing.h"
#include "render/watched.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <vector>

namespace mien {
namespace {

/// Draws in bands, each of which is packed while it is in the caches.
class DeviceWork {
 public:
  DeviceWork(const DeviceBuffer& out, const View& view, const Progress& progress)
      : out_(out), rect_(drawn_rect(view)), dither_(view.dither), progress_(progress) {}

  Done draw(const Scene& scene, const View& view, const Threads& threads) {
    drawing_.make(scene, view, depth_for(out_.format), threads);
    if (rect_.width < 1 || rect_.height < 1) return {};
    const int first = rect_.y / Drawing::kRows;
    bands_ = (rect_.y + rect_.height - 1) / Drawing::kRows + 1 - first;
    Watch& watch = *Watching::current();
    parallel_for(bands_, threads, [&](int i) {
      draw_band(first + i), ++drawn_;
      if (!goes_on()) watch.stop(Stopped::Why::cancelled);
    });
    return {};
  }

  /// Tells the share done; called by one thread at a time.
  bool goes_on() {
    if (!progress_) return true;
    const std::lock_guard lock(mutex_);
    return goes_on_ = goes_on_ && progress_(bands_ > 0 ? double(drawn_) / bands_ : 0.0);
  }

 private:
  void draw_band(int band) {
    const int top = std::max(rect_.y, band * Drawing::kRows),
              bottom = std::min(rect_.y + rect_.height, (band + 1) * Drawing::kRows);
    const std::size_t stride =
        std::size_t(rect_.width) * 4 * bytes_per_channel(depth_for(out_.format));
    std::vector<std::byte> rows(stride * std::size_t(bottom - top));
    StripScratch scratch;
    RenderStats stats;
    drawing_.draw_strip(band, {rows.data(), stride, {rect_.x, top, rect_.width, bottom - top}},
                        scratch, stats);
    for (int y = top; y < bottom; ++y)
      pack_row(out_.format, rows.data() + stride * std::size_t(y - top), rect_.x, y, rect_.width,
               dither_,
               static_cast<std::byte*>(out_.data) + out_.stride * std::size_t(y - rect_.y));
  }

  const DeviceBuffer& out_;
  PixelRect rect_;
  bool dither_;
  Drawing drawing_;
  int bands_ = 0;
  std::atomic<int> drawn_{0};
  const Progress& progress_;
  std::mutex mutex_;
  bool goes_on_ = true;
};

}  // namespace

std::size_t device_row_bytes(DeviceFormat format, int width) {
  const auto pixels = std::size_t(std::max(width, 0));
  if (format == DeviceFormat::mono) return (pixels + 7) / 8;
  return pixels * (format == DeviceFormat::bgrx ? 4 : 2);
}

Expected<Done> render_for_device(const DeviceBuffer& out, const Scene& scene, const View& view,
                                 const RenderOptions& how) try {
  if (!drawable(view)) return invalid_size(view);
  DeviceWork work(out, view, how.progress);
  const auto ask = how.progress ? Progress([&](double) { return work.goes_on(); }) : Progress();
  return watched(
      ask, how.limits, view.width * std::int64_t(view.height),
      [&] { return work.draw(scene, view, how.threads); }, [] { return 0.0; });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
