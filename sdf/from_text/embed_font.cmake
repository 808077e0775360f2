# FROM, a file, becomes TO, a source file with its bytes.
file(READ ${FROM} bytes HEX)
string(LENGTH "${bytes}" digits)
math(EXPR size "${digits} / 2")
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(WRITE ${TO} "#include <cstddef>

namespace mien {
extern const unsigned char kShippedFont[];
extern const std::size_t kShippedFontSize;
const unsigned char kShippedFont[] = {${bytes}};
const std::size_t kShippedFontSize = ${size};
}  // namespace mien
")
