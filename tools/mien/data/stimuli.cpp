#include "lib/file/json/json_text.h"
#include "lib/parts/code/keyed_chance.h"
#include "tools/mien/data/equal_steps.h"
#include "tools/mien/data/stimulus_plan.h"
#include "tools/mien/output/contact_sheet.h"

#include <mien/face_code.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

namespace mien::command {
namespace {

constexpr int kMeasured = 128;  // [px] of pictures whose differences are measured

using Combination = std::vector<std::size_t>;  ///< a level of each factor

class Experiment {
 public:
  explicit Experiment(const StimulusPlan& plan) : plan_(plan), factors_(plan.factors) {
    for (const Factor& factor : factors_)
      if (factor.kind == FactorKind::person) people_ = &factor;
  }

  Expected<std::vector<Stimulus>> stimuli() {
    for (Factor& factor : factors_)
      if (const auto done = equalize(factor); !done) return done.error();
    std::vector<Stimulus> made;
    for (const Combination& one : combinations()) {
      if (!plan_.pairs) {
        made.push_back(stimulus(one));
        made.back().file = fmt::format("{:04}.png", made.size());
        continue;
      }
      const std::size_t pair = made.size() / 2 + 1;
      for (const bool last : {false, true}) {
        Combination end = one;
        end[*plan_.pairs] = last ? factors_[*plan_.pairs].levels.size() - 1 : 0;
        made.push_back(stimulus(end));
        made.back().file = fmt::format("{:04}{}.png", pair, last ? 'b' : 'a');
      }
    }
    return made;
  }

 private:
  /// A face on which nothing is varied: the first person, where there are people.
  Stimulus plain() const {
    Stimulus stimulus{.file = {}, .levels = {}, .recipe = plan_.face, .controls = {}};
    if (people_) put_person(people_->people[0], stimulus.recipe);
    return stimulus;
  }

  /// What the plan's face says stands before what the person's says.
  void put_person(const Recipe& person, Recipe& recipe) const {
    Recipe both = plan_.neutral ? neutral_recipe(person) : person;
    for (const auto& [family, part] : plan_.face.parts) both.parts[family] = part;
    for (const auto& [name, value] : plan_.face.numbers) both.numbers[name] = value;
    for (const auto& [name, part] : plan_.face.own_parts) both.own_parts[name] = part;
    both.style = plan_.face.style;
    recipe = std::move(both);
  }

  void exaggerate(double by, Recipe& recipe) const {
    for (const PartNumber& number : part_numbers()) {
      const auto value = recipe.numbers.find(number.name);
      const auto mean = people_->mean.numbers.find(number.name);
      if (value == recipe.numbers.end() || mean == people_->mean.numbers.end()) continue;
      value->second =
          std::clamp(mean->second + by * (value->second - mean->second), number.lo, number.hi);
    }
  }

  void vary(const Factor& factor, std::size_t level, Stimulus& stimulus) const {
    switch (factor.kind) {
      case FactorKind::person:
        break;  // put first, since it sets every number
      case FactorKind::caricature:
        exaggerate(factor.values[level], stimulus.recipe);
        break;
      case FactorKind::number:
        stimulus.recipe.numbers[factor.what] = factor.values[level];
        break;
      case FactorKind::control:
        stimulus.controls.emplace_back(factor.what, factor.values[level]);
        break;
      case FactorKind::picture:
        stimulus.picture = StimulusPicture(int(factor.values[level]));
        break;
      case FactorKind::part:
        stimulus.recipe.parts[factor.what] = factor.levels[level];
        if (factor.levels[level] == "none" && is_optional(factor.what))
          stimulus.recipe.parts.erase(factor.what);
    }
  }

  bool is_optional(const std::string& family) const {
    const std::vector<PartFamily> families = part_families();
    return std::ranges::find(families, family, &PartFamily::name)->optional;
  }

