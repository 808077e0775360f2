#include "tools/mien/film/film_module.h"

#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <utility>

namespace mien::command {
namespace {

/// libwebp's encoder of animations. It holds the film's packed bytes until the end, since a WebP begins with its length.
class WebpSeries final : public PictureSeries {
 public:
  WebpSeries(const PutBytes& put, bool opaque) : put_(put), opaque_(opaque) {}
  ~WebpSeries() override { WebPAnimEncoderDelete(encoder_); }

  bool begin(int width, int height) {
    constexpr int kLevel = 3;  // 0 is quick, 9 small
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&config_) ||
        !WebPConfigLosslessPreset(&config_, kLevel))
      return false;
    // Every frame is a change of the one before: a face moves little of itself.
    options.kmin = options.kmax = 0;
    options.anim_params.loop_count = 0;  // without end
    encoder_ = WebPAnimEncoderNew(width, height, &options);
    return encoder_ != nullptr;
  }

  FrameTicks ticks() const override { return {1000, 1, kLongest}; }

  Expected<Done> put(const Image& picture, const PixelRect&, long ticks) override {
    WebPPicture pixels;
    if (!WebPPictureInit(&pixels)) return Error{"", "libwebp is of another version"};
    pixels.use_argb = 1;
    pixels.width = picture.width, pixels.height = picture.height;
    const auto import = opaque_ ? WebPPictureImportRGBX : WebPPictureImportRGBA;
    const bool added = import(&pixels, picture.row(0), int(picture.stride())) &&
                       WebPAnimEncoderAdd(encoder_, &pixels, int(time_), &config_);
    WebPPictureFree(&pixels);
    time_ += ticks;
    if (!added) return failure();
    if (time_ > kLongestFilm) return Error{"", "a WebP lasts 24 days at most"};
    return Done{};
  }

  Expected<Done> finish() override {
    WebPData film;
    WebPDataInit(&film);
    const bool made = WebPAnimEncoderAdd(encoder_, nullptr, int(time_), nullptr) &&
                      WebPAnimEncoderAssemble(encoder_, &film);
    auto done = made ? put_(film.bytes, film.size) : Expected<Done>(failure());
    WebPDataClear(&film);
    return done;
  }

 private:
  static constexpr long kLongest = (1L << 24) - 1;           // [ms] of a frame, by the format
  static constexpr long kLongestFilm = 24L * 24 * 3600'000;  // [ms] within an int

  Error failure() const {
    return {"", fmt::format("libwebp failed: {}", WebPAnimEncoderGetError(encoder_))};
  }

  PutBytes put_;
  bool opaque_;
  WebPConfig config_;
  WebPAnimEncoder* encoder_ = nullptr;
  long time_ = 0;  // [ms]
};

}  // namespace

MadeSeries webp_series(const PutBytes& put, const FilmPlan& plan) {
  if (std::max(plan.width, plan.height) > WEBP_MAX_DIMENSION)
    return Error{"", fmt::format("a WebP has {} pixels a side at most", WEBP_MAX_DIMENSION)};
  auto series = std::make_unique<WebpSeries>(put, !plan.transparent);
  if (!series->begin(plan.width, plan.height)) return Error{"", "libwebp cannot begin the film"};
  return std::unique_ptr<PictureSeries>(std::move(series));
}

}  // namespace mien::command
