#include "render/image/file_type.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace mien {

std::span<const PictureFormat> picture_formats() {
  // The longest sides: libjpeg's JPEG_MAX_DIMENSION; the others count in 32 bits.
  static const PictureFormat kFormats[] = {
      {FileType::png, "PNG", {".png"}, {"8", "16"}, Depth::u8, 1 << 30, true, PictureWriter::png},
      {FileType::tiff,
       "TIFF",
       {".tif", ".tiff"},
       {"8", "16", "float"},
       Depth::u8,
       1 << 30,
       true,
       PictureWriter::tiff},
      {FileType::exr,
       "EXR",
       {".exr"},
       {"half", "float"},
       Depth::f32,
       1 << 30,
       true,
       PictureWriter::oiio},
      {FileType::jpeg,
       "JPEG",
       {".jpg", ".jpeg"},
       {"8"},
       Depth::u8,
       65'500,
       false,
       PictureWriter::oiio}};
  return kFormats;
}

const PictureFormat& format_of(FileType type) {
  return picture_formats()[std::size_t(type)];
}

std::string known_extensions() {
  std::string text;
  for (const PictureFormat& format : picture_formats())
    for (const std::string_view extension : format.extensions)
      text += fmt::format("{}{}", text.empty() ? "" : " ", extension);
  return text;
}

std::string known_depths() {
  std::string text;
  for (const PictureFormat& format : picture_formats())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", format.name,
                        fmt::join(format.depths, " "));
  return text;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; });
  return extension;
}

Expected<FileType> file_type(const std::filesystem::path& path) {
  if (path == "-") return FileType::png;
  const std::string extension = lower_extension(path);
  for (const PictureFormat& format : picture_formats())
    if (std::find(format.extensions.begin(), format.extensions.end(), extension) !=
        format.extensions.end())
      return format.type;
  const std::string known =
      "known are " + known_extensions() + ", and .svg to `mien render` and write_svg";
  if (extension == ".svg")
    return Error{path.string(),
                 "SVG holds no pixels, so only `mien render` and write_svg write it; known are " +
                     known_extensions()};
  if (extension.empty())
    return Error{path.string(), "its name has no extension, which would tell the format; " + known};
  return Error{path.string(), fmt::format("unknown extension {}; {}", extension, known)};
}

Expected<FileType> chosen_type(const std::filesystem::path& path, const WriteOptions& how) {
  if (path == "-" && how.type && *how.type != FileType::png) {
    return Error{"standard output",
                 std::string("takes PNG only, not ") + format_of(*how.type).name};
  }
  if (how.type) return *how.type;
  return file_type(path);
}

Expected<Done> check_fits(const PictureFrame& frame, FileType type) {
  if (frame.width < 1 || frame.height < 1) return Error{"", "the image has no pixels"};
  const PictureFormat& format = format_of(type);
  const int longest = format.longest_side;
  if (std::max(frame.width, frame.height) > longest) {
    return Error{"", fmt::format("{} holds sides up to {} pixels, not {} x {}", format.name,
                                 longest, frame.width, frame.height)};
  }
  if (!format.transparent && !frame.opaque) {
    return Error{"", fmt::format("{} cannot hold transparency; give the picture an opaque "
                                 "background or another format",
                                 format.name)};
  }
  return Done{};
}

}  // namespace mien
