#include "tests/support/pictures/read_film.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <webp/demux.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/scratch_folder.h"

namespace mien::test {
namespace {

using Pixels = std::vector<std::uint8_t>;

/// Frames are laid on a canvas, part by part.
struct FilmCanvas {
  int width, height;
  Pixels pixels = Pixels(4 * std::size_t(width) * std::size_t(height));
  std::uint8_t* at(int x, int y) {
    return &pixels[4 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
  }
};

void lay_gif_frame(const GifFileType& gif, int index, FilmCanvas& canvas, ReadFilm& film) {
  const SavedImage& image = gif.SavedImages[index];
  GraphicsControlBlock control{};
  EXPECT_EQ(DGifSavedExtensionToGCB(const_cast<GifFileType*>(&gif), index, &control), GIF_OK);
  const auto& part = image.ImageDesc;
  const ColorMapObject* map = part.ColorMap ? part.ColorMap : gif.SColorMap;
  for (int y = 0; y < part.Height; ++y)
    for (int x = 0; x < part.Width; ++x) {
      const int place = image.RasterBits[y * part.Width + x];
      if (place == control.TransparentColor) continue;
      const GifColorType color = map->Colors[place];
      const std::uint8_t rgba[4] = {color.Red, color.Green, color.Blue, 255};
      std::memcpy(canvas.at(part.Left + x, part.Top + y), rgba, 4);
    }
  film.frames.push_back({control.DelayTime / 100.0, canvas.pixels});
  for (int y = 0; control.DisposalMode == DISPOSE_BACKGROUND && y < part.Height; ++y)
    std::memset(canvas.at(part.Left, part.Top + y), 0, 4 * std::size_t(part.Width));
}

ReadFilm read_gif(const std::filesystem::path& path) {
  int failed = 0;
  GifFileType* const gif = DGifOpenFileName(path.c_str(), &failed);
  if (!gif || DGifSlurp(gif) != GIF_OK) {
    ADD_FAILURE() << path << " is no GIF: " << GifErrorString(gif ? gif->Error : failed);
    return {};
  }
  ReadFilm film{gif->SWidth, gif->SHeight, {}};
  FilmCanvas canvas{film.width, film.height};
  for (int i = 0; i < gif->ImageCount; ++i) lay_gif_frame(*gif, i, canvas, film);
  const std::string bytes = read_text(path);
  film.endless = bytes.find(std::string("NETSCAPE2.0\3\1\0\0\0", 16)) != std::string::npos;
  DGifCloseFile(gif, &failed);
  return film;
}

ReadFilm read_webp(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  WebPAnimDecoder* const decoder = WebPAnimDecoderNew(&data, nullptr);
  WebPAnimInfo info{};
  if (!decoder || !WebPAnimDecoderGetInfo(decoder, &info)) {
    ADD_FAILURE() << path << " is no WebP";
    return {};
  }
  ReadFilm film{int(info.canvas_width), int(info.canvas_height), {}, info.loop_count == 0};
  int before = 0, end = 0;
  std::uint8_t* shown = nullptr;
  while (WebPAnimDecoderHasMoreFrames(decoder) && WebPAnimDecoderGetNext(decoder, &shown, &end)) {
    film.frames.push_back({(end - before) / 1000.0,
                           Pixels(shown, shown + 4 * info.canvas_width * info.canvas_height)});
    before = end;
  }
  EXPECT_EQ(film.frames.size(), info.frame_count);
  WebPAnimDecoderDelete(decoder);
  return film;
}

unsigned big_endian(const std::string& bytes, std::size_t at, std::size_t count = 4) {
  unsigned n = 0;
  for (std::size_t i = 0; i < count; ++i) n = n << 8 | std::uint8_t(bytes[at + i]);
  return n;
}
std::string four_bytes(std::size_t n) {
  return {char(n >> 24), char(n >> 16), char(n >> 8), char(n)};
}
std::string png_chunk(const std::string& name, const std::string& data) {
  const std::string named = name + data;
  const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(named.data()), unsigned(named.size()));
  return four_bytes(data.size()) + named + four_bytes(sum);
}

/// A frame of an APNG, made a picture of its own.
struct ApngFrame {
  std::string control, data;
};

void lay_apng_frame(const ApngFrame& frame, std::string header, FilmCanvas& canvas,
                    ReadFilm& film) {
  const ScratchFolder folder;
  header.replace(0, 8, frame.control.substr(4, 8));
  write_text(folder / "a.png", "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) +
                                   png_chunk("IDAT", frame.data) + png_chunk("IEND", ""));
  const Read png = read(folder / "a.png");
  const int left = int(big_endian(frame.control, 12)), top = int(big_endian(frame.control, 16));
  const std::size_t channels = std::size_t(png.spec.nchannels);
  ASSERT_LE(left + png.spec.width, canvas.width);
  ASSERT_LE(top + png.spec.height, canvas.height);
  for (int y = 0; y < png.spec.height; ++y)
    for (int x = 0; x < png.spec.width; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        canvas.at(left + x, top + y)[c] =
            c >= channels
                ? 255
                : std::uint8_t(std::lround(
                      255 *
                      png.channels[(std::size_t(y) * std::size_t(png.spec.width) + std::size_t(x)) *
                                       channels +
                                   c]));
  EXPECT_EQ(big_endian(frame.control, 24, 2), 0u) << "stays, and takes the place of what was there";
  film.frames.push_back(
      {double(big_endian(frame.control, 20, 2)) / big_endian(frame.control, 22, 2), canvas.pixels});
}

ReadFilm read_apng(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  std::vector<ApngFrame> frames;
  std::string header, control;
  unsigned numbered = 0;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const unsigned length = big_endian(bytes, at);
    const std::string name = bytes.substr(at + 4, 4), data = bytes.substr(at + 8, length);
    EXPECT_EQ(bytes.substr(at, 12 + length), png_chunk(name, data)) << name;
    if (name == "IHDR") header = data;
    if (name == "acTL") control = data;
    if (name == "fcTL" || name == "fdAT") {
      EXPECT_EQ(big_endian(data, 0), numbered++);
    }
    if (name == "fcTL") frames.push_back({data, ""});
    if (name == "IDAT" && !frames.empty()) frames.back().data += data;
    if (name == "fdAT") frames.back().data += data.substr(4);
    at += 12 + length;
  }
  if (header.size() != 13 || control.size() != 8) {
    ADD_FAILURE() << path << " is no APNG";
    return {};
  }
  ReadFilm film{
      int(big_endian(header, 0)), int(big_endian(header, 4)), {}, big_endian(control, 4) == 0};
  EXPECT_EQ(big_endian(control, 0), frames.size());
  FilmCanvas canvas{film.width, film.height};
  for (const ApngFrame& frame : frames) lay_apng_frame(frame, header, canvas, film);
  return film;
}

}  // namespace

double ReadFilm::seconds() const {
  double sum = 0;
  for (const ShownFrame& frame : frames) sum += frame.seconds;
  return sum;
}

const ShownFrame& ReadFilm::at(double moment) const {
  double end = 0;
  for (const ShownFrame& frame : frames)
    if (end += frame.seconds; moment < end) return frame;
  return frames.back();
}

ReadFilm read_film(const std::filesystem::path& path) {
  return path.extension() == ".gif"    ? read_gif(path)
         : path.extension() == ".webp" ? read_webp(path)
                                       : read_apng(path);
}

}  // namespace mien::test
