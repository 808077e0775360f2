# Every JSON file below FROM becomes an entry of TO, a source file.
file(GLOB_RECURSE files RELATIVE ${FROM} ${FROM}/*.json)
list(SORT files)
set(entries "")
foreach(name IN LISTS files)
  file(READ ${FROM}/${name} text)
  # Compilers take raw strings of 64 KiB at least.
  string(APPEND entries "    {\"${name}\", R\"json_(${text})json_\"},\n")
endforeach()
file(WRITE ${TO} "#include \"lib/parts/library/shipped_parts.h\"

namespace mien {
namespace {
constexpr ShippedPart kShippedParts[] = {
${entries}};
}  // namespace

std::span<const ShippedPart> shipped_parts() {
  return kShippedParts;
}

}  // namespace mien
")
