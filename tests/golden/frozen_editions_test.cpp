// Frozen editions never change: their faces and pictures have the hashes that parts/EDITION.lock holds.
// MIEN_LOCK_EDITION=A prints those of an edition instead, as tools/freeze_edition asks.

#include <mien/composed_face.h>
#include <mien/mien.h>
#include "lib/base/fingerprint.h"
#include "lib/parts/compose/compose.h"
#include "lib/parts/compose/composed_text.h"
#include "lib/parts/library/edition_files.h"
#include "lib/parts/recipe/sample.h"
#include "sdf/distance/instruction_sets.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

#include "tests/support/effort.h"
#include "tests/support/rendered.h"

namespace mien {
namespace {

/// So many people, and the first of them, at which a sanitizer looks.
constexpr int kFaces = 10000, kFewFaces = kFaces / 16, kPictures = 500,
              kFewPictures = kPictures / 16;
constexpr int kComposedEach = 10, kSide = 64;

using HashAt = std::map<int, std::uint64_t>;  ///< by how many people

Recipe frozen_person(char edition, int i) {
  const FaceCode code{.edition = edition, .seed = seed_from_word(fmt::format("frozen/{}", i))};
  return sampled_recipe(*PartLibrary::shipped(edition), code);
}

void add_word(Fingerprint& to, std::string_view text) {
  to.add(int(text.size()));
  for (const char c : text) to.add(int(c));
}

/// Of parts and numbers, and each tenth composed.
HashAt face_hashes(char edition, int few, int all) {
  Fingerprint bits;
  HashAt hashes;
  for (int i = 0; i < all; ++i) {
    const Recipe recipe = frozen_person(edition, i);
    for (const auto& [family, part] : recipe.parts) add_word(bits, family), add_word(bits, part);
    for (const auto& [name, value] : recipe.numbers) add_word(bits, name), bits.add(value);
    if (i % kComposedEach == 0)
      add_word(bits, composed_text(composed_face(ChosenParts::read(recipe).value()).value()));
    if (i + 1 == few || i + 1 == all) hashes[i + 1] = bits.value();
  }
  return hashes;
}

/// In each style by turns; of those in clay, which take twenty times as long, one in five.
std::string style_of(const std::vector<std::string>& styles, int i) {
  const int count = int(styles.size());
  const std::string& style = styles[std::size_t(i % count)];
  return style == "clay" && i / count % 5 != 0 ? styles[0] : style;
}

/// Of pixels.
HashAt picture_hashes(char edition, int few, int all) {
  Fingerprint bits;
  HashAt hashes;
  const std::vector<std::string> styles = part_styles(edition);
  for (int i = 0; i < all; ++i) {
    Recipe recipe = frozen_person(edition, i);
    recipe.style = style_of(styles, i);
    const Scene scene = scene_from_face(face_from_recipe(recipe).value());
    for (const std::byte byte : test::rendered(scene, {.width = kSide, .height = kSide}).bytes)
      bits.add(std::to_integer<int>(byte));
    if (i + 1 == few || i + 1 == all) hashes[i + 1] = bits.value();
  }
  return hashes;
}

/// "faces 10000 0x1f…" of a lock, by "faces 10000".
std::map<std::string, std::string> lines_of_lock(char edition) {
  std::ifstream file(fmt::format("{}/parts/{}.lock", MIEN_SOURCE_DIR, edition));
  std::map<std::string, std::string> lines;
  for (std::string line; std::getline(file, line);)
    if (const std::size_t hash = line.rfind(" 0x"); hash != std::string::npos && line[0] != '#')
      lines[line.substr(0, hash)] = line.substr(hash + 1);
  return lines;
}

/// Lines of a lock. `all`: every one that it is to hold; else as many as take seconds, all pictures on the best
/// instruction set alone.
std::map<std::string, std::string> drawn_lines(char edition, bool all) {
  std::map<std::string, std::string> lines;
  const auto add = [&](const std::string& kind, const HashAt& hashes) {
    for (const auto& [count, hash] : hashes)
      lines[fmt::format("{} {}", kind, count)] = fmt::format("0x{:x}", hash);
  };
  add("faces", face_hashes(edition, kFewFaces, test::times(kFaces)));
  int pictures = test::times(kPictures);
  for (const auto& set : batch::instruction_sets()) {
    const std::string kind = set.fused ? "pictures fused" : "pictures unfused";
    if (lines.contains(fmt::format("{} {}", kind, kFewPictures))) continue;
    batch::use_instruction_set(set.id);
    add(kind, picture_hashes(edition, kFewPictures, pictures));
    if (!all) pictures = kFewPictures;
  }
  batch::use_instruction_set(0);
  return lines;
}

TEST(FrozenEditions, AreAsTheirLocksSay) {
  if (const char* asked = std::getenv("MIEN_LOCK_EDITION")) {
    ASSERT_TRUE(read_edition(asked)) << read_edition(asked).error().what;
    for (const auto& [name, hash] : drawn_lines(asked[0], true))
      std::cout << "lock: " << name << " " << hash << "\n";
    return;
  }
  for (const char edition : editions()) {
    if (edition == kTrialEdition) continue;
    const auto locked = lines_of_lock(edition);
    for (const auto& [name, hash] : drawn_lines(edition, false)) {
      ASSERT_TRUE(locked.contains(name)) << "parts/" << edition << ".lock has no " << name;
      EXPECT_EQ(hash, locked.at(name)) << "edition " << edition << ", " << name;
    }
  }
}

/// Every two frozen editions: of a later one, only faces with a part that the earlier has not are others.
TEST(FrozenEditions, KeepTheFacesOfThoseBefore) {
  for (std::size_t later = 1; later < editions().size(); ++later) {
    const char a = editions()[later - 1], b = editions()[later];
    const auto files = edition_files(shipped_folders().subspan(later, 1), b);
    const auto is_topology = [](const ShippedPart& part) { return part.name == kTopologyFile; };
    if (b == kTrialEdition || std::ranges::any_of(files, is_topology)) continue;  // begins anew
    int changed = 0;
    for (int i = 0; i < test::times(2000); ++i) {
      const Recipe before = frozen_person(a, i), after = frozen_person(b, i);
      for (const auto& [name, value] : before.numbers) EXPECT_EQ(after.numbers.at(name), value);
      if (after.parts == before.parts) continue;
      EXPECT_TRUE(wrong_in(*PartLibrary::shipped(a), Recipe{.parts = after.parts}))
          << i << " changed without a new part";
      ++changed;
    }
    std::cout << "of 2000 faces of edition " << b << " " << changed << " have a part that " << a
              << " has not\n";
  }
}

TEST(FrozenEditions, HashesTellPeopleApart) {
  const HashAt faces = face_hashes(kTrialEdition, 2, 4),
               pictures = picture_hashes(kTrialEdition, 2, 4);
  EXPECT_EQ(faces, face_hashes(kTrialEdition, 2, 4));
  EXPECT_EQ(pictures, picture_hashes(kTrialEdition, 2, 4));
  EXPECT_EQ(faces.at(2), face_hashes(kTrialEdition, 1, 2).at(2));
  EXPECT_NE(faces.at(2), faces.at(4));
  EXPECT_NE(pictures.at(2), pictures.at(4));
}

}  // namespace
}  // namespace mien
