#include "lib/file/json/json_text.h"
#include "lib/parts/code/keyed_chance.h"
#include "tools/mien/data/equal_steps.h"
#include "tools/mien/data/stimulus_plan.h"
#include "tools/mien/output/contact_sheet.h"
#include "tools/mien/terminal/watched_work.h"

#include <mien/face_code.h>
#include <mien/pose.h>

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

  Expected<std::vector<Stimulus>> stimuli(std::vector<Error>* warnings) {
    if (const auto checked = check_controls(); !checked) return checked.error();
    tell_stops(warnings);
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
    for (const std::string& family : plan_.without) both.parts.erase(family);
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

  static const std::string& control_of(const Factor& factor, std::size_t level) {
    return factor.each.empty() ? factor.what : factor.each[level];
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
        stimulus.controls.emplace_back(control_of(factor, level), factor.values[level]);
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
      const std::string& word = factor.levels[levels[i]];
      if (!word.empty()) made.levels.emplace_back(factor.name, word);
      if (word.empty() || !factor.each.empty())
        made.levels.emplace_back(factor.columns().back(), json_number(factor.values[levels[i]]));
    }
    return made;
  }

  /// Moves the levels between a factor's ends so that they differ equally, on the plain face.
  Expected<Done> equalize(Factor& factor) const {
    if (factor.equal == EqualIn::number) return Done{};
    const auto at_rest = composed_stimulus(plain());
    if (!at_rest) return at_rest.error();
    std::optional<Error> failed;
    const Ruler ruler = [&](const std::vector<double>& values) {
      std::vector<double> steps(values.size() - 1, 0.0);
      auto seen = measured(factor, values, *at_rest);
      if (!seen) failed = seen.error();
      for (std::size_t i = 0; seen && i < steps.size(); ++i)
        steps[i] = difference((*seen)[i], (*seen)[i + 1]);
      return steps;
    };
    const auto steps =
        equal_steps(factor.values.front(), factor.values.back(), int(factor.values.size()), ruler);
    if (failed) return Error{factor.where, failed->what};
    if (!steps) return Error{factor.where, steps.error().what};
    factor.values = *steps;
    return Done{};
  }

  /// What is compared: faces, or pictures of them.
  using Measured = std::variant<Face, Image>;

  /// The plain face at those values of a factor. What only poses it is laid over the face at rest.
  Expected<std::vector<Measured>> measured(const Factor& factor, const std::vector<double>& values,
                                           const Face& at_rest) const {
    std::vector<std::optional<Expected<Measured>>> seen(values.size());
    watched_for("equal steps", int(values.size()), {}, [&](int i) {
      Factor one = factor;
      one.values = {values[std::size_t(i)]};
      Stimulus made = plain();
      vary(one, 0, made);
      seen[std::size_t(i)] = measure(
          factor.equal,
          factor.kind == FactorKind::control ? Expected<Face>(at_rest) : composed_stimulus(made),
          made);
    });
    std::vector<Measured> all;
    for (auto& one : seen) {
      if (!*one) return one->error();
      all.push_back(**std::move(one));
    }
    return all;
  }

  static Expected<Measured> measure(EqualIn in, const Expected<Face>& composed,
                                    const Stimulus& stimulus) {
    if (!composed) return composed.error();
    auto posed = posed_stimulus(*composed, stimulus);
    if (!posed) return posed.error();
    if (in == EqualIn::displacement) return Measured(*std::move(posed));
    auto image = stimulus_picture(*posed, stimulus.picture, kMeasured);
    if (!image) return image.error();
    return Measured(*std::move(image));
  }

  static double difference(const Measured& one, const Measured& other) {
    if (const Face* face = std::get_if<Face>(&one))
      return displacement(*face, std::get<Face>(other));
    return level_difference(std::get<Image>(one), std::get<Image>(other)).rms;
  }

  /// Whether the first face has the controls of a plan, and their values are in range.
  Expected<Done> check_controls() const {
    const Expected<Face> face = composed_stimulus(plain());
    if (!face) return face.error();
    for (const Factor& factor : factors_) {
      if (factor.kind != FactorKind::control) continue;
      for (std::size_t i = 0; i < factor.values.size(); ++i)
        if (const auto read =
                read_setting(*face, control_of(factor, i) + "=" + json_number(factor.values[i]));
            !read)
          return Error{factor.where, read.error().what};
    }
    return Done{};
  }

  /// A warning where a caricature would take numbers beyond their ranges: they stop at the ends.
  void tell_stops(std::vector<Error>* warnings) const {
    for (const Factor& factor : factors_) {
      if (factor.kind != FactorKind::caricature) continue;
      const auto largest = std::ranges::max_element(
          factor.values, [](double a, double b) { return std::abs(a) < std::abs(b); });
      std::size_t most = 0, of = 0, who = 0;
      for (std::size_t i = 0; i < people_->people.size(); ++i) {
        const auto [stopped, all] = stops(people_->people[i], *largest);
        if (stopped > most) most = stopped, of = all, who = i;
      }
      if (most > 0)
        warnings->push_back(
            {factor.where,
             fmt::format("at {} {} of {} numbers of {} stop at the end of their range", *largest,
                         most, of, people_->levels[who])});
    }
  }

  /// How many numbers a caricature stops, of those that it moves.
  std::pair<std::size_t, std::size_t> stops(const Recipe& person, double by) const {
    std::size_t stopped = 0, moved = 0;
    for (const PartNumber& number : part_numbers()) {
      const auto value = person.numbers.find(number.name);
      const auto mean = people_->mean.numbers.find(number.name);
      if (value == person.numbers.end() || mean == people_->mean.numbers.end() ||
          value->second == mean->second)
        continue;
      ++moved;
      const double wanted = mean->second + by * (value->second - mean->second);
      stopped += wanted < number.lo || wanted > number.hi;
    }
    return {stopped, moved};
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

Expected<std::vector<Stimulus>> stimuli(const StimulusPlan& plan, std::vector<Error>* warnings) {
  return Experiment(plan).stimuli(warnings);
}

}  // namespace mien::command
