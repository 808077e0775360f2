#pragma once
// Reads faces from a file or from memory. docs/face-format.md describes the format.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace mien {

/// Limits of what a face file may ask for. Exceeding one is an error that names it.
struct FaceLimits {
  std::size_t bytes = 64u << 20;    ///< of text
  int nesting = 64;                 ///< of arrays and objects; of features clipped to features
  std::size_t values = 2'000'000;   ///< JSON values of any kind in the text
  std::size_t numbers = 1'000'000;  ///< in the face vector
  std::size_t features = 100'000;   ///< drawn or not, left and right counted
  double magnitude = 1e9;           ///< of any number
};

/// Reads a face. The error's `where` is "FILE:LINE:COLUMN: /json/pointer". Anything odd but harmless,
/// such as an unknown key, is added to `warnings` if given.
MIEN_API Expected<Face> read_face(const std::filesystem::path& path, const FaceLimits& limits = {},
                                  std::vector<Error>* warnings = nullptr);

/// The same from memory; `name` stands for the file's name in errors.
MIEN_API Expected<Face> read_face_text(std::string_view text, std::string_view name = "face",
                                       const FaceLimits& limits = {},
                                       std::vector<Error>* warnings = nullptr);

}  // namespace mien