  Stimulus stimulus(const Combination& levels) const {
    Stimulus made = plain();
    for (std::size_t i = 0; i < factors_.size(); ++i)
      if (factors_[i].kind == FactorKind::person)
        put_person(factors_[i].people[levels[i]], made.recipe);
    for (const FactorKind kind :  // caricatures exaggerate the person, and no other factor
         {FactorKind::caricature, FactorKind::number, FactorKind::part, FactorKind::control,
          FactorKind::picture})
      for (std::size_t i = 0; i < factors_.size(); ++i)
        if (factors_[i].kind == kind) vary(factors_[i], levels[i], made);
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      const Factor& factor = factors_[i];
      const bool counted = factor.levels[levels[i]].empty();
      made.levels.emplace_back(
          factor.name, counted ? json_number(factor.values[levels[i]]) : factor.levels[levels[i]]);
    }
    return made;
  }

  /// Moves the levels between a factor's ends so that they differ equally, on the plain face.
  Expected<Done> equalize(Factor& factor) const {
    if (factor.equal == EqualIn::number) return Done{};
    std::optional<Error> failed;
    const auto measured = [&](double value) {
      Factor one = factor;
      one.values = {value};
      Stimulus made = plain();
      vary(one, 0, made);
      auto seen = measure(factor.equal, made);
      if (!seen) failed = seen.error();
      return seen ? *std::move(seen) : Measured{};
    };
    double kept_at = factor.values.front();  // many places are compared with the one before them
    Measured kept = measured(kept_at);
    const auto differ = [&](double a, double b) {
      if (a != kept_at) kept = measured(kept_at = a);
      const Measured other = measured(b);
      return failed ? std::abs(a - b) : difference(kept, other);
    };
    const auto steps =
        equal_steps(factor.values.front(), factor.values.back(), int(factor.values.size()), differ);
    if (failed) return *failed;
    if (!steps) return Error{"factor " + factor.name, steps.error().what};
    factor.values = *steps;
    return Done{};
  }

  /// What is compared: faces, or pictures of them.
  using Measured = std::variant<std::monostate, Face, Image>;

  static Expected<Measured> measure(EqualIn in, const Stimulus& stimulus) {
    if (in == EqualIn::displacement) {
      auto face = posed_stimulus(stimulus);
      if (!face) return face.error();
      return Measured(*std::move(face));
    }
    auto image = drawn_stimulus(stimulus, kMeasured);
    if (!image) return image.error();
    return Measured(*std::move(image));
  }

  static double difference(const Measured& one, const Measured& other) {
    if (const Face* face = std::get_if<Face>(&one))
      return displacement(*face, std::get<Face>(other));
    return level_difference(std::get<Image>(one), std::get<Image>(other)).rms;
  }

  /// How many levels a factor has here: what pairs differ in stays at its first.
  std::size_t levels_of(std::size_t factor) const {
    return factor == plan_.pairs ? 1 : factors_[factor].levels.size();
  }

  /// All, the last factor changing first.
  std::set<Combination> every_combination() const {
    std::set<Combination> all{Combination(factors_.size())};
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      std::set<Combination> longer;
      for (Combination one : all)
        for (one[i] = 0; one[i] < levels_of(i); ++one[i]) longer.insert(longer.end(), one);
      all = std::move(longer);
    }
    return all;
  }

  /// A level of each factor by lot, again and again until there are so many that differ. All combinations are as
  /// likely, however many there are, and a larger sample has those of a smaller one.
  std::set<Combination> sampled_combinations(std::size_t count) const {
    const KeyedChance chance(seed_from_word(plan_.seed));
    std::set<Combination> sample;
    for (std::uint64_t lot = 0; sample.size() < count; ++lot) {
      Combination one(factors_.size());
      for (std::size_t i = 0; i < one.size(); ++i)
        one[i] = std::size_t(chance.bits(lot, i) % levels_of(i));
      sample.insert(std::move(one));
    }
    return sample;
  }

  /// All or the sample, in the order in which all would stand.
  std::set<Combination> combinations() const {
    return plan_.sample ? sampled_combinations(std::size_t(*plan_.sample)) : every_combination();
  }

  const StimulusPlan& plan_;
  std::vector<Factor> factors_;
  const Factor* people_ = nullptr;
};

}  // namespace

Expected<std::vector<Stimulus>> stimuli(const StimulusPlan& plan) {
  return Experiment(plan).stimuli();
}

}  // namespace mien::command
