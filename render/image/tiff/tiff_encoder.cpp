#include "render/image/tiff/tiff_encoder.h"
#include <mien/version.h>
#include "render/image/file/system_error.h"
#include "render/image/tiff/icc_profile.h"

#include <libdeflate.h>
#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <new>

namespace mien {
namespace {

constexpr int kTile = 256;  // [px] zip finds little more in larger ones
constexpr std::uint64_t kMostTiles = std::uint64_t(1) << 20;  // a table entry of 16 bytes each
constexpr int kLevel = 6;                                     // of libdeflate's 12
constexpr std::uint64_t kClassicMost = 0xf000'0000;  // bytes of pixels; they rarely grow by zip
constexpr std::uint64_t kPieceBytes = std::uint64_t(4) << 20;

/// The file as libtiff sees it: read, written and sought by descriptor, remembering the first failure.
struct TiffFile {
  FileOutput& out;
  std::int64_t at = 0;
  std::string said;  ///< libtiff's last words

  static TiffFile& of(thandle_t handle) { return *static_cast<TiffFile*>(handle); }

  static tmsize_t read(thandle_t handle, void* to, tmsize_t size) {
    TiffFile& file = of(handle);
    const ssize_t got = ::pread(file.out.descriptor(), to, std::size_t(size), file.at);
    if (got > 0) file.at += got;
    return got;
  }
  static tmsize_t write(thandle_t handle, void* from, tmsize_t size) {
    TiffFile& file = of(handle);
    tmsize_t put = 0;
    while (put < size && !file.out.failure()) {
      const char* data = static_cast<const char*>(from) + put;
      const ssize_t now =
          file.out.stream()
              ? ::write(file.out.descriptor(), data, std::size_t(size - put))
              : ::pwrite(file.out.descriptor(), data, std::size_t(size - put), file.at);
      if (now > 0)
        put += now, file.at += now;
      else if (now == 0 || errno != EINTR)
        file.out.fail(now == 0 ? EIO : errno);
    }
    return put;
  }
  static toff_t seek(thandle_t handle, toff_t offset, int from) {
    TiffFile& file = of(handle);
    const std::int64_t end = std::int64_t(size(handle));
    const std::int64_t at = std::int64_t(offset) + (from == SEEK_SET   ? 0
                                                    : from == SEEK_CUR ? file.at
                                                                       : end);
    if (file.out.stream() && at != file.at) file.out.fail(ESPIPE);
    return toff_t(file.at = at);
  }
  static toff_t size(thandle_t handle) {
    const TiffFile& file = of(handle);
    const off_t end = file.out.stream() ? -1 : ::lseek(file.out.descriptor(), 0, SEEK_END);
    return end < 0 ? toff_t(file.at) : toff_t(end);
  }
  static int close(thandle_t) { return 0; }
  static int hear(TIFF*, void* file, const char*, const char* format, va_list values) {
    char text[300];
    std::vsnprintf(text, sizeof text, format, values);
    static_cast<TiffFile*>(file)->said = text;
    return 1;  // said enough: nothing goes to standard error
  }
};

/// Tiles of one colour are all alike: the packed bytes of the last one serve for the next.
struct TileWorker {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(kLevel);
  std::vector<std::byte> tile, flat_pixel, flat_packed;
  TileWorker() {
    if (!compressor) throw std::bad_alloc();
  }
  TileWorker(const TileWorker&) = delete;
  TileWorker& operator=(const TileWorker&) = delete;
  ~TileWorker() { libdeflate_free_compressor(compressor); }
};

class TiffEncoder final : public PictureEncoder {
 public:
  TiffEncoder(const EncoderRequest& request, int slots, int tile, int columns)
      : frame_(request.frame),
        tile_(tile),
        columns_(columns),
        file_{request.out},
        workers_(std::size_t(slots)) {}
  ~TiffEncoder() override {
    if (tiff_) TIFFCleanup(tiff_);  // without writing: an unfinished file is thrown away
  }

  Expected<Done> open(const WriteOptions& how) {
    TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, TiffFile::hear, &file_);
    TIFFOpenOptionsSetWarningHandlerExtR(options, TiffFile::hear, &file_);
    const std::uint64_t bytes =
        std::uint64_t(frame_.width) * std::uint64_t(frame_.height) * pixel_bytes();
    tiff_ = TIFFClientOpenExt("TIFF", bytes > kClassicMost ? "w8" : "w", &file_, TiffFile::read,
                              TiffFile::write, TiffFile::seek, TiffFile::close, TiffFile::size,
                              nullptr, nullptr, options);
    TIFFOpenOptionsFree(options);
    if (!tiff_ || !set_tags(how)) return failure();
    return Done{};
  }

