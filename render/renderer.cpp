#include <mien/renderer.h>
#include "lib/base/memory_ran_out.h"
#include "lib/base/watch.h"
#include "render/render_error.h"
#include "render/rows/drawing.h"
#include "render/rows/frame_memory.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <new>

namespace mien {
namespace {

/// Counts finished jobs and reports them to the caller, one thread at a time, until it asks to stop.
class DoneJobs {
 public:
  explicit DoneJobs(const Progress& progress) : progress_(progress) {}

  void begin(int jobs) { jobs_ = jobs; }
  /// Whether to go on.
  bool ask() {
    const std::lock_guard lock(mutex_);
    return report();
  }
  bool job_done(const RenderStats& part) {
    const std::lock_guard lock(mutex_);
    stats_.add(part);
    ++done_;
    return report();
  }
  RenderStats stats() const { return stats_; }

 private:
  bool report() {
    if (goes_on_ && progress_) goes_on_ = progress_(jobs_ ? double(done_) / jobs_ : 0.0);
    return goes_on_;
  }

  const Progress& progress_;
  int jobs_ = 0, done_ = 0;
  bool goes_on_ = true;
  RenderStats stats_;
  std::mutex mutex_;
};

}  // namespace

struct Renderer::Scratch {
  Drawing drawing;
  FrameMemory memory;
  bool keeps = false;
  StripScratches scratches;

  void make(const Scene& scene, const View& view, Depth depth, const Threads& threads) {
    const PixelRect r = drawn_rect(view);
    drawing.prepare(scene, view, depth, threads);
    const auto top_of = [](int band) { return band * Drawing::kRows; };
    int same = 0;
    for (int band = 0; band < drawing.bands(); ++band)
      if (!drawing.changed(band))
        same +=
            std::max(std::min(top_of(band + 1), r.y + r.height) - std::max(top_of(band), r.y), 0);
    keeps = memory.begin({view.height, r, depth, same});
    for (int band = 0; keeps && band < drawing.bands(); ++band)
      if (drawing.changed(band))
        memory.forget(top_of(band), std::min(top_of(band + 1), view.height));
    const auto is_wanted = [&](int band) {
      int y = std::max(top_of(band), r.y);
      const int bottom = std::min(top_of(band + 1), r.y + r.height);
      while (keeps && y < bottom && memory.holds(y)) ++y;
      return y < bottom;
    };
    drawing.arrange(std::ref(is_wanted), threads);
  }

  /// Copies the rows in which nothing has changed since the frame before, and draws the others.
  void draw_strip(int strip, const RowTarget& target, StripScratch& scratch, RenderStats& stats) {
    if (!keeps) return drawing.draw_strip(strip, target, scratch, stats);
    const PixelRect& r = target.rect;
    const int top = strip * Drawing::kRows, first = std::max(top, r.y),
              end = std::min(top + Drawing::kRows, r.y + r.height);
    if (first >= end) return;
    const auto row = [&](int y) { return target.data + target.stride * std::size_t(y - r.y); };
    int from = end, until = first;  // rows to be drawn lie between these
    for (int y = first; y < end; ++y)
      if (memory.holds(y))
        memory.recall(y, row(y));
      else
        from = std::min(from, y), until = y + 1;
    const int drawn = std::max(until - from, 0);
    stats.recalled_pixels += (long long)r.width * (end - first - drawn);
    if (drawn == 0) return;
    drawing.draw_strip(strip, {row(from), target.stride, {r.x, from, r.width, drawn}}, scratch,
                       stats);
    for (int y = from; y < until; ++y)
      if (scratch.odd_rows >> (y - top) & 1)
        memory.forget(y, y + 1);
      else
        memory.keep(y, row(y));
  }

  /// Strip by strip, several to a job.
  RenderStats draw(const RowTarget& target, const RenderOptions& how, Watch& watch,
                   DoneJobs& done) {
    const PixelRect& r = target.rect;
    if (r.width <= 0 || r.height <= 0) return {};
    constexpr int kAtOnce = 4;  // strips: few enough to share out, enough to be worth it
    const int first = r.y / Drawing::kRows / kAtOnce,
              jobs = (r.y + r.height - 1) / Drawing::kRows / kAtOnce - first + 1;
    done.begin(jobs);
    const auto job = [&](int i) {
      RenderStats part;
      auto scratch = scratches.take();
      for (int k = 0; k < kAtOnce; ++k)
        draw_strip((first + i) * kAtOnce + k, target, *scratch, part);
      scratches.give_back(std::move(scratch));
      if (!done.job_done(part)) watch.stop(Stopped::Why::cancelled);
    };
    parallel_for(jobs, how.threads, std::ref(job));  // by reference: a copy would be allocated
    RenderStats stats = done.stats();
    stats.pixels = (long long)r.width * r.height;
    drawing.tell(stats);
    return stats;
  }
};

Renderer::Renderer() = default;
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Expected<Done> Renderer::render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                                     const RenderOptions& how, RenderStats* stats) try {
  if (!drawable(view)) return invalid_size(view);
  const PixelRect rect = drawn_rect(view);
  DoneJobs done(how.progress);
  Watch watch(how.progress ? std::function<bool()>([&] { return done.ask(); }) : nullptr,
              how.limits, rect.width * std::int64_t(rect.height));
  RenderStats took;
  const auto tell = [&] {
    took.steps = watch.steps(), took.memory = (long long)(watch.memory());
    if (stats) *stats = took;
  };
  try {
    {
      const Watching here(&watch);
      if (!scratch_) scratch_ = std::make_unique<Scratch>();
      scratch_->make(scene, view, out.depth, how.threads);
      took =
          scratch_->draw({static_cast<std::byte*>(out.data), out.stride, rect}, how, watch, done);
    }
    if (watch.stopped()) throw Stopped{watch.why()};  // by its last steps
    tell();
    return Done{};
  } catch (const Stopped&) {
    scratch_.reset();  // it may be large, and half made
    took = done.stats();
    took.cancelled = watch.why() == Stopped::Why::cancelled;
    tell();
    return why_stopped(watch);
  } catch (const std::bad_alloc&) {
    scratch_.reset();
    return out_of_memory(rect);
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
