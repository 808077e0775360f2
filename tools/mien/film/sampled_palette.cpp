#include "tools/mien/film/sampled_palette.h"
#include <mien/parallel.h>
#include "tools/mien/terminal/interrupt.h"

#include <algorithm>
#include <mutex>
#include <optional>

namespace mien::command {
namespace {

constexpr int kSamples = 64;                // frames that are looked at,
constexpr long kSampledPixels = 32L << 20;  // in so many pixels

}  // namespace

Expected<FilmPalette> sampled_palette(const FilmPlan& plan) {
  FilmPalette palette;
  const long pixels = long(plan.width) * plan.height;
  const long samples =
      std::min(plan.frames, std::clamp(kSampledPixels / pixels, 2L, long(kSamples)));
  std::mutex mutex;
  std::optional<Error> wrong;
  parallel_for(int(samples), {.count = plan.threads}, [&](int i) {
    if (interrupted()) return;
    const auto frame = plan.draw(samples > 1 ? i * (plan.frames - 1) / (samples - 1) : 0);
    const std::lock_guard lock(mutex);
    if (!frame) wrong = frame.error();
    if (frame) palette.count(*frame);
  });
  if (wrong) return *wrong;
  palette.choose();
  return palette;
}

}  // namespace mien::command
