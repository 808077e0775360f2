// Files of pictures. Scenes are drawn through the C interface, of which this library sees no more than anybody.

#include "bind/c/door_private.h"
#include "bind/c/image/mien_image_c.h"
#include "render/image/file_type.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>

using namespace mien::c;

namespace {

constexpr mien_write_options kDefaults{.size = sizeof(mien_write_options),
                                       .type = MIEN_FILE_BY_NAME,
                                       .half = 1,
                                       .jpeg_quality = 95,
                                       .depth = -1,
                                       .memory = std::uint64_t(256) << 20,
                                       .recipe_length = MIEN_NUL_ENDED};

mien_write_options whole_options(const mien_write_options* given) {
  return given ? whole_struct(given, kDefaults, "options") : kDefaults;
}

mien::WriteOptions options_of(const mien_write_options& o) {
  if (o.type < MIEN_FILE_BY_NAME || o.type > MIEN_FILE_JPEG)
    misuse("options.type", "is none of the MIEN_FILE_ types");
  if (o.threads < 0) misuse("options.threads", "is " + std::to_string(o.threads));
  if (o.jpeg_quality < 1 || o.jpeg_quality > 100)
    refuse("options.jpeg_quality", "expected 1 to 100, got " + std::to_string(o.jpeg_quality));
  if (o.dpi != 0 && !(o.dpi >= 1 && o.dpi <= mien::WriteOptions::kMostDpi))
    refuse("options.dpi", "expected 0, or 1 to 100000");
  mien::WriteOptions options{.half = o.half != 0, .jpeg_quality = o.jpeg_quality, .dpi = o.dpi};
  if (o.type != MIEN_FILE_BY_NAME) options.type = mien::FileType(o.type - 1);
  if (o.recipe) options.recipe = text_of(o.recipe, o.recipe_length, "options.recipe");
  options.threads.count = o.threads;
  if (o.progress)
    options.progress = [=](double done) { return o.progress(done, o.progress_data) == 0; };
  return options;
}

/// Options whose progress remembers whether it was asked to stop.
struct Watched {
  mien::WriteOptions how;
  std::shared_ptr<std::atomic<bool>> stopped = std::make_shared<std::atomic<bool>>(false);

  explicit Watched(mien::WriteOptions options) : how(std::move(options)) {
    if (auto asked = how.progress)
      how.progress = [asked, stopped = stopped](double done) {
        if (!asked(done)) *stopped = true;
        return !*stopped;
      };
  }
};

std::size_t channel_bytes(int32_t depth) {
  return mien::bytes_per_channel(mien::Depth(depth));
}

template <class Channel>
bool all_are(const unsigned char* row, int width, Channel full) {
  const auto* const pixels = reinterpret_cast<const Channel*>(row);
  for (int x = 0; x < width; ++x)
    if (!(pixels[4 * x + 3] >= full)) return false;
  return true;
}

bool is_opaque(const mien_pixels& pixels, int width, int height) {
  for (int y = 0; y < height; ++y) {
    const auto* const row =
        static_cast<const unsigned char*>(pixels.data) + std::size_t(y) * pixels.stride;
    const bool opaque = pixels.depth == MIEN_U8    ? all_are<std::uint8_t>(row, width, 255)
                        : pixels.depth == MIEN_U16 ? all_are<std::uint16_t>(row, width, 65535)
                                                   : all_are<float>(row, width, 1.0f);
    if (!opaque) return false;
  }
  return true;
}

/// The pixels, if they hold what they say.
mien_pixels checked_pixels(const mien_pixels* given, int width, int height) {
  mien_pixels defaults;
  mien_pixels_init(&defaults, sizeof defaults);
  const mien_pixels p = whole_struct(given, defaults, "pixels");
  if (width < 1 || height < 1 || std::max(width, height) > mien::View::kMaxSide)
    refuse("width and height", "a picture's sides are 1 to 1048576 pixels");
  if (p.depth < MIEN_U8 || p.depth > MIEN_F32)
    misuse("pixels.depth", "is none of MIEN_U8, U16, F32");
  const std::size_t channel = channel_bytes(p.depth), row = std::size_t(width) * 4 * channel;
  if (!p.data) misuse("pixels.data", "is NULL");
  if (reinterpret_cast<std::uintptr_t>(p.data) % channel || p.stride % channel || p.stride < row ||
      p.bytes < row || (p.bytes - row) / p.stride < std::size_t(height) - 1)
    misuse("pixels", "data, bytes and stride do not hold the picture");
  return p;
}

void write(const mien::PiecesToWrite& what, const std::string& path, const Watched& watched) {
  const auto done = mien::write_pieces(what, path, watched.how, mien::load_encoder);
  if (!done) throw Refusal{*watched.stopped ? MIEN_CANCELLED : MIEN_NOT_WRITTEN, done.error()};
}

/// Throws what the C interface said. A reference, because it is read after the call.
void said(mien_status status, mien_error* const& error) {
  if (status == MIEN_OK) return;
  const std::unique_ptr<mien_error, void (*)(mien_error*)> owned(error, mien_error_free);
  throw Refusal{status, {mien_error_where(error), mien_error_what(error)}};
}

/// Draws the pieces of a picture through the C interface, each by one thread.
class DrawnPieces {
 public:
  DrawnPieces(const mien_scene* scene, const mien_view& view, int32_t depth) : depth_(depth) {
    mien_error* error = nullptr;
    said(mien_drawn_rect(&view, rect_, &error), error);
    if (rect_[2] < 1 || rect_[3] < 1) refuse("view.region", "has no pixel in the picture");
    said(mien_pieces_new(scene, &view, depth, nullptr, &pieces_, &error), error);
  }
  DrawnPieces(const DrawnPieces&) = delete;
  ~DrawnPieces() { mien_pieces_free(pieces_); }