  int slots() const override { return int(workers_.size()); }
  int pieces() const override { return across() * ((frame_.height + tile_ - 1) / tile_); }
  PixelRect piece(int i) const override {
    const int x = i % across() * columns_, y = i / across() * tile_;
    return {x, y, std::min(columns_, frame_.width - x), std::min(tile_, frame_.height - y)};
  }

  void prepare(int i, int slot, const PixelBuffer& pixels, PreparedPiece& to,
               const AskStop& stop) override {
    auto& worker = workers_[std::size_t(slot)];
    if (!worker) worker = std::make_unique<TileWorker>();
    const PixelRect rect = piece(i);
    to.bytes.clear();
    to.ends.clear();
    for (int x = 0; x < rect.width && !stop(); x += tile_) {
      const auto* from =
          static_cast<const std::byte*>(pixels.data) + source_bytes() * std::size_t(x);
      pack_tile(*worker, from, pixels.stride, std::min(tile_, rect.width - x), rect.height);
      compress_tile(*worker, to.bytes);
      to.ends.push_back(to.bytes.size());
    }
  }

  Expected<Done> put(int i, const PreparedPiece& made) override {
    const PixelRect rect = piece(i);
    const auto first = TIFFComputeTile(tiff_, std::uint32_t(rect.x), std::uint32_t(rect.y), 0, 0);
    std::size_t begin = 0;
    for (std::size_t k = 0; k < made.ends.size(); begin = made.ends[k++]) {
      const auto size = tmsize_t(made.ends[k] - begin);
      auto* const data =
          const_cast<std::byte*>(made.bytes.data() + begin);  // libtiff only reads it
      if (TIFFWriteRawTile(tiff_, first + std::uint32_t(k), data, size) != size ||
          file_.out.failure())
        return failure();
    }
    return Done{};
  }

  Expected<Done> finish() override {
    const bool flushed = TIFFFlush(tiff_) == 1;
    if (!flushed || file_.out.failure()) return failure();
    return Done{};
  }

 private:
  int across() const { return (frame_.width + columns_ - 1) / columns_; }
  std::size_t source_bytes() const { return 4 * bytes_per_channel(frame_.depth); }
  std::size_t pixel_bytes() const {
    return (frame_.opaque ? 3 : 4) * bytes_per_channel(frame_.depth);
  }

  bool set_tags(const WriteOptions& how) {
    constexpr double kUsualDpi = 72;  // TIFF 6.0 asks every RGB file for one
    const bool light = frame_.depth == Depth::f32;
    const auto set = [&](std::uint32_t tag, auto... value) {
      return TIFFSetField(tiff_, tag, value...) == 1;
    };
    const std::vector<std::uint8_t> profile =
        icc_profile(light ? ToneCurve::linear : ToneCurve::srgb);
    const std::uint16_t extra = light ? EXTRASAMPLE_ASSOCALPHA : EXTRASAMPLE_UNASSALPHA;
    return set(TIFFTAG_IMAGEWIDTH, std::uint32_t(frame_.width)) &&
           set(TIFFTAG_IMAGELENGTH, std::uint32_t(frame_.height)) &&
           set(TIFFTAG_BITSPERSAMPLE, int(8 * bytes_per_channel(frame_.depth))) &&
           set(TIFFTAG_SAMPLEFORMAT, light ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT) &&
           set(TIFFTAG_SAMPLESPERPIXEL, frame_.opaque ? 3 : 4) &&
           (frame_.opaque || set(TIFFTAG_EXTRASAMPLES, 1, &extra)) &&
           set(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB) &&
           set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) &&
           set(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) &&
           set(TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE) &&
           set(TIFFTAG_TILEWIDTH, std::uint32_t(tile_)) &&
           set(TIFFTAG_TILELENGTH, std::uint32_t(tile_)) &&
           set(TIFFTAG_XRESOLUTION, how.dpi > 0 ? how.dpi : kUsualDpi) &&
           set(TIFFTAG_YRESOLUTION, how.dpi > 0 ? how.dpi : kUsualDpi) &&
           set(TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH) &&
           set(TIFFTAG_SOFTWARE, "mien " MIEN_VERSION_STRING) &&
           set(TIFFTAG_ICCPROFILE, std::uint32_t(profile.size()), profile.data()) &&
           (how.recipe.empty() || set(TIFFTAG_IMAGEDESCRIPTION, how.recipe.c_str()));
  }

