#include "lib/parts/recipe/sample.h"
#include "lib/base/memory_ran_out.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/compose/part_palette.h"
#include "lib/parts/recipe/person_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include "lib/base/from_chars.h"

namespace mien {
namespace {

constexpr int kNone = 1023;   // a held value: no part of the family
constexpr int kSteps = 1023;  // of a number's range

constexpr int kMostTickets = 64, kMostOfNone = 256;
constexpr std::string_view kBare = "none";  // a part of a family that is not optional

// Questions that no family and no number asks.
constexpr std::uint64_t kWorn = 20000;  // and the family's number

class Sampler {
 public:
  Sampler(const PartLibrary& library, const FaceCode& code)
      : library_(library), code_(code), chance_(code.seed) {}

  Recipe recipe() {
    lean_on_axes();
    recipe_.code = face_code_text(code_);
    recipe_.name = "face-" + recipe_.code;
    for (const LibraryNumber& number : library_.numbers()) choose(number);
    skin_ =
        skin_color(library_, recipe_.numbers.at("skin.tone"), recipe_.numbers.at("skin.undertone"));
    for (const Family& family : library_.families()) choose(family);
    return std::move(recipe_);
  }

  double lean() {
    lean_on_axes();
    return axes_.lean;
  }

 private:
  const int* held(int field) const {
    for (const HeldValue& one : code_.held)
      if (one.field == field) return &one.value;
    return nullptr;
  }

  void lean_on_axes() {
    const LibraryNumber* tone = library_.find_number("skin.tone");
    choose(*tone);
    const double dark = (recipe_.numbers[tone->name] - tone->lo) / (tone->hi - tone->lo);
    const LibraryNumber* age = library_.find_number("age");
    std::optional<double> years;
    if (const int* own = held(age->number)) years = age->lo + *own * (age->hi - age->lo) / kSteps;
    axes_ = person_axes(library_, chance_, dark, years);
    recipe_.numbers[age->name] = axes_.age;
  }

  double sum(const Reading& in, const JsonNode& law) const { return axes_.sum(library_, in, law); }

  void choose(const LibraryNumber& number) {
    if (recipe_.numbers.contains(number.name)) return;
    const auto question = std::uint64_t(number.number);
    double value = number.rest + archetypes_add(library_, axes_,
                                                std::size_t(&number - library_.numbers().data()));
    if (number.law.node) {
      const Reading& in = number.law.in();
      const JsonNode& law = *number.law.node;
      const auto find = [&](std::string_view key, double none = 0.0) {
        const JsonNode* node = in.find(law, key);
        return node ? in.number(*node) : none;
      };
      const JsonNode* seldom = in.find(law, "chance");
      if (!seldom || chance_.share(question + 10000) < in.number(*seldom))
        value += sum(in, law) + 2.0 * find("spread") * chance_.bell(question) +
                 find("even") * chance_.share(question);
      value = std::clamp(value, find("least", number.lo), find("most", number.hi));
    }
    // A code holds 1023 steps: what a seed chooses it can hold, too.
    const double range = number.hi - number.lo;
    double step = std::floor(std::clamp((value - number.lo) / range, 0.0, 1.0) * kSteps + 0.5);
    if (const int* own = held(number.number)) step = *own;
    // The last step's own sum may round to beyond the range.
    recipe_.numbers[number.name] = std::min(number.lo + step * range / kSteps, number.hi);
  }

  int tickets(const Reading& in, const JsonNode* law, int most) const {
    return law ? std::clamp(int(std::floor(sum(in, *law) + 0.5)), 0, most) : 8;
  }

  struct Drawn {
    std::uint64_t best;
    const Part* part;  ///< none: no part of the family
  };

  std::uint64_t best_of(const Family& family, int part, int tickets) const {
    return best_ticket(chance_, std::uint64_t(family.number), part, tickets);
  }