  int width() const { return rect_[2]; }
  int height() const { return rect_[3]; }

  mien::PixelBuffer draw(const mien::PixelRect& piece, int slot, mien::StopWatch& watch) {
    std::vector<std::byte>& bytes = bytes_of(slot);
    mien_pixels pixels;
    mien_pixels_init(&pixels, sizeof pixels);
    pixels.depth = depth_;
    pixels.stride = std::size_t(piece.width) * 4 * channel_bytes(depth_);
    bytes.resize(pixels.bytes = pixels.stride * std::size_t(piece.height));
    pixels.data = bytes.data();
    const int32_t where[] = {rect_[0] + piece.x, rect_[1] + piece.y, piece.width, piece.height};
    const auto stop = [](void* asked) -> int32_t {
      return static_cast<mien::StopWatch*>(asked)->ask();
    };
    mien_error* error = nullptr;
    const mien_status status = mien_pieces_draw(pieces_, where, &pixels, stop, &watch, &error);
    if (status == MIEN_CANCELLED) return mien_error_free(error), mien::PixelBuffer{};
    said(status, error);
    return {pixels.data, pixels.stride, mien::Depth(depth_)};
  }

 private:
  std::vector<std::byte>& bytes_of(int slot) {
    const std::lock_guard lock(mutex_);
    while (int(bytes_.size()) <= slot) bytes_.emplace_back();
    return bytes_[std::size_t(slot)];
  }

  const int32_t depth_;
  int32_t rect_[4] = {};
  mien_pieces* pieces_ = nullptr;
  std::mutex mutex_;
  std::deque<std::vector<std::byte>> bytes_;  ///< by slot
};

int32_t depth_for(const mien_write_options& options, mien::FileType type) {
  if (options.depth < -1 || options.depth > MIEN_F32)
    misuse("options.depth", "is none of -1, MIEN_U8, U16, F32");
  return options.depth >= 0 ? options.depth : int32_t(mien::format_of(type).drawn);
}

double background_opacity(const mien_scene* scene, const mien_view& view) {
  double color[4] = {};
  mien_error* error = nullptr;
  said(mien_scene_background(scene, color, &error), error);
  return view.has_background ? view.background[3] : color[3];
}

}  // namespace

extern "C" {

void mien_write_options_init(mien_write_options* options, size_t size) {
  init_struct(options, size, kDefaults);
}

mien_status mien_check_output_path(const char* path, size_t path_length,
                                   const mien_write_options* options, mien_error** error) {
  return pass("mien_check_output_path", error, [&] {
    must(mien::check_output_path(path_of(path, path_length), options_of(whole_options(options))),
         MIEN_NOT_WRITTEN);
  });
}

mien_status mien_write_image(const mien_pixels* pixels, int32_t width, int32_t height,
                             const char* path, size_t path_length,
                             const mien_write_options* options, mien_error** error) {
  return pass("mien_write_image", error, [&] {
    const std::string file = path_of(path, path_length);
    const Watched watched(options_of(whole_options(options)));
    const mien_pixels p = checked_pixels(pixels, width, height);
    const auto cut = [&](const mien::PixelRect& piece, int, mien::StopWatch&) {
      const std::size_t at =
          std::size_t(piece.y) * p.stride + std::size_t(piece.x) * 4 * channel_bytes(p.depth);
      return mien::PixelBuffer{static_cast<std::byte*>(p.data) + at, p.stride,
                               mien::Depth(p.depth)};
    };
    // Beside an image the pieces are small, and their memory is not asked for.
    write({{width, height, mien::Depth(p.depth), is_opaque(p, width, height)},
           cut,
           std::numeric_limits<std::int64_t>::max()},
          file, watched);
  });
}

mien_status mien_write_picture(const mien_scene* scene, const mien_view* view, const char* path,
                               size_t path_length, const mien_write_options* options,
                               mien_error** error) {
  return pass("mien_write_picture", error, [&] {
    const std::string file = path_of(path, path_length);
    const mien_write_options given = whole_options(options);
    const Watched watched(options_of(given));
    const auto type = must(mien::chosen_type(file, watched.how), MIEN_NOT_WRITTEN);
    mien_view defaults;
    mien_view_init(&defaults, sizeof defaults);
    const mien_view whole = whole_struct(view, defaults, "view");
    const int32_t depth = depth_for(given, type);
    const bool opaque = background_opacity(scene, whole) >= 1;
    DrawnPieces drawn(scene, whole, depth);
    write({{drawn.width(), drawn.height(), mien::Depth(depth), opaque},
           [&](const mien::PixelRect& piece, int slot, mien::StopWatch& watch) {
             return drawn.draw(piece, slot, watch);
           },
           given.memory},
          file, watched);
  });
}
}
