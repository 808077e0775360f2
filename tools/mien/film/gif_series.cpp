// GIF89a by giflib. A pixel that stays is written as transparent, which packs better. So a picture's pixels cannot turn
// transparent: where the next one has some that do, the part is cleared before it ("restore to background").

#include <mien/parallel.h>
#include "render/image/file/system_error.h"
#include "tools/mien/film/film_palette.h"
#include "tools/mien/film/picture_series.h"
#include "tools/mien/terminal/interrupt.h"

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace mien::command {
namespace {

using Places = std::vector<std::uint8_t>;

constexpr int kSamples = 64;                         // frames that are looked at for the palette,
constexpr long kSampledPixels = 32L << 20;           // in so many pixels
constexpr int kSide = 65535;                         // of a GIF, at most
constexpr std::uint8_t kStays = FilmPalette::kMost;  // the place of what is transparent

/// Rows and columns from .. up to before.
struct Bounds {
  int left, top, right = 0, bottom = 0;
  void add(int x, int y) {
    left = std::min(left, x), right = std::max(right, x + 1);
    top = std::min(top, y), bottom = std::max(bottom, y + 1);
  }
  bool empty() const { return right <= left; }
};

class GifSeries final : public PictureSeries {
 public:
  GifSeries(FileOutput& out, FilmPalette palette, int width, int height)
      : out_(out),
        palette_(std::move(palette)),
        width_(width),
        height_(height),
        canvas_(std::size_t(width) * std::size_t(height), kStays) {}
  ~GifSeries() override {
    int ignored = 0;
    if (gif_) EGifCloseFile(gif_, &ignored);
  }

  Expected<Done> begin();
  // Players show frames of less than two hundredths of a second slowly.
  FrameTicks ticks() const override { return {100, 2, 65535}; }
  Expected<Done> put(const Image& picture, const PixelRect& changed, long ticks) override;
  Expected<Done> finish() override;

 private:
  static int take(GifFileType* gif, const GifByteType* bytes, int size) {
    auto& self = *static_cast<GifSeries*>(gif->UserData);
    return self.out_.write(bytes, std::size_t(size)) ? size : 0;
  }
  std::size_t at(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  Places places_of(const Image& picture, const PixelRect& changed);
  Expected<Done> write_waiting(const Places* next);
  bool write_frame(const Bounds& part, bool cleared);
  Error failure() const;

  FileOutput& out_;
  FilmPalette palette_;
  int width_, height_;
  GifFileType* gif_ = nullptr;
  Places canvas_;   // before the picture that waits
  Places waiting_;  // the picture that is written when the next one is known
  long ticks_ = 0;  // how long it is seen
};

Error GifSeries::failure() const {
  if (out_.failure()) return {"", "cannot be written: " + system_error(out_.failure())};
  return {"", fmt::format("giflib failed: {}", gif_ ? GifErrorString(gif_->Error) : "no memory")};
}

Expected<Done> GifSeries::begin() {
  int failed = 0;
  gif_ = EGifOpen(this, take, &failed);
  if (!gif_) return failure();
  EGifSetGifVersion(gif_, true);
  // The last of 256 places is that of pixels that stay.
  std::vector<GifColorType> colors(256, GifColorType{});
  const auto& chosen = palette_.colors();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    colors[i] = {chosen[i].r, chosen[i].g, chosen[i].b};
  ColorMapObject* const map = GifMakeMapObject(256, colors.data());
  const unsigned char endless[3] = {1, 0, 0};
  const bool begun = map && EGifPutScreenDesc(gif_, width_, height_, 8, 0, map) &&
                     EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) &&
                     EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") &&
                     EGifPutExtensionBlock(gif_, sizeof endless, endless) &&
                     EGifPutExtensionTrailer(gif_);
  GifFreeMapObject(map);
  if (!begun) return failure();
  return Done{};
}

/// What is outside the changed part is as it was.
Places GifSeries::places_of(const Image& picture, const PixelRect& changed) {
  Places places = waiting_.empty() ? canvas_ : waiting_;
  for (int y = changed.y; y < changed.y + changed.height; ++y)
    for (int x = changed.x; x < changed.x + changed.width; ++x) {
      const std::uint8_t* pixel = picture.row(y) + 4 * x;
      places[at(x, y)] = is_there(pixel) ? palette_.place_of(pixel, x, y) : kStays;
    }
  return places;
}

Expected<Done> GifSeries::put(const Image& picture, const PixelRect& changed, long ticks) {
  Places next = places_of(picture, changed);
  if (!waiting_.empty())
    if (auto done = write_waiting(&next); !done) return done;
  waiting_ = std::move(next);
  ticks_ = ticks;
  return Done{};
}

Expected<Done> GifSeries::finish() {
  if (auto done = write_waiting(nullptr); !done) return done;
  int failed = 0;
  if (!EGifCloseFile(std::exchange(gif_, nullptr), &failed)) return failure();
  return Done{};
}

Expected<Done> GifSeries::write_waiting(const Places* next) {
  Bounds part{width_, height_}, gone{width_, height_};
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const std::uint8_t now = waiting_[at(x, y)];
      if (now != canvas_[at(x, y)]) part.add(x, y);
      if (next && now != kStays && (*next)[at(x, y)] == kStays) gone.add(x, y);
    }
  const bool cleared = !gone.empty();
  if (cleared) part.add(gone.left, gone.top), part.add(gone.right - 1, gone.bottom - 1);
  if (part.empty()) part = {0, 0, 1, 1};
  if (!write_frame(part, cleared)) return failure();
  canvas_ = waiting_;
  for (int y = part.top; cleared && y < part.bottom; ++y)
    std::fill_n(canvas_.begin() + std::ptrdiff_t(at(part.left, y)), part.right - part.left, kStays);
  return Done{};
}

bool GifSeries::write_frame(const Bounds& part, bool cleared) {
  const GraphicsControlBlock control{cleared ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT, false,
                                     int(ticks_), kStays};
  GifByteType block[4];
  const int width = part.right - part.left;
  if (EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, int(EGifGCBToExtension(&control, block)),
                       block) == GIF_ERROR ||
      EGifPutImageDesc(gif_, part.left, part.top, width, part.bottom - part.top, false, nullptr) ==
          GIF_ERROR)
    return false;
  Places row(std::size_t(width), kStays);
  for (int y = part.top; y < part.bottom; ++y) {
    for (int x = part.left; x < part.right; ++x) {
      const std::uint8_t now = waiting_[at(x, y)];
      row[std::size_t(x - part.left)] = now == canvas_[at(x, y)] ? kStays : now;
    }
    if (EGifPutLine(gif_, row.data(), width) == GIF_ERROR) return false;
  }
  return true;
}

/// Out of frames that are spread over the film.
Expected<FilmPalette> palette_of(const FilmPlan& plan) {
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

}  // namespace

MadeSeries gif_series(FileOutput& out, const FilmPlan& plan) {
  if (std::max(plan.width, plan.height) > kSide)
    return Error{"", fmt::format("a GIF has {} pixels a side at most", kSide)};
  auto palette = palette_of(plan);
  if (!palette) return palette.error();
  auto series = std::make_unique<GifSeries>(out, *std::move(palette), plan.width, plan.height);
  if (auto begun = series->begin(); !begun) return begun.error();
  return std::unique_ptr<PictureSeries>(std::move(series));
}

}  // namespace mien::command
