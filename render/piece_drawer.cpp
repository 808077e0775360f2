#include <mien/piece_drawer.h>
#include "lib/base/memory_ran_out.h"
#include "render/render_error.h"
#include "render/rows/drawing.h"
#include "render/watched.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <new>

namespace mien {

struct PieceDrawer::Parts {
  int width = 0, height = 0;
  Drawing drawing;
  StripScratches scratches;
  RenderLimits limits;
  /// What making the drawing took, for the first piece's figures: steps, and bytes held.
  std::atomic<std::int64_t> steps{0};
  std::uint64_t memory = 0;

  bool hold(const PixelRect& piece) const {
    return piece.x >= 0 && piece.y >= 0 && piece.width >= 1 && piece.height >= 1 &&
           piece.x <= width - piece.width && piece.y <= height - piece.height;
  }
};

PieceDrawer::PieceDrawer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
PieceDrawer::PieceDrawer(PieceDrawer&&) noexcept = default;
PieceDrawer& PieceDrawer::operator=(PieceDrawer&&) noexcept = default;
PieceDrawer::~PieceDrawer() = default;

Expected<PieceDrawer> PieceDrawer::of(const Scene& scene, const View& view, Depth depth,
                                      const RenderLimits& limits,
                                      const std::function<bool()>& stop) try {
  if (!drawable(view)) return invalid_size(view);
  const auto goes_on = [&](double) { return !stop || !stop(); };
  const auto make = [&] {
    auto parts = std::make_unique<Parts>();
    parts->width = view.width, parts->height = view.height, parts->limits = limits;
    View whole = view;
    whole.region.reset();
    parts->drawing.make(scene, whole, depth);
    const Watch& watch = *Watching::current();
    parts->steps = watch.steps(), parts->memory = watch.memory();
    return PieceDrawer(std::move(parts));
  };
  try {
    return watched(goes_on, limits, 0, make, [] { return 0.0; });
  } catch (const std::bad_alloc&) {
    return out_of_memory({0, 0, view.width, view.height});
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<Done> PieceDrawer::draw(const PixelBuffer& out, const PixelRect& piece,
                                 const std::function<bool()>& stop, RenderStats* stats) try {
  if (!parts_->hold(piece))
    return Error{"",
                 fmt::format("the piece {},{},{},{} is not in a picture of {} x {} pixels", piece.x,
                             piece.y, piece.width, piece.height, parts_->width, parts_->height)};
  const int first = piece.y / Drawing::kRows, last = (piece.y + piece.height - 1) / Drawing::kRows;
  RenderStats took;
  Watch watch([&] { return !stop || !stop(); }, parts_->limits,
              piece.width * std::int64_t(piece.height));
  const auto tell = [&] {
    took.steps = watch.steps() + parts_->steps.exchange(0);
    took.memory = (long long)(std::max(watch.memory(), parts_->memory));
    parts_->drawing.tell(took);
    if (stats) stats->add(took);
  };
  try {
    const Watching here(&watch);
    if (stop && stop()) watch.stop(Stopped::Why::cancelled);
    auto scratch = parts_->scratches.take();
    for (int strip = first; strip <= last; ++strip) {
      watch.look(0);
      parts_->drawing.draw_strip(strip, {static_cast<std::byte*>(out.data), out.stride, piece},
                                 *scratch, took);
    }
    parts_->scratches.give_back(std::move(scratch));
  } catch (const Stopped&) {
    took.cancelled = watch.why() == Stopped::Why::cancelled;
    tell();
    return why_stopped(watch);
  } catch (const std::bad_alloc&) {
    return out_of_memory(piece);
  }
  took.pixels += (long long)piece.width * piece.height;
  tell();
  return Done{};
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
