# Every JSON file below FROM becomes an entry of TO, a source file.
file(GLOB_RECURSE files RELATIVE ${FROM} ${FROM}/*.json)
list(SORT files)
set(rows "")
foreach(name IN LISTS files)
  file(READ ${FROM}/${name} text)
  # With sv compilers know the length; clang counts to a million at most.
  string(APPEND rows "    {\"${name}\"sv, R\"json_(${text})json_\"sv},\n")
endforeach()
file(WRITE ${TO} "#include \"lib/parts/library/shipped_parts.h\"

#include <string_view>

// A compiler must take strings of 64 KiB; all we build with take longer ones, and clang points that out.
#ifdef __clang__
#pragma clang diagnostic ignored \"-Woverlength-strings\"
#endif

namespace mien {
namespace {
using namespace std::string_view_literals;
constexpr ShippedPart kParts[] = {
${rows}};
}  // namespace

std::span<const ShippedPart> shipped_parts() {
  return kParts;
}

}  // namespace mien
")
