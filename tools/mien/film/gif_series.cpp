// GIF89a by giflib. A pixel that stays is written as transparent, which packs better. So a picture's pixels cannot turn
// transparent: where the next one has some that do, the part is cleared before it ("restore to background").

#include "tools/mien/film/film_module.h"

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <utility>

namespace mien::command {
namespace {

using Places = std::vector<std::uint8_t>;

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
  GifSeries(const PutBytes& put, FilmPalette palette, int width, int height)
      : put_(put),
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
    if (self.wrong_) return 0;
    auto done = self.put_(bytes, std::size_t(size));
    if (!done) self.wrong_ = done.error();
    return done ? size : 0;
  }
  std::size_t at(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  Places places_of(const Image& picture, const PixelRect& changed);
  Expected<Done> write_waiting(const Places* next);
  bool write_frame(const Bounds& part, bool cleared);
  Error failure() const;

  PutBytes put_;
  std::optional<Error> wrong_;  // what the file said; giflib does not pass all of it on
  FilmPalette palette_;
  int width_, height_;
  GifFileType* gif_ = nullptr;
  Places canvas_;   // before the picture that waits
  Places waiting_;  // the picture that is written when the next one is known
  long ticks_ = 0;  // how long it is seen
};

Error GifSeries::failure() const {
  if (wrong_) return *wrong_;
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
  if (!begun || wrong_) return failure();
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
  if (!EGifCloseFile(std::exchange(gif_, nullptr), &failed) || wrong_) return failure();
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
  if (!write_frame(part, cleared) || wrong_) return failure();
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

}  // namespace

MadeSeries gif_series(const PutBytes& put, const FilmPlan& plan, FilmPalette palette) {
  auto series = std::make_unique<GifSeries>(put, std::move(palette), plan.width, plan.height);
  if (auto begun = series->begin(); !begun) return begun.error();
  return std::unique_ptr<PictureSeries>(std::move(series));
}

}  // namespace mien::command
