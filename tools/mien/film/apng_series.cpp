#include "render/image/png/animated_png.h"
#include "tools/mien/film/picture_series.h"

#include <cmath>

namespace mien::command {
namespace {

class ApngSeries final : public PictureSeries {
 public:
  ApngSeries(FileOutput& out, const FilmPlan& plan)
      : png_(out, {plan.width, Depth::u8, !plan.transparent}, plan.height),
        // A frame is a tick where a second has whole frames; else ticks are milliseconds.
        ticks_a_second_(std::floor(plan.fps) == plan.fps ? int(plan.fps) : 1000) {}

  FrameTicks ticks() const override { return {ticks_a_second_, 1, 65535}; }

  Expected<Done> put(const Image& picture, const PixelRect& changed, long ticks) override {
    const std::size_t at = picture.stride() * std::size_t(changed.y) + 4 * std::size_t(changed.x);
    return png_.add(changed, picture.bytes.data() + at, picture.stride(),
                    {std::uint16_t(ticks), std::uint16_t(ticks_a_second_)});
  }

  Expected<Done> finish() override { return png_.finish(); }

 private:
  AnimatedPng png_;
  int ticks_a_second_;
};

}  // namespace

MadeSeries apng_series(FileOutput& out, const FilmPlan& plan) {
  return std::unique_ptr<PictureSeries>(new ApngSeries(out, plan));
}

}  // namespace mien::command
