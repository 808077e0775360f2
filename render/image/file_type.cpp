#include "render/image/file_type.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

// The longest side each format's writer takes: libjpeg's JPEG_MAX_DIMENSION; the others count in 32
// bits.
int longest_side(FileType type) {
  return type == FileType::jpeg ? 65'500 : 1 << 30;
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; });
  return extension;
}

Expected<FileType> file_type(const std::filesystem::path& path) {
  if (path == "-") return FileType::png;
  const std::string extension = lower_extension(path);
  if (extension == ".png") return FileType::png;
  if (extension == ".tif" || extension == ".tiff") return FileType::tiff;
  if (extension == ".exr") return FileType::exr;
  if (extension == ".jpg" || extension == ".jpeg") return FileType::jpeg;
  const std::string known = "known are .png .tif .tiff .exr .jpg .jpeg";
  if (extension == ".svg")
    return Error{path.string(),
                 "SVG holds no pixels, so only `mien render` and write_svg write it; " + known};
  if (extension.empty())
    return Error{path.string(), "its name has no extension that says the format; " + known};
  return Error{path.string(), fmt::format("unknown extension {}; {}", extension, known)};
}

Expected<FileType> chosen_type(const std::filesystem::path& path, const WriteOptions& how) {
  if (path == "-" && how.type && *how.type != FileType::png) {
    return Error{"standard output", std::string("takes PNG only, not ") + type_name(*how.type)};
  }
  if (how.type) return *how.type;
  return file_type(path);
}

const char* type_name(FileType type) {
  switch (type) {
    case FileType::png:
      return "PNG";
    case FileType::tiff:
      return "TIFF";
    case FileType::exr:
      return "EXR";
    case FileType::jpeg:
      return "JPEG";
  }
  return "?";
}

Expected<Done> check_fits(const PictureFrame& frame, FileType type) {
  if (frame.width < 1 || frame.height < 1) return Error{"", "the image has no pixels"};
  const int longest = longest_side(type);
  if (std::max(frame.width, frame.height) > longest) {
    return Error{"", fmt::format("{} holds sides up to {} pixels, not {} x {}", type_name(type),
                                 longest, frame.width, frame.height)};
  }
  if (type == FileType::jpeg && !frame.opaque) {
    return Error{
        "",
        "JPEG cannot hold transparency; give the picture an opaque background or another format"};
  }
  return Done{};
}

}  // namespace mien
