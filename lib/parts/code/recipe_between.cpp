#include <mien/recipe_between.h>
#include "lib/base/memory_ran_out.h"

#include "lib/file/json/json_text.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/compose/part_palette.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

/// Of its code, or of its name.
std::uint64_t seed_of(const Recipe& recipe) {
  const auto code = read_face_code(recipe.code);
  return code ? code->seed : seed_from_word(recipe.name);
}

double value_of_number(const Recipe& recipe, const LibraryNumber& number) {
  const auto own = recipe.numbers.find(number.name);
  return own == recipe.numbers.end() ? number.rest : own->second;
}

bool is_color(const Part* part) {
  return part && part->at.in().find(*part->at.node, "color");
}

class Between {
 public:
  Between(const ChosenParts& from, const ChosenParts& to, double at, std::optional<double> parts_at)
      : from_(from),
        to_(to),
        at_(at),
        parts_at_(parts_at),
        chance_(seed_of(from.recipe()) ^ seed_of(to.recipe())) {}

  Recipe recipe() {
    const PartLibrary& library = from_.library();
    made_.name = fmt::format("{} to {}", from_.recipe().name, to_.recipe().name);
    made_.style = nearest(parts_at_.value_or(0.5)).recipe().style;
    for (const LibraryNumber& number : library.numbers()) {
      const double a = value_of_number(from_.recipe(), number),
                   b = value_of_number(to_.recipe(), number);
      made_.numbers[number.name] = std::clamp(a + at_ * (b - a), number.lo, number.hi);
    }
    for (const Family& family : library.families()) choose(family);
    return std::move(made_);
  }

 private:
  /// Whose parts are taken that change at this place.
  const ChosenParts& nearest(double place) const {
    return at_ > 0.0 && (at_ >= 1.0 || place <= at_) ? to_ : from_;
  }

  void choose(const Family& family) {
    const Part *a = from_.of(family.name), *b = to_.of(family.name);
    if (is_color(a) && is_color(b) && at_ > 0.0 && at_ < 1.0) {
      mix(family.name, color_of(*a), color_of(*b));
      return;
    }
    const double own = chance_.share(std::uint64_t(family.number));
    const ChosenParts& whose = nearest(parts_at_.value_or(own));
    const auto part = whose.recipe().parts.find(family.name);
    if (part == whose.recipe().parts.end()) return;
    const auto file = whose.recipe().own_parts.find(part->second);
    std::string name = part->second;
    if (file != whose.recipe().own_parts.end()) {
      name = fmt::format("{}/{}", &whose == &from_ ? "from" : "to", name);
      made_.own_parts[name] = file->second;
    }
    made_.parts[family.name] = name;
  }

  /// A part of its own: the colour at this place.
  void mix(const std::string& family, const Oklch& a, const Oklch& b) {
    const Oklch color = Oklch::from_lab(a.lab() + at_ * (b.lab() - a.lab()));
    const std::string name = fmt::format("between/{}", family);
    made_.own_parts[name] = {
        name,
        fmt::format(
            R"({{"format": "mien-part", "format_version": 1, "family": {}, "name": "between", "color": [{}, {}, {}]}})",
            json_string(family), json_number(color.lightness), json_number(color.chroma),
            json_number(color.hue))};
    made_.parts[family] = name;
  }

  const ChosenParts &from_, &to_;
  const double at_;
  const std::optional<double> parts_at_;
  const KeyedChance chance_;
  Recipe made_;
};

}  // namespace

Expected<Recipe> recipe_between(const Recipe& from, const Recipe& to, double at,
                                std::optional<double> parts_at) try {
  const auto a = ChosenParts::read(from), b = ChosenParts::read(to);
  if (!a) return a.error();
  if (!b) return b.error();
  return Between(*a, *b, std::clamp(at, 0.0, 1.0), parts_at).recipe();
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