  /// Whether the part is not drawn beside one that was chosen before: "avoids": ["glasses", "headwear/cap"].
  bool avoided(const Part& part) const {
    const Reading& in = part.at.in();
    const JsonNode* avoids = in.find(*part.at.node, "avoids");
    bool found = false;
    if (avoids)
      in.for_each(*avoids, [&](const JsonNode& node, int) {
        const std::string_view name = in.string(node), family = name.substr(0, name.find('/'));
        const auto chosen = recipe_.parts.find(std::string(family));
        if (chosen == recipe_.parts.end() || chosen->second == kBare) return;
        found |= family.size() == name.size() || name.substr(family.size() + 1) == chosen->second;
      });
    return found;
  }

  /// What is in the draw, the likeliest first. `bare`: only what leaves the family out, or only what does not; not
  /// said: both.
  std::vector<Drawn> drawn_of(const Family& family, std::optional<bool> bare) const {
    std::vector<Drawn> drawn;
    for (const Part& part : family.parts) {
      if ((bare && *bare != (part.name == kBare)) || avoided(part)) continue;
      const Reading& in = part.at.in();
      const int own = tickets(in, in.find(*part.at.node, "tickets"), kMostTickets);
      if (const std::uint64_t best = best_of(family, part.number, own); best > 0)
        drawn.push_back({best, &part});
    }
    if (const Reading& in = family.at.in(); family.optional && bare != false) {
      const int own = tickets(in, in.find(*family.at.node, "none"), kMostOfNone);
      drawn.push_back({best_of(family, kNone, own), nullptr});
    }
    std::sort(drawn.begin(), drawn.end(),
              [](const Drawn& a, const Drawn& b) { return a.best > b.best; });
    return drawn;
  }

  void choose(const Family& family) {
    const Reading& in = family.at.in();
    // How many people wear one may be said apart from tickets, and stays the same however many parts there are.
    std::optional<bool> bare;
    if (const JsonNode* worn = in.find(*family.at.node, "worn"))
      bare = chance_.share(kWorn + std::uint64_t(family.number)) >= sum(in, *worn);
    std::vector<Drawn> drawn = drawn_of(family, bare);
    if (bare == false && drawn.empty()) drawn = drawn_of(family, true);
    const Part* part = drawn.empty() ? nullptr : drawn[0].part;
    if (const JsonNode* far = in.find(*family.at.node, "apart")) part = far_enough(in, *far, drawn);
    if (const int* own = held(family.number)) {
      part = nullptr;
      for (const Part& one : family.parts)
        if (one.number == *own) part = &one;
    }
    if (part) recipe_.parts[family.name] = part->name;
  }

  /// The first that is far enough from what it is seen beside; where none is, the farthest.
  const Part* far_enough(const Reading& in, const JsonNode& far,
                         const std::vector<Drawn>& drawn) const {
    const Part* farthest = nullptr;
    double most = -1;
    for (const Drawn& one : drawn) {
      if (!one.part) continue;
      const double share = share_apart(in, far, *one.part);
      if (share >= 1) return one.part;
      if (share > most) most = share, farthest = one.part;
    }
    return farthest;
  }

  /// How far a colour is from those it is seen beside, in shares of how far it should be: the least
  /// of {"skin": 0.16, "hair_color": 0.2}.
  double share_apart(const Reading& in, const JsonNode& far, const Part& part) const {
    double share = 1;
    in.for_each(far, [&](const JsonNode& node, int) {
      const std::string_view other = in.tree.key(node);
      Oklch beside;
      if (other == "skin") {
        beside = skin_;
      } else if (const Part* chosen = chosen_part(library_, recipe_, other)) {
        beside = color_of(*chosen);
      } else {
        return;
      }
      share = std::min(share, apart(color_of(part), beside) / in.number(node));
    });
    return share;
  }

