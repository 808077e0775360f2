#pragma once
// Reads faces from a file or from memory. docs/face-format.md describes the format.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face.h>
#include <mien/face_limits.h>
#include <mien/letters.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace mien {

/// Reads a face. The error's `where` is "FILE:LINE:COLUMN: /json/pointer". Anything odd but harmless,
/// such as an unknown key, is added to `warnings` if given. `letters`: what texts in the face are made with.
MIEN_API Expected<Face> read_face(const std::filesystem::path& path, const FaceLimits& limits = {},
                                  std::vector<Error>* warnings = nullptr,
                                  const Letters& letters = {});

/// The same from memory; `name` stands for the file's name in errors.
MIEN_API Expected<Face> read_face_text(std::string_view text, std::string_view name = "face",
                                       const FaceLimits& limits = {},
                                       std::vector<Error>* warnings = nullptr,
                                       const Letters& letters = {});

}  // namespace mien
