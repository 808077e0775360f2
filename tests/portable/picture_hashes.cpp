// mien_picture_hashes TABLE FOLDER [--renew]: draws each line of a table and compares the hash of the picture's bytes, on
// every instruction set that is compiled in. No test framework and no thread: it runs wherever the core does, under
// qemu and in node.
//
// The table holds one version's pictures together on all machines, and promises nothing to the next version: whoever
// draws other pictures, within the promise, renews it (tools/renew_expected).
//
//   toon 160 linear 0123456789abcdef 0123456789abcdef
//
// A face of the folder or a code; how many pixels wide; how it is mixed; the hash with fused multiply-adds and without
// them. Ends with 1 if a hash is another, which it prints, and with 2 if the table cannot be read. The figures of
// nearest_feet are compared, too: they have one hash everywhere, which is written where they are made.

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
#include <vector>

#include "tests/support/shapes/feet_hash.h"

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

void print(std::FILE* to, const Line& line) {
  std::fprintf(to, "%s %d %s %016llx %016llx\n", line.subject.c_str(), line.width,
               line.blend.c_str(), (unsigned long long)line.fused,
               (unsigned long long)line.unfused);
}

/// The line as all instruction sets draw it.
Line as_drawn(const Line& line, const Face& face) {
  Line found = line;
  for (const auto& set : batch::instruction_sets()) {
    batch::use_instruction_set(set.id);
    const bool fused = set.fused || kFusedEverywhere;
    const std::uint64_t hash = drawn(face, line), told = fused ? line.fused : line.unfused;
    if (hash != told) (fused ? found.fused : found.unfused) = hash;
  }
  batch::use_instruction_set(0);
  return found;
}

/// How many instruction sets give feet of other bytes.
int other_feet() {
  int others = 0;
  for (const auto& set : batch::instruction_sets()) {
    batch::use_instruction_set(set.id);
    const std::uint64_t hash = test::feet_hash(test::kHashedFeet);
    if (hash == test::kFeetHash) continue;
    ++others;
    std::printf("feet on %s: %016llx\n", set.name.c_str(), (unsigned long long)hash);
  }
  batch::use_instruction_set(0);
  return others;
}

bool write_table(const char* path, const std::vector<Line>& lines) {
  std::FILE* table = std::fopen(path, "w");
  for (const Line& line : lines)
    if (table) print(table, line);
  return table && std::fclose(table) == 0;
}

int main_of(int count, char** words) {
  const bool renew = count == 4 && std::strcmp(words[3], "--renew") == 0;
  if (count != 3 && !renew)
    return std::fputs("usage: mien_picture_hashes TABLE FOLDER [--renew]\n", stderr), 2;
  std::ifstream table(words[1]);
  std::vector<Line> lines;
  int others = 0;
  for (Line line; read_line(table, line);) {
    const auto face = face_of(line.subject, words[2]);
    if (!face) return std::fprintf(stderr, "%s\n", sentence(face.error()).c_str()), 2;
    lines.push_back(as_drawn(line, *face));
    if (lines.back().fused == line.fused && lines.back().unfused == line.unfused) continue;
    ++others;
    print(stdout, lines.back());
  }
  if (lines.empty() || !table.eof()) return std::fprintf(stderr, "%s: no table\n", words[1]), 2;
  if (renew && !write_table(words[1], lines))
    return std::fprintf(stderr, "%s: cannot be written\n", words[1]), 2;
  for (const auto& set : batch::instruction_sets()) std::printf("%s ", set.name.c_str());
  std::printf("drew %d pictures, %d of other bytes\n", int(lines.size()), others);
  return other_feet() > 0 || (others > 0 && !renew);
}

}  // namespace
}  // namespace mien

int main(int count, char** words) {
  return mien::main_of(count, words);
}
