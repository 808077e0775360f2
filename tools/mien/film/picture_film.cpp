#include "tools/mien/film/picture_film.h"
#include "render/image/file/file_output.h"
#include "render/image/file/system_error.h"
#include "tools/mien/film/load_film_module.h"
#include "tools/mien/film/sampled_palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace mien::command {
namespace {

constexpr PixelRect kOnePixel{0, 0, 1, 1};
constexpr int kGifSide = 65535;

/// The smallest part outside which two pictures are equal.
PixelRect changed_part(const Image& before, const Image& now) {
  if (before.bytes.empty()) return {0, 0, now.width, now.height};
  const auto differs = [&](int y) {
    return std::memcmp(before.row(y), now.row(y), now.stride()) != 0;
  };
  int top = 0, bottom = now.height;
  while (top < bottom && !differs(top)) ++top;
  while (bottom > top && !differs(bottom - 1)) --bottom;
  if (top == bottom) return kOnePixel;
  int left = now.width, right = 0;
  for (int y = top; y < bottom; ++y) {
    const auto same = [&](int x) {
      return std::memcmp(before.row(y) + 4 * x, now.row(y) + 4 * x, 4) == 0;
    };
    for (int x = 0; x < left; ++x)
      if (!same(x)) left = x;
    for (int x = now.width - 1; x >= right; --x)
      if (!same(x)) right = x + 1;
  }
  return {left, top, right - left, bottom - top};
}

class PictureFilm final : public FilmWriter {
 public:
  PictureFilm(AtomicFile file, std::string name, double fps)
      : file_(std::move(file)),
        out_(file_.descriptor(), false),
        name_(std::move(name)),
        fps_(fps) {}

  Expected<Done> begin(const FilmPlan& plan) {
    auto series = made_series(plan);
    if (!series) return Error{name_, series.error().what};
    series_ = *std::move(series);
    return Done{};
  }

  Expected<Done> add(const Image& frame) override {
    const bool differs = frame.bytes != latest_.bytes;
    if (differs && frames_ > 0)
      if (auto done = end_latest(); !done) return Error{name_, done.error().what};
    if (differs) latest_ = frame, latest_from_ = frames_;
    ++frames_;
    return Done{};
  }

  Expected<Done> finish() override {
    auto done = end_latest();
    const FrameTicks ticks = series_->ticks();
    if (done) done = put_shown(std::max(tick_of(frames_) - shown_from_, ticks.shortest));
    if (done) done = series_->finish();
    if (!done) return Error{name_, done.error().what};
    return file_.commit();
  }

 private:
  MadeSeries made_series(const FilmPlan& plan) {
    if (plan.type == FilmType::apng) return apng_series(out_, plan);
    const auto module = film_module();
    if (!module) return module.error();
    const PutBytes put = [this](const void* bytes, std::size_t size) -> Expected<Done> {
      if (out_.write(bytes, size)) return Done{};
      return Error{"", "cannot be written: " + system_error(out_.failure())};
    };
    if (plan.type == FilmType::webp) return (*module)->webp(put, plan);
    if (std::max(plan.width, plan.height) > kGifSide)
      return Error{"", fmt::format("a GIF has {} pixels a side at most", kGifSide)};
    auto palette = sampled_palette(plan);
    if (!palette) return palette.error();
    return (*module)->gif(put, plan, *std::move(palette));
  }

  long tick_of(long frame) const {
    return std::lround(double(frame) * series_->ticks().a_second / fps_);
  }

  /// How long the latest picture is seen is known now. It takes the place of the one shown, or is left out where its time is
  /// over before that one may go.
  Expected<Done> end_latest() {
    const long shortest = series_->ticks().shortest;
    if (shown_.bytes.empty()) {
      shown_ = std::move(latest_);
      return Done{};
    }
    const long begin = std::max(tick_of(latest_from_), shown_from_ + shortest);
    if (tick_of(frames_) <= begin || latest_.bytes == shown_.bytes) return Done{};
    if (auto done = put_shown(begin - shown_from_); !done) return done;
    shown_ = std::move(latest_);
    shown_from_ = begin;
    return Done{};
  }

  Expected<Done> put_shown(long ticks) {
    PixelRect changed = changed_part(put_, shown_);
    const long longest = series_->ticks().longest;
    for (; ticks > longest; ticks -= longest, changed = kOnePixel)
      if (auto done = series_->put(shown_, changed, longest); !done) return done;
    auto done = series_->put(shown_, changed, ticks);
    put_ = std::move(shown_);
    return done;
  }

  AtomicFile file_;
  FileOutput out_;
  std::string name_;
  double fps_;
  std::unique_ptr<PictureSeries> series_;
  Image latest_, shown_, put_;  // the last one given, what is seen before it, what is in the file
  long frames_ = 0, latest_from_ = 0;  // [frames]
  long shown_from_ = 0;                // [ticks]
};

}  // namespace

Expected<std::unique_ptr<FilmWriter>> picture_film(AtomicFile file, const std::string& name,
                                                   const FilmPlan& plan) {
  auto film = std::make_unique<PictureFilm>(std::move(file), name, plan.fps);
  if (auto begun = film->begin(plan); !begun) return begun.error();
  return std::unique_ptr<FilmWriter>(std::move(film));
}

}  // namespace mien::command
