#pragma once
// Which kind of file a path asks for.

#include <mien/write.h>

#include <filesystem>
#include <string>

namespace mien {

/// With its dot, in lower case; empty if there is none.
std::string lower_extension(const std::filesystem::path& path);

/// By the extension, in any case: .png .tif .tiff .exr .jpg .jpeg; "-" is a PNG. Else an error that
/// lists them.
Expected<FileType> file_type(const std::filesystem::path& path);

/// The type that `how` gives, else the path's; standard output takes PNG only.
Expected<FileType> chosen_type(const std::filesystem::path& path, const WriteOptions& how);

/// "PNG", "TIFF", … as people write it.
const char* type_name(FileType type);

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