  const PartLibrary& library_;
  const FaceCode& code_;
  KeyedChance chance_;
  PersonAxes axes_;
  Oklch skin_;
  Recipe recipe_;
};

}  // namespace

Recipe sampled_recipe(const PartLibrary& library, const FaceCode& code) {
  return Sampler(library, code).recipe();
}

double sampled_lean(const PartLibrary& library, const FaceCode& code) {
  return Sampler(library, code).lean();
}

Recipe recipe_from_seed(std::uint64_t seed) {
  const FaceCode code{.seed = seed & ((std::uint64_t{1} << FaceCode::kSeedBits) - 1), .held = {}};
  const auto library = PartLibrary::shipped_or_why();
  return library ? sampled_recipe(**library, code) : Recipe{};
}

Expected<Recipe> recipe_from_code(const FaceCode& code) try {
  const std::string where = "code " + face_code_text(code);
  const auto shipped = PartLibrary::shipped_or_why();
  if (!shipped) return shipped.error();
  const PartLibrary& library = **shipped;
  for (const HeldValue& held : code.held) {
    const auto is_field = [&](const auto& one) { return one.number == held.field; };
    const auto family =
        std::find_if(library.families().begin(), library.families().end(), is_field);
    if (family == library.families().end()) {
      if (std::none_of(library.numbers().begin(), library.numbers().end(), is_field))
        return Error{where, fmt::format("no code has a field {}", held.field)};
      continue;
    }
    const auto is_part = [&](const Part& part) { return part.number == held.value; };
    if (!(family->optional && held.value == kNone) &&
        std::none_of(family->parts.begin(), family->parts.end(), is_part))
      return Error{where, fmt::format("{} has no part {}", family->name, held.value)};
  }
  return sampled_recipe(library, code);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Recipe neutral_recipe(Recipe recipe) {
  for (const char* expressive : {"smile", "mood"}) recipe.numbers[expressive] = 0;
  for (const Family& family : PartLibrary::shipped().families()) {
    const auto chosen = recipe.parts.find(family.name);
    const Part* part = chosen == recipe.parts.end() ? nullptr : family.find(chosen->second);
    if (!part) continue;
    const Reading& in = part->at.in();
    if (const JsonNode* neutral = in.find(*part->at.node, "neutral"))
      chosen->second = in.string(*neutral);
  }
  return recipe;
}

std::vector<PartFamily> part_families() {
  std::vector<PartFamily> all;
  for (const Family& family : PartLibrary::shipped().families()) {
    all.push_back({family.name, {}, family.optional});
    for (const Part& part : family.parts) all.back().parts.push_back(part.name);
  }
  return all;
}

std::vector<PartNumber> part_numbers() {
  std::vector<PartNumber> all;
  for (const LibraryNumber& number : PartLibrary::shipped().numbers())
    all.push_back({number.name, number.lo, number.hi, number.rest});
  return all;
}

std::vector<std::string> part_styles() {
  return PartLibrary::shipped().styles();
}

Expected<HeldValue> read_held_value(std::string_view text, bool clamp) try {
  const std::string where = one_line(text, 60);
  const auto shipped = PartLibrary::shipped_or_why();
  if (!shipped) return shipped.error();
  const PartLibrary& library = **shipped;
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return Error{where, "expected NAME=VALUE"};
  const std::string_view name = text.substr(0, equals), value = text.substr(equals + 1);
  if (const Family* family = library.find_family(name)) {
    if (value == "none" && family->optional) return HeldValue{family->number, kNone};
    if (const Part* part = family->find(value)) return HeldValue{family->number, part->number};
    std::vector<std::string_view> names;
    for (const Part& part : family->parts) names.push_back(part.name);
    if (family->optional) names.push_back("none");
    return Error{where, unknown_name(family->name, value, names)};
  }
  const LibraryNumber* number = library.find_number(name);
  if (!number) {
    std::vector<std::string_view> names;
    for (const Family& family : library.families()) names.push_back(family.name);
    for (const LibraryNumber& one : library.numbers()) names.push_back(one.name);
    return Error{where, unknown_name("family or number", name, names)};
  }
  double given = 0;
  const auto [end, failed] = from_chars(value.data(), value.data() + value.size(), given);
  if (failed != std::errc{} || end != value.data() + value.size() || !std::isfinite(given))
    return Error{where, fmt::format("expected a number from {} to {}", number->lo, number->hi)};
  if (clamp) given = std::clamp(given, number->lo, number->hi);
  if (!(given >= number->lo && given <= number->hi))
    return Error{where, fmt::format("{} goes from {} to {}", number->name, number->lo, number->hi)};
  return HeldValue{
      number->number,
      int(std::floor((given - number->lo) / (number->hi - number->lo) * kSteps + 0.5))};
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
