// mien_picture_hashes TABLE FOLDER: draws each line of a table and compares the hash of the picture's bytes, on every
// instruction set that is compiled in. No test framework and no thread: it runs wherever the core does, under
// qemu and in node.
//
//   toon 160 linear 0123456789abcdef 0123456789abcdef
//
// A face of the folder or a code; how many pixels wide; how it is mixed; the hash with fused multiply-adds and without
// them. Ends with 1 if a hash is another, which it prints, and with 2 if the table cannot be read.

#include <mien/composed_face.h>
#include <mien/mien.h>
#include "lib/base/fingerprint.h"
#include "sdf/distance/instruction_sets.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

namespace mien {
namespace {

#ifdef MIEN_SAME_BITS_WITHOUT_FMA
constexpr bool kFusedEverywhere = true;
#else
constexpr bool kFusedEverywhere = false;
#endif

struct Line {
  std::string subject, blend;
  int width = 0;
  std::uint64_t fused = 0, unfused = 0;
};

bool read_line(std::istream& from, Line& line) {
  return bool(from >> line.subject >> std::dec >> line.width >> line.blend >> std::hex >>
              line.fused >> line.unfused);
}

Expected<Face> face_of(const std::string& subject, const std::string& folder) {
  const std::string path = folder + "/" + subject + ".face.json";
  return std::ifstream(path) ? read_face(path) : face_from_code(subject);
}

std::uint64_t hash_of(const Image& image) {
  Fingerprint hash;
  for (std::size_t i = 0; i < image.bytes.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, &image.bytes[i], std::min(sizeof word, image.bytes.size() - i));
    hash.add(word);
  }
  return hash.value();
}

std::uint64_t drawn(const Face& face, const Line& line) {
  const Blend blend = line.blend == "linear" ? Blend::linear : Blend::srgb;
  const Scene scene = scene_from_face(pose_face(face, {.time = 1.25}));
  const auto image =
      render(scene, {.width = line.width, .height = line.width * 9 / 16, .blend = blend});
  return image ? hash_of(*image) : 0;
}

/// Whether all instruction sets draw what the line says. If not, prints the line as it would have to be.
bool holds(const Line& line, const std::string& folder) {
  const auto face = face_of(line.subject, folder);
  if (!face) {
    std::printf("%s: %s\n", face.error().where.c_str(), face.error().what.c_str());
    return false;
  }
  Line found = line;
  for (const auto& set : batch::instruction_sets()) {
    batch::use_instruction_set(set.id);
    const bool fused = set.fused || kFusedEverywhere;
    const std::uint64_t hash = drawn(*face, line), told = fused ? line.fused : line.unfused;
    if (hash != told) (fused ? found.fused : found.unfused) = hash;
  }
  batch::use_instruction_set(0);
  if (found.fused == line.fused && found.unfused == line.unfused) return true;
  std::printf("%s %d %s %016llx %016llx\n", line.subject.c_str(), line.width, line.blend.c_str(),
              (unsigned long long)found.fused, (unsigned long long)found.unfused);
  return false;
}

int main_of(int count, char** words) {
  if (count != 3) return std::fputs("usage: mien_picture_hashes TABLE FOLDER\n", stderr), 2;
  std::ifstream table(words[1]);
  int lines = 0, others = 0;
  for (Line line; read_line(table, line); ++lines) others += !holds(line, words[2]);
  if (lines == 0 || !table.eof()) return std::fprintf(stderr, "%s: no table\n", words[1]), 2;
  for (const auto& set : batch::instruction_sets()) std::printf("%s ", set.name.c_str());
  std::printf("drew %d pictures, %d of other bytes\n", lines, others);
  return others > 0;
}

}  // namespace
}  // namespace mien

int main(int count, char** words) {
  return mien::main_of(count, words);
}
