#pragma once
// The target of a request, "/A66CB-AA5S0-14.png?size=256&emotion=joy", as a picture of a face; or why it is none.
//
// Any bytes may come. No path is ever a file's name: it is a code or a word, with an ending of kFormats.

#include <mien/expected.h>
#include "tools/mien/cli/arguments.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mien::command {

enum class FaceFormat { png, svg, webp };

struct FaceRequest {
  FaceFormat format = FaceFormat::png;
  RenderArguments arguments;                 ///< posed.face is a right code; no file is named
  std::optional<std::string> width, height;  ///< sides said apart, instead of arguments.size
  bool of_word = false;                      ///< the code is that of a word
  std::string meaning;                       ///< equal for requests that ask for the same picture
};

/// Why a request is answered without a picture: HTTP's code, and a sentence in the words of the request.
struct Refusal {
  int code;
  Error error;
};

struct RequestLimits {
  int most_side = 1024;  ///< [px]
};
inline constexpr std::size_t kLongestTarget = 2048;  ///< [bytes]
inline constexpr int kDefaultFaceSide = 256;         ///< [px] of the longer side

std::variant<FaceRequest, Refusal> read_face_request(std::string_view target,
                                                     const RequestLimits& limits);

/// An error about options as one about the keys of a request: "--size 0x5" is "size=0x5" there.
Error in_request_words(Error error);

/// All keys, as they are written.
std::vector<std::string_view> request_keys();

/// One side of a picture, "width" or "height".
Expected<int> read_side(std::string_view key, std::string_view text, int most);

}  // namespace mien::command