  /// Into worker.tile: the file's channels; the part of an edge tile outside the picture is zero.
  void pack_tile(TileWorker& worker, const std::byte* from, std::size_t stride, int width,
                 int height) const {
    const std::size_t channel = bytes_per_channel(frame_.depth), to_pixel = pixel_bytes();
    const std::size_t row = to_pixel * std::size_t(tile_);
    worker.tile.assign(row * std::size_t(tile_) + channel, std::byte(0));
    for (std::size_t y = 0; y < std::size_t(height); ++y) {
      const std::byte* in = from + stride * y;
      std::byte* out = &worker.tile[row * y];
      if (!frame_.opaque) {
        std::memcpy(out, in, to_pixel * std::size_t(width));
        continue;
      }
      // Four channels for three, the fourth overwritten by the next, and the last one mended.
      for (int x = 0; x < width; ++x, in += 4 * channel, out += to_pixel)
        std::memcpy(out, in, 4 * channel);
      std::memset(out, 0, channel);
    }
    worker.tile.resize(row * std::size_t(tile_));
  }

  void compress_tile(TileWorker& worker, std::vector<std::byte>& to) const {
    const std::vector<std::byte>& tile = worker.tile;
    const std::size_t pixel = pixel_bytes();
    const bool flat = std::memcmp(tile.data(), tile.data() + pixel, tile.size() - pixel) == 0;
    if (flat && worker.flat_pixel.size() == pixel &&
        std::memcmp(worker.flat_pixel.data(), tile.data(), pixel) == 0) {
      to.insert(to.end(), worker.flat_packed.begin(), worker.flat_packed.end());
      return;
    }
    const std::size_t begin = to.size();
    to.resize(begin + libdeflate_zlib_compress_bound(worker.compressor, tile.size()));
    to.resize(begin + libdeflate_zlib_compress(worker.compressor, tile.data(), tile.size(),
                                               to.data() + begin, to.size() - begin));
    if (!flat) return;
    worker.flat_pixel.assign(tile.begin(), tile.begin() + std::ptrdiff_t(pixel));
    worker.flat_packed.assign(to.begin() + std::ptrdiff_t(begin), to.end());
  }

  Error failure() {
    if (file_.out.failure()) return {"", "cannot be written: " + system_error(file_.out.failure())};
    return {"", "the TIFF writer failed: " + (file_.said.empty() ? "no reason given" : file_.said)};
  }

  const PictureFrame frame_;
  const int tile_, columns_;
  TiffFile file_;
  TIFF* tiff_ = nullptr;
  std::vector<std::unique_ptr<TileWorker>> workers_;
};

}  // namespace

MadeEncoder tiff_encoder(const EncoderRequest& request) {
  const PictureFrame& frame = request.frame;
  const auto tiles = [&](int side) {
    return std::uint64_t((frame.width + side - 1) / side) *
           std::uint64_t((frame.height + side - 1) / side);
  };
  int tile = kTile;
  while (tiles(tile) > kMostTiles) tile *= 2;
  const std::uint64_t pixel = 4 * bytes_per_channel(frame.depth);
  const std::uint64_t tables = 32 * tiles(tile);  // offsets and sizes, and what is written of them
  const auto each = [&](int columns) {
    // Pixels, packed tiles, one unpacked; and the compressor's own.
    const std::uint64_t area = std::uint64_t(tile) * std::uint64_t(columns + tile);
    return 2 * pixel * area + (std::uint64_t(1) << 20);
  };
  const int slots = slots_within(request.budget, tables, each(tile));
  if (slots == 0) return too_little_memory(tables + each(tile), request.budget.bytes);
  int columns = tile;
  while (columns < frame.width &&
         2 * pixel * std::uint64_t(tile) * std::uint64_t(columns) <= kPieceBytes &&
         tables + each(2 * columns) * std::uint64_t(slots) <= request.budget.bytes)
    columns *= 2;
  auto encoder = std::make_unique<TiffEncoder>(request, slots, tile, columns);
  if (auto opened = encoder->open(request.how); !opened) return opened.error();
  return std::unique_ptr<PictureEncoder>(std::move(encoder));
}

}  // namespace mien
