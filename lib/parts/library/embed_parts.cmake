# Every JSON file below FROM/EDITION becomes an entry of that edition's in TO, a source file.
file(GLOB editions RELATIVE ${FROM} ${FROM}/[A-Z])
list(SORT editions)
set(tables "")
set(rows "")
foreach(edition IN LISTS editions)
  file(GLOB_RECURSE files RELATIVE ${FROM}/${edition} ${FROM}/${edition}/*.json)
  list(SORT files)
  string(APPEND tables "constexpr ShippedPart kParts${edition}[] = {\n")
  foreach(name IN LISTS files)
    file(READ ${FROM}/${edition}/${name} text)
    # Compilers take raw strings of 64 KiB at least. With sv they know the length; clang counts to a million at most.
    string(APPEND tables "    {\"${name}\"sv, R\"json_(${text})json_\"sv},\n")
  endforeach()
  string(APPEND tables "};\n")
  string(APPEND rows "    {'${edition}', kParts${edition}},\n")
endforeach()
file(WRITE ${TO} "#include \"lib/parts/library/shipped_parts.h\"

#include <string_view>

namespace mien {
namespace {
using namespace std::string_view_literals;
${tables}constexpr ShippedFolder kFolders[] = {
${rows}};
}  // namespace

std::span<const ShippedFolder> shipped_folders() {
  return kFolders;
}

}  // namespace mien
")
