#include <mien/recipe.h>
#include <mien/relatives.h>
#include "lib/parts/code/appearance.h"
#include "lib/parts/code/code_fields.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/library/part_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr int kMostStep = 1023;

using Fields = CodeFields;

/// The fields of a code's face in an edition; the error says what of the face that edition has not.
Expected<Fields> fields_of(const FaceCode& code, char edition) {
  auto recipe = recipe_from_code(code);
  if (!recipe) return recipe.error();
  if (code.edition == edition) return code_fields(*recipe);
  recipe->edition = edition;
  if (const auto wrong = wrong_in(*PartLibrary::shipped(edition), *recipe))
    return Error{"code " + face_code_text(code),
                 fmt::format("its face is not of edition {}: {}", edition, wrong->what)};
  return code_fields(*recipe);
}

/// Relatives of people of two editions are of the newer.
Expected<char> edition_of(const FaceCode& one, const FaceCode& other) {
  for (const FaceCode* code : {&one, &other})
    if (const auto known = recipe_from_code(*code); !known) return known.error();
  return std::max(one.edition, other.edition);
}

FaceCode seed_in(char edition, std::uint64_t seed) {
  return {.edition = edition, .seed = seed & ((std::uint64_t{1} << FaceCode::kSeedBits) - 1)};
}

bool is_number(int field, char edition) {
  const auto& numbers = PartLibrary::shipped(edition)->numbers();
  return std::any_of(numbers.begin(), numbers.end(),
                     [&](const LibraryNumber& number) { return number.number == field; });
}

int stepped(double step) {
  return int(std::floor(std::clamp(step, 0.0, double(kMostStep)) + 0.5));
}

}  // namespace

Expected<FaceCode> code_near(const FaceCode& code, double by, std::uint64_t seed) {
  const auto own = fields_of(code, code.edition);
  if (!own) return own.error();
  const KeyedChance chance(seed);
  const Fields other = code_fields(recipe_from_code(seed_in(code.edition, seed)).value());
  Fields made = *own;
  for (auto& [field, value] : made) {
    const auto question = std::uint64_t(field);
    if (is_number(field, code.edition))
      value = stepped(value + by * chance.bell(question) * kMostStep);
    else if (chance.share(question) < 0.5 * by)
      value = other.at(field);
  }
  return code_of_fields(made, code.seed, code.edition);
}

Expected<FaceCode> code_between(const FaceCode& from, const FaceCode& to, double at) {
  const Expected<char> edition = edition_of(from, to);
  if (!edition) return edition.error();
  const auto a = fields_of(from, *edition), b = fields_of(to, *edition);
  if (!a) return a.error();
  if (!b) return b.error();
  const KeyedChance chance(from.seed ^ to.seed);
  Fields made = *a;
  for (auto& [field, value] : made) {
    if (is_number(field, *edition))
      value = stepped(value + at * (b->at(field) - value));
    else if (at > 0.0 && chance.share(std::uint64_t(field)) <= at)
      value = b->at(field);
  }
  return code_of_fields(made, at < 1.0 ? from.seed : to.seed, *edition);
}

Expected<FaceCode> code_of_child(const FaceCode& one, const FaceCode& other, std::uint64_t seed) {
  constexpr double kBeside = 0.05;  // of a number's range
  const Expected<char> edition = edition_of(one, other);
  if (!edition) return edition.error();
  const auto a = fields_of(one, *edition), b = fields_of(other, *edition);
  if (!a) return a.error();
  if (!b) return b.error();
  const KeyedChance chance(seed);
  const PartLibrary& library = *PartLibrary::shipped(*edition);
  const LibraryNumber& age = *library.find_number("age");
  FaceCode child = seed_in(*edition, seed);
  child.held.push_back(
      {age.number, stepped((5 + 10 * chance.share(1) - age.lo) / (age.hi - age.lo) * kMostStep)});
  // Shapes and colours are inherited; hair, clothes and what one puts on are the child's own.
  for (const char* name :
       {"head", "ears", "eyes", "nose", "mouth", "brows", "hair_color", "iris"}) {
    const int field = library.find_family(name)->number;
    child.held.push_back({field, (chance.share(std::uint64_t(field)) < 0.5 ? *a : *b).at(field)});
  }
  for (const char* name : {"skin.tone", "skin.undertone", "temple", "cheek", "eye.x", "eye.tilt",
                           "nose.width", "lips", "lips.upper", "brow.arch"}) {
    const int field = library.find_number(name)->number;
    const double share = chance.share(std::uint64_t(field));
    const double mean = a->at(field) + share * (b->at(field) - a->at(field));
    child.held.push_back(
        {field, stepped(mean + kBeside * kMostStep * chance.bell(std::uint64_t(field)))});
  }
  return child;
}

Expected<double> difference(const FaceCode& one, const FaceCode& other) {
  const auto a = recipe_from_code(one), b = recipe_from_code(other);
  if (!a) return a.error();
  if (!b) return b.error();
  return difference(appearance_of(*a), appearance_of(*b));
}

}  // namespace mien
