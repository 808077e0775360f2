#pragma once
// The formats of picture files, as one table, and which of them a path asks for.

#include <mien/write.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

enum class PictureWriter { png, tiff, oiio };

struct PictureFormat {
  FileType type;
  const char* name;                          ///< as people write it
  std::vector<std::string_view> extensions;  ///< with their dots
  std::vector<std::string_view> depths;      ///< the words of --depth; the first is the default
  Depth drawn;                               ///< unless something else is asked for
  int longest_side;                          ///< [px] that its writer takes
  bool transparent;
  PictureWriter writer;
};

/// In the order of FileType.
std::span<const PictureFormat> picture_formats();
const PictureFormat& format_of(FileType type);

/// ".png .tif .tiff …": of all formats.
std::string known_extensions();
/// "PNG 8 16, TIFF 8 16 float, …": of all formats.
std::string known_depths();

/// With its dot, in lower case; empty if there is none.
std::string lower_extension(const std::filesystem::path& path);

/// By the extension, in any case; "-" is a PNG. Else an error that lists the known ones.
Expected<FileType> file_type(const std::filesystem::path& path);

/// The type that `how` gives, else the path's; standard output takes PNG only.
Expected<FileType> chosen_type(const std::filesystem::path& path, const WriteOptions& how);

/// A picture that is to be written, but for its pixels.
struct PictureFrame {
  int width = 0, height = 0;
  Depth depth = Depth::u8;  ///< of the pixels there are
  bool opaque = true;
};

/// Whether a picture fits the type: sides within what it can hold, and no transparency where it knows
/// none.
Expected<Done> check_fits(const PictureFrame& frame, FileType type);

}  // namespace mien
