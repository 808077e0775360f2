#include <mien/render/renderer.h>
#include <mien/render/rows/drawing.h>
#include <mien/render/tile/band.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <new>
#include <optional>

namespace mien {
namespace {

/// Counts finished bands and tells the caller, one thread at a time; remembers a wish to stop.
class Watch {
 public:
  Watch(const Progress& progress, int bands) : progress_(progress), bands_(bands) {}

  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  void band_done(const RenderStats& part) {
    const std::lock_guard lock(mutex_);
    stats_.add(part);
    ++done_;
    if (progress_ && !cancelled() && !progress_(double(done_) / bands_)) cancelled_ = true;
  }

  RenderStats stats() const {
    RenderStats stats = stats_;
    stats.cancelled = cancelled();
    return stats;
  }

 private:
  const Progress& progress_;
  const int bands_;
  int done_ = 0;
  RenderStats stats_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_ = false;
};

/// Painters with their scratch, handed to whichever thread has a band to draw.
template <class Painter>
class Painters {
 public:
  std::unique_ptr<Painter> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<Painter>();
    auto painter = std::move(idle_.back());
    idle_.pop_back();
    return painter;
  }
  void give_back(std::unique_ptr<Painter> painter) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(painter));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Painter>> idle_;
};

bool drawable(const View& view) {
  const auto valid = [](int side) { return side >= 1 && side <= View::kMaxSide; };
  return valid(view.width) && valid(view.height);
}

}  // namespace

struct Renderer::Scratch {
  Tape tape;
  TapeMaker maker;
  std::optional<Plan> plan;  // of `tape`
  Painters<BandPainter> painters;
  Drawing drawing;
  Painters<StripScratch> strips;

  /// Strip by strip, several to a job.
  RenderStats draw_strips(const RowTarget& target, const RenderOptions& how) {
    const PixelRect& r = target.rect;
    if (r.width <= 0 || r.height <= 0) return {};
    constexpr int kAtOnce = 4;  // strips: as many rows as a band
    const int first = r.y / Drawing::kRows / kAtOnce,
              jobs = (r.y + r.height - 1) / Drawing::kRows / kAtOnce - first + 1;
    Watch watch(how.progress, jobs);
    const auto job = [&](int i) {
      if (watch.cancelled()) return;
      RenderStats part;
      auto scratch = strips.take();
      for (int k = 0; k < kAtOnce; ++k)
        drawing.draw_strip((first + i) * kAtOnce + k, target, *scratch, part);
      strips.give_back(std::move(scratch));
      watch.band_done(part);
    };
    parallel_for(jobs, how.threads, std::ref(job));  // by reference: a copy would be allocated
    RenderStats stats = watch.stats();
    stats.pixels = (long long)r.width * r.height;
    return stats;
  }

  RenderStats draw(const View& view, const Target& target, const RenderOptions& how) {
    const PixelRect& r = target.rect;
    if (r.width <= 0 || r.height <= 0) return {};
    const int first = r.y / kBandTile, bands = (r.y + r.height - 1) / kBandTile - first + 1;
    if (plan)
      plan->make(target.depth);
    else
      plan.emplace(tape, target.depth);
    Watch watch(how.progress, bands);
    const auto job = [&](int i) {
      if (watch.cancelled()) return;
      RenderStats part;
      auto painter = painters.take();
      painter->draw(*plan, view.width, view.height, (first + i) * kBandTile, target, part);
      painters.give_back(std::move(painter));
      watch.band_done(part);
    };
    parallel_for(bands, how.threads, std::ref(job));  // by reference: a copy would be allocated
    RenderStats stats = watch.stats();
    stats.pixels = (long long)r.width * r.height;
    return stats;
  }
};

Renderer::Renderer() = default;
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

bool Renderer::render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                           const RenderOptions& how, RenderStats* stats) {
  if (!drawable(view)) return false;
  try {
    if (!scratch_) scratch_ = std::make_unique<Scratch>();
    if (!std::getenv("MIEN_OLD") && scratch_->drawing.make(scene, view, out.depth)) {
      const RenderStats took = scratch_->draw_strips(
          {static_cast<std::byte*>(out.data), out.stride, drawn_rect(view)}, how);
      if (stats) *stats = took;
      return !took.cancelled;
    }
    scratch_->maker.make(scene, view, scratch_->tape);
    const Target target{static_cast<std::byte*>(out.data), out.stride, out.depth, drawn_rect(view)};
    const RenderStats took = scratch_->draw(view, target, how);
    if (stats) *stats = took;
    return !took.cancelled;
  } catch (const std::bad_alloc&) {
    scratch_.reset();
    return false;
  }
}

}  // namespace mien
