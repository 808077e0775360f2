#include <mien/render/renderer.h>
#include <mien/render/rows/drawing.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <new>

namespace mien {
namespace {

/// Counts finished jobs and tells the caller, one thread at a time; remembers a wish to stop.
class Watch {
 public:
  Watch(const Progress& progress, int jobs) : progress_(progress), jobs_(jobs) {}

  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  void job_done(const RenderStats& part) {
    const std::lock_guard lock(mutex_);
    stats_.add(part);
    ++done_;
    if (progress_ && !cancelled() && !progress_(double(done_) / jobs_)) cancelled_ = true;
  }

  RenderStats stats() const {
    RenderStats stats = stats_;
    stats.cancelled = cancelled();
    return stats;
  }

 private:
  const Progress& progress_;
  const int jobs_;
  int done_ = 0;
  RenderStats stats_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_ = false;
};

/// Scratch of threads, handed to whichever has strips to draw.
class Scratches {
 public:
  std::unique_ptr<StripScratch> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<StripScratch>();
    auto scratch = std::move(idle_.back());
    idle_.pop_back();
    return scratch;
  }
  void give_back(std::unique_ptr<StripScratch> scratch) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<StripScratch>> idle_;
};

bool drawable(const View& view) {
  const auto valid = [](int side) { return side >= 1 && side <= View::kMaxSide; };
  return valid(view.width) && valid(view.height);
}

}  // namespace

struct Renderer::Scratch {
  Drawing drawing;
  Scratches scratches;

  /// Strip by strip, several to a job.
  RenderStats draw(const RowTarget& target, const RenderOptions& how) {
    const PixelRect& r = target.rect;
    if (r.width <= 0 || r.height <= 0) return {};
    constexpr int kAtOnce = 4;  // strips: few enough to share out, enough to be worth it
    const int first = r.y / Drawing::kRows / kAtOnce,
              jobs = (r.y + r.height - 1) / Drawing::kRows / kAtOnce - first + 1;
    Watch watch(how.progress, jobs);
    const auto job = [&](int i) {
      if (watch.cancelled()) return;
      RenderStats part;
      auto scratch = scratches.take();
      for (int k = 0; k < kAtOnce; ++k)
        drawing.draw_strip((first + i) * kAtOnce + k, target, *scratch, part);
      scratches.give_back(std::move(scratch));
      watch.job_done(part);
    };
    parallel_for(jobs, how.threads, std::ref(job));  // by reference: a copy would be allocated
    RenderStats stats = watch.stats();
    stats.pixels = (long long)r.width * r.height;
    drawing.tell(stats);
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
    scratch_->drawing.make(scene, view, out.depth);
    const RenderStats took =
        scratch_->draw({static_cast<std::byte*>(out.data), out.stride, drawn_rect(view)}, how);
    if (stats) *stats = took;
    return !took.cancelled;
  } catch (const std::bad_alloc&) {
    scratch_.reset();
    return false;
  }
}

}  // namespace mien
