#include "tools/mien/output/write_strips.h"
#include "lib/base/memory_ran_out.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "render/render_error.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>

namespace mien::command {
namespace {

/// The rows that pieces still need: those from the present piece's top to the last strip's end.
class Rows {
 public:
  Rows(const StripPicture& picture, int strip) : picture_(picture), strip_(strip) {}

  /// Pieces are asked for in their order in the file, one at a time.
  PixelBuffer piece(const PixelRect& piece, StopWatch& watch) {
    const std::size_t pixel = 4 * bytes_per_channel(picture_.frame.depth),
                      stride = pixel * std::size_t(picture_.frame.width);
    const auto bytes = [&](int rows) { return std::ptrdiff_t(stride) * rows; };
    held_.erase(held_.begin(), held_.begin() + bytes(piece.y - top_));
    top_ = piece.y;
    for (; end_ < piece.y + piece.height;) {
      const auto strip = next([&](double) { return !watch.ask(); });
      if (!strip) error_ = strip.error();
      if (watch.ask() || !strip) return {};
      held_.insert(held_.end(), strip->bytes.begin(), strip->bytes.end());
      end_ += strip->height;
    }
    return {held_.data() + pixel * std::size_t(piece.x), stride, picture_.frame.depth};
  }

  double seconds() const { return seconds_; }
  /// Why a strip was not made.
  const std::optional<Error>& error() const { return error_; }

 private:
  Expected<Image> next(const Progress& progress) {
    const auto began = std::chrono::steady_clock::now();
    auto strip = picture_.strip(end_, std::min(strip_, picture_.frame.height - end_), progress);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return strip;
  }

  const StripPicture& picture_;
  const int strip_;
  int top_ = 0, end_ = 0;
  std::vector<std::byte> held_;
  std::optional<Error> error_;
  double seconds_ = 0;
};

}  // namespace

Expected<PictureStats> write_strips(const StripPicture& picture, const std::string& output,
                                    const PictureOptions& how) {
  if (picture.row_bytes > how.memory)
    return Error{output, too_little_memory(picture.row_bytes, how.memory).what};
  const auto strip =
      int(std::clamp<std::uint64_t>(how.memory / 4 / std::max<std::uint64_t>(picture.row_bytes, 1),
                                    1, std::uint64_t(std::max(picture.rows, 1))));
  // Strips are drawn on all threads, and what is made of them follows in order, on one.
  WriteOptions write = how.write;
  write.threads = {1, {}};
  try {
    Rows rows(picture, strip);
    const auto took = write_pieces(
        {picture.frame,
         [&](const PixelRect& piece, int, StopWatch& watch) { return rows.piece(piece, watch); },
         how.memory - picture.row_bytes * std::uint64_t(strip)},
        output, write, load_encoder);
    if (!took && rows.error()) return Error{output, rows.error()->what};
    if (!took) return took.error();
    return PictureStats{
        .render = {}, .draw = rows.seconds(), .encode = took->encode, .put = took->put};
  } catch (const std::bad_alloc&) {
    return Error{output, std::string(kMemoryRanOut)};
  }
}

}  // namespace mien::command
