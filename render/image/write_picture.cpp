// Images that are there, and pictures that are drawn on the way.

#include <mien/piece_drawer.h>
#include "lib/base/memory_ran_out.h"
#include "render/image/file_type.h"
#include "render/image/ordered_pipeline.h"
#include "render/image/write_pieces.h"
#include "render/render_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <optional>
#include <vector>

namespace mien {
namespace fs = std::filesystem;

namespace {

Error unexpected(const fs::path& path, const std::exception& failure) {
  const bool memory = dynamic_cast<const std::bad_alloc*>(&failure);
  return {
      path == "-" ? "standard output" : path.string(),
      memory ? std::string(kMemoryRanOut) : std::string("cannot be written: ") + failure.what()};
}

PixelBuffer cut(const Image& image, const PixelRect& piece) {
  const std::size_t offset = image.stride() * std::size_t(piece.y) +
                             4 * bytes_per_channel(image.depth) * std::size_t(piece.x);
  // Encoders only read.
  return {const_cast<std::byte*>(image.bytes.data()) + offset, image.stride(), image.depth};
}

/// Draws pieces of a view, each by one thread.
class DrawnPieces {
 public:
  DrawnPieces(const Scene& scene, const View& view, Depth depth, const RenderLimits& limits)
      : scene_(scene), view_(view), rect_(drawn_rect(view)), depth_(depth), limits_(limits) {}

  PixelBuffer draw(const PixelRect& piece, int slot, StopWatch& watch) {
    std::vector<std::byte>& pixels = pixels_of(slot);
    PixelBuffer buffer{nullptr, std::size_t(piece.width) * 4 * bytes_per_channel(depth_), depth_};
    pixels.resize(buffer.stride * std::size_t(piece.height));
    buffer.data = pixels.data();
    RenderStats stats;
    const auto began = std::chrono::steady_clock::now();
    std::call_once(made_, [&] {
      auto drawer = PieceDrawer::of(scene_, view_, depth_, limits_, [&] { return watch.ask(); });
      if (drawer)
        drawer_.emplace(*std::move(drawer));
      else
        fail(drawer.error());
    });
    if (!drawer_) return {};
    const auto done = drawer_->draw(
        buffer, {rect_.x + piece.x, rect_.y + piece.y, piece.width, piece.height},
        [&] { return watch.ask(); }, &stats);
    if (!done) fail(done.error());
    const bool whole = bool(done);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    const std::lock_guard lock(mutex_);
    stats_.render.add(stats);
    stats_.draw += took.count();
    return whole ? buffer : PixelBuffer{};
  }

  const PictureStats& stats() const { return stats_; }
  /// Why pieces were not drawn, where it was not the caller.
  const std::optional<Error>& error() const { return error_; }

 private:
  void fail(const Error& error) {
    const std::lock_guard lock(mutex_);
    if (!error_ && error.what != kCancelled) error_ = error;
  }
  std::vector<std::byte>& pixels_of(int slot) {
    const std::lock_guard lock(mutex_);
    while (int(pixels_.size()) <= slot) pixels_.emplace_back();
    return pixels_[std::size_t(slot)];
  }

  const Scene& scene_;
  const View& view_;
  const PixelRect rect_;
  const Depth depth_;
  const RenderLimits limits_;
  std::optional<Error> error_;
  std::once_flag made_;
  std::optional<PieceDrawer> drawer_;
  std::mutex mutex_;
  std::deque<std::vector<std::byte>> pixels_;  ///< by slot
  PictureStats stats_;
};

Depth drawn_depth(const PictureOptions& how, FileType type) {
  return how.depth.value_or(format_of(type).drawn);
}

}  // namespace

Expected<Done> write_image_by(const MakeEncoder& make, const Image& image, const fs::path& path,
                              const WriteOptions& how) {
  try {
    const PictureFrame frame{image.width, image.height, image.depth, image.opaque};
    if (image.width > 0 && image.height > 0 &&
        image.bytes.size() < image.stride() * std::size_t(image.height)) {
      return Error{
          path.string(),
          fmt::format("the image holds {} bytes, but {} x {} pixels need {}", image.bytes.size(),
                      image.width, image.height, image.stride() * std::size_t(image.height))};
    }
    // Beside an image the pieces are small, and their memory is not asked for.
    const auto took = write_pieces(
        {frame, [&](const PixelRect& piece, int, StopWatch&) { return cut(image, piece); },
         std::numeric_limits<std::int64_t>::max()},
        path, how, make);
    if (!took) return took.error();
    return Done{};
  } catch (const std::exception& failure) {
    return unexpected(path, failure);
  }
}

Expected<PictureStats> write_picture_by(const MakeEncoder& make, const Scene& scene,
                                        const View& view, const fs::path& path,
                                        const PictureOptions& how) {
  try {
    const auto type = chosen_type(path, how.write);
    if (!type) return type.error();
    if (std::min(view.width, view.height) < 1 ||
        std::max(view.width, view.height) > View::kMaxSide) {
      return Error{path.string(), fmt::format("a picture's sides are 1 to {} pixels, not {} x {}",
                                              View::kMaxSide, view.width, view.height)};
    }
    const PixelRect rect = drawn_rect(view);
    const bool opaque = view.background.value_or(scene.background()).a >= 1.0;
    DrawnPieces drawn(scene, view, drawn_depth(how, *type), how.limits);
    const auto took = write_pieces({{rect.width, rect.height, drawn_depth(how, *type), opaque},
                                    [&](const PixelRect& piece, int slot, StopWatch& watch) {
                                      return drawn.draw(piece, slot, watch);
                                    },
                                    how.memory},
                                   path, how.write, make);
    if (drawn.error())
      return Error{path == "-" ? "standard output" : path.string(), drawn.error()->what};
    if (!took) return took.error();
    PictureStats stats = drawn.stats();
    stats.encode = took->encode;
    stats.put = took->put;
    return stats;
  } catch (const std::exception& failure) {
    return unexpected(path, failure);
  }
}

}  // namespace mien
