#include <mien/recipe.h>
#include <mien/relatives.h>
#include "lib/base/memory_ran_out.h"
#include "lib/parts/code/appearance.h"
#include "lib/parts/code/code_fields.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/library/part_library.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr int kMostStep = 1023;

using Fields = CodeFields;

Expected<Fields> fields_of(const FaceCode& code) {
  const auto recipe = recipe_from_code(code);
  if (!recipe) return recipe.error();
  return code_fields(*recipe);
}

FaceCode code_of_seed(std::uint64_t seed) {
  return {.seed = seed & ((std::uint64_t{1} << FaceCode::kSeedBits) - 1), .held = {}};
}

bool is_number(int field) {
  const auto& numbers = PartLibrary::shipped().numbers();
  return std::any_of(numbers.begin(), numbers.end(),
                     [&](const LibraryNumber& number) { return number.number == field; });
}

int stepped(double step) {
  return int(std::floor(std::clamp(step, 0.0, double(kMostStep)) + 0.5));
}

}  // namespace

Expected<FaceCode> code_near(const FaceCode& code, double by, std::uint64_t seed) try {
  const auto own = fields_of(code);
  if (!own) return own.error();
  const KeyedChance chance(seed);
  const Fields other = code_fields(recipe_from_seed(seed));
  Fields made = *own;
  for (auto& [field, value] : made) {
    const auto question = std::uint64_t(field);
    if (is_number(field))
      value = stepped(value + by * chance.bell(question) * kMostStep);
    else if (chance.share(question) < 0.5 * by)
      value = other.at(field);
  }
  return code_of_fields(made, code.seed);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<FaceCode> code_between(const FaceCode& from, const FaceCode& to, double at) try {
  const auto a = fields_of(from), b = fields_of(to);
  if (!a) return a.error();
  if (!b) return b.error();
  const KeyedChance chance(from.seed ^ to.seed);
  Fields made = *a;
  for (auto& [field, value] : made) {
    if (is_number(field))
      value = stepped(value + at * (b->at(field) - value));
    else if (at > 0.0 && chance.share(std::uint64_t(field)) <= at)
      value = b->at(field);
  }
  return code_of_fields(made, at < 1.0 ? from.seed : to.seed);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<FaceCode> code_of_child(const FaceCode& one, const FaceCode& other,
                                 std::uint64_t seed) try {
  constexpr double kBeside = 0.05;  // of a number's range
  const auto a = fields_of(one), b = fields_of(other);
  if (!a) return a.error();
  if (!b) return b.error();
  const KeyedChance chance(seed);
  const PartLibrary& library = PartLibrary::shipped();
  const LibraryNumber& age = *library.find_number("age");
  FaceCode child = code_of_seed(seed);
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
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<double> difference(const FaceCode& one, const FaceCode& other) try {
  const auto a = recipe_from_code(one), b = recipe_from_code(other);
  if (!a) return a.error();
  if (!b) return b.error();
  return difference(appearance_of(*a), appearance_of(*b));
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
