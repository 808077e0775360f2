#include <mien/render/render.h>
#include <mien/render/tile/picture.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>

namespace mien {
namespace {

void add(RenderStats& sum, const RenderStats& part) {
  sum.pixels += part.pixels;
  sum.fill_pixels += part.fill_pixels;
  sum.one_edge_pixels += part.one_edge_pixels;
  sum.divided_pixels += part.divided_pixels;
  sum.varied_pixels += part.varied_pixels;
  sum.cells += part.cells;
}

/// Counts finished tiles and tells the caller, one thread at a time; remembers a wish to stop.
class Watch {
 public:
  Watch(const Progress& progress, int tiles) : progress_(progress), tiles_(tiles) {}

  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  void tile_done(const RenderStats& part) {
    const std::lock_guard lock(mutex_);
    add(stats_, part);
    ++done_;
    if (progress_ && !cancelled() && !progress_(double(done_) / tiles_)) cancelled_ = true;
  }

  RenderStats stats() const {
    RenderStats stats = stats_;
    stats.cancelled = cancelled();
    return stats;
  }

 private:
  const Progress& progress_;
  const int tiles_;
  int done_ = 0;
  RenderStats stats_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_ = false;
};

bool opaque(const Tape& tape) {
  return tape.background.a >= 1.0;
}

RenderStats draw(const Tape& tape, const View& view, const Target& target,
                 const RenderOptions& how) {
  const PixelRect& r = target.rect;
  if (r.width <= 0 || r.height <= 0) return {};
  const int x0 = r.x / kTile, y0 = r.y / kTile;
  const int columns = (r.x + r.width - 1) / kTile - x0 + 1,
            rows = (r.y + r.height - 1) / kTile - y0 + 1;
  Watch watch(how.progress, columns * rows);
  parallel_for(columns * rows, how.threads, [&](int i) {
    if (watch.cancelled()) return;
    RenderStats part;
    draw_tile(tape, view.width, view.height, (x0 + i % columns) * kTile, (y0 + i / columns) * kTile,
              target, part);
    watch.tile_done(part);
  });
  RenderStats stats = watch.stats();
  stats.pixels = (long long)r.width * r.height;
  return stats;
}

/// The empty image, where no other can be given.
Image no_image(Depth depth) {
  return {.depth = depth};
}

bool drawable(const View& view) {
  const auto valid = [](int side) { return side >= 1 && side <= View::kMaxSide; };
  return valid(view.width) && valid(view.height);
}

}  // namespace

Image render(const Scene& scene, const View& view, const RenderOptions& how, RenderStats* stats) {
  if (!drawable(view)) return no_image(how.depth);
  try {
    const PixelRect rect = drawn_rect(view);
    Image image{.width = rect.width, .height = rect.height, .depth = how.depth};
    image.bytes.resize(image.stride() * std::size_t(rect.height));  // at most 2^44 bytes
    const Tape tape = tape_from_scene(scene, view);
    image.opaque = opaque(tape);
    const RenderStats took =
        draw(tape, view, {image.bytes.data(), image.stride(), how.depth, rect}, how);
    if (stats) *stats = took;
    return image;
  } catch (const std::bad_alloc&) {
    return no_image(how.depth);
  }
}

bool render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                 const RenderOptions& how, RenderStats* stats) {
  if (!drawable(view)) return false;
  try {
    const Tape tape = tape_from_scene(scene, view);
    const Target target{static_cast<std::byte*>(out.data), out.stride, out.depth, drawn_rect(view)};
    const RenderStats took = draw(tape, view, target, how);
    if (stats) *stats = took;
    return !took.cancelled;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace mien
