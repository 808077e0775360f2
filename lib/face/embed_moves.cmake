# The text of FROM becomes a constant of TO, a source file.
file(READ ${FROM} text)
# Compilers take raw strings of 64 KiB at least.
file(WRITE ${TO} "#include \"lib/face/standard_moves.h\"

namespace mien {

std::string_view standard_moves() {
  return R\"json_(${text})json_\";
}

}  // namespace mien
")
