#include <mien/render/image/file_type.h>

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

// The longest side each format's writer takes: libjpeg's JPEG_MAX_DIMENSION, libpng's default user
// limit; the others count in 32 bits.
int longest_side(FileType type) {
  switch (type) {
    case FileType::jpeg:
      return 65'500;
    case FileType::png:
      return 1'000'000;
    default:
      return 1 << 30;
  }
}

}  // namespace

Expected<FileType> file_type(const std::filesystem::path& path) {
  if (path == "-") return FileType::png;
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; });
  if (extension == ".png") return FileType::png;
  if (extension == ".tif" || extension == ".tiff") return FileType::tiff;
  if (extension == ".exr") return FileType::exr;
  if (extension == ".jpg" || extension == ".jpeg") return FileType::jpeg;
  const std::string known = "known are .png .tif .tiff .exr .jpg .jpeg";
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

Expected<Done> check_fits(const Image& image, FileType type) {
  if (image.width < 1 || image.height < 1) return Error{"", "the image has no pixels"};
  if (image.bytes.size() < image.stride() * std::size_t(image.height)) {
    return Error{
        "", fmt::format("the image holds {} bytes, but {} x {} pixels need {}", image.bytes.size(),
                        image.width, image.height, image.stride() * std::size_t(image.height))};
  }
  const int longest = longest_side(type);
  if (std::max(image.width, image.height) > longest) {
    return Error{"", fmt::format("{} holds sides up to {} pixels, not {} x {}", type_name(type),
                                 longest, image.width, image.height)};
  }
  if (type == FileType::jpeg && !image.opaque) {
    return Error{
        "",
        "JPEG cannot hold transparency; give the picture an opaque background or another format"};
  }
  return Done{};
}

}  // namespace mien
