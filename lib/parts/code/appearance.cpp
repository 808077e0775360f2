#include "lib/parts/code/appearance.h"

#include <mien/recipe.h>
#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/compose/part_palette.h"

#include <cmath>

namespace mien {
namespace {

/// A number and what one standard deviation of it is.
struct Spread {
  const char* name;
  double sigma;
};
constexpr std::array<Spread, 5> kNumbersSeen{
    {{"jaw", 0.03}, {"eye.size", 0.05}, {"chin", 0.02}, {"lips", 0.2}, {"brow.thickness", 0.15}}};

/// A family and what another part of it counts.
struct FamilyWeight {
  const char* family;
  double weight;
};
constexpr std::array<FamilyWeight, 6> kFamiliesSeen{{{"hair", 1.0},
                                                     {"beard", 0.6},
                                                     {"glasses", 0.5},
                                                     {"headwear", 1.0},
                                                     {"eyes", 0.5},
                                                     {"nose", 0.4}}};

/// A family of colours and how far apart two of them count 1.
struct ColorUnit {
  const char* family;
  double unit;
};
constexpr std::array<ColorUnit, 3> kColorsSeen{
    {{"hair_color", 0.15}, {"cloth_color", 0.3}, {"backdrop", 0.3}}};
constexpr double kSkinUnit = 0.12, kYears = 30.0, kPerSigma = 0.2;

}  // namespace

Appearance appearance_of(const Recipe& recipe) {
  const PartLibrary& library = PartLibrary::shipped();
  const auto number = [&](const char* name) { return recipe.numbers.at(name); };
  Appearance seen{.skin = skin_color(library, number("skin.tone"), number("skin.undertone")),
                  .age = number("age")};
  for (std::size_t i = 0; i < kFamiliesSeen.size(); ++i) {
    const Part* part = chosen_part(library, recipe, kFamiliesSeen[i].family);
    seen.parts[i] = part ? part->number : -1;
  }
  for (std::size_t i = 0; i < kColorsSeen.size(); ++i)
    seen.colors[i] = color_of(*chosen_part(library, recipe, kColorsSeen[i].family));
  for (std::size_t i = 0; i < kNumbersSeen.size(); ++i)
    seen.numbers[i] = number(kNumbersSeen[i].name);
  return seen;
}

double difference(const Appearance& one, const Appearance& other) {
  double sum = apart(one.skin, other.skin) / kSkinUnit + std::abs(one.age - other.age) / kYears;
  for (std::size_t i = 0; i < kFamiliesSeen.size(); ++i)
    sum += one.parts[i] != other.parts[i] ? kFamiliesSeen[i].weight : 0.0;
  for (std::size_t i = 0; i < kColorsSeen.size(); ++i)
    sum += apart(one.colors[i], other.colors[i]) / kColorsSeen[i].unit;
  for (std::size_t i = 0; i < kNumbersSeen.size(); ++i)
    sum += kPerSigma * std::abs(one.numbers[i] - other.numbers[i]) / kNumbersSeen[i].sigma;
  return sum;
}

}  // namespace mien
