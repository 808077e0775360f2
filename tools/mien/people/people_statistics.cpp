#include "tools/mien/people/people_statistics.h"

#include <mien/recipe.h>
#include "lib/file/json/json_text.h"
#include "lib/parts/code/appearance.h"
#include "lib/parts/recipe/sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace mien::command {
namespace {

constexpr int kDrawn = 10000;             // by the law
constexpr double kLeastDifference = 3.5;  // asked of two people on one sheet
constexpr std::size_t kSheet = 100;

AskedShare exactly(double share) {
  return {share, share};
}

/// Counts people into lines. Every person is asked the same questions in the same order: the first makes the lines.
class Tally {
 public:
  /// `count`: of each line.
  Tally(Counted PeopleCount::*count, std::vector<PeopleCount>& lines)
      : count_(count), lines_(lines), families_(part_families()) {}

  void add(const Recipe& recipe, double lean) {
    recipe_ = &recipe, next_ = 0;
    ask_age();
    ask_tone();
    ask("lean", "feminine", exactly(0.5), lean < 0);
    ask("lean", "masculine", exactly(0.5), lean > 0);
    ask_worn();
    ask_seldom();
    ask_parts();
  }

 private:
  double age() const { return recipe_->numbers.at("age"); }

  std::string_view part(const std::string& family) const {
    const auto own = recipe_->parts.find(family);
    return own == recipe_->parts.end() ? std::string_view("none") : std::string_view(own->second);
  }

  /// `about`: whether the line is about this person at all.
  void ask(std::string_view group, std::string_view name, std::optional<AskedShare> asked, bool has,
           bool about = true) {
    if (next_ == lines_.size())
      lines_.push_back({std::string(group), std::string(name), {}, {}, asked});
    Counted& to = lines_[next_++].*count_;
    if (about) ++to.of, to.count += has;
  }

  void ask_age() {
    struct Band {
      std::string_view name;
      double from, until, asked;
    };
    constexpr std::array<Band, 5> kBands{{{"children 5-12", 0, 13, 0.13},
                                          {"teens 13-19", 13, 20, 0.09},
                                          {"adults 20-44", 20, 45, 0.46},
                                          {"adults 45-64", 45, 65, 0.19},
                                          {"elders 65-88", 65, 100, 0.13}}};
    for (const Band& band : kBands)
      ask("age", band.name, exactly(band.asked), age() >= band.from && age() < band.until);
  }

  /// Tenths of the range, each as likely.
  void ask_tone() {
    constexpr int kTenths = 10;
    const double share = (recipe_->numbers.at("skin.tone") - 1.0) / 9.0;
    const int own = std::min(int(share * kTenths), kTenths - 1);
    for (int i = 0; i < kTenths; ++i)
      ask("skin.tone", fmt::format("{:.1f}-{:.1f}", 1 + 0.9 * i, 1.9 + 0.9 * i),
          exactly(1.0 / kTenths), own == i);
  }

  void ask_worn() {
    constexpr double kOlder = 50, kElder = 65;
    constexpr AskedShare kMoreThanTheYoung{0.22, 0.5};
    const bool glasses = part("glasses") != "none";
    ask("worn", "glasses below 50", exactly(0.18), glasses, age() < kOlder);
    ask("worn", "glasses from 65", kMoreThanTheYoung, glasses, age() >= kElder);
    ask("worn", "headwear", exactly(0.12), part("headwear") != "none");
    ask("looks", "smiling", AskedShare{0.9, 0.98}, recipe_->numbers.at("smile") >= 0.3);
    ask("looks", "showing teeth", AskedShare{0.3, 0.37}, recipe_->numbers.at("mood") >= 0.1);
  }

  /// What few people have, so that a sheet of a hundred has some.
  void ask_seldom() {
    struct Seldom {
      const char *family, *begin;
    };
    constexpr std::array<Seldom, 4> kSeldom{
        {{"aid", "hearing_aid"}, {"aid", "eye_patch"}, {"skin", "vitiligo"}, {"skin", "scar"}}};
    for (const Seldom& one : kSeldom)
      ask("seldom", one.begin, AskedShare{0.01, 0.02}, part(one.family).starts_with(one.begin));
  }

  /// Every part of every family, whether anybody has it or not.
  void ask_parts() {
    for (const PartFamily& family : families_) {
      const std::string_view own = part(family.name);
      for (const std::string& one : family.parts) ask(family.name, one, {}, own == one);
      if (family.optional) ask(family.name, "none", {}, own == "none");
    }
  }

  Counted PeopleCount::*count_;
  std::vector<PeopleCount>& lines_;
  std::vector<PartFamily> families_;
  const Recipe* recipe_ = nullptr;
  std::size_t next_ = 0;
};

void measure_differences(const std::vector<Appearance>& seen, PeopleStatistics& to) {
  std::vector<double> all;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t j = i - i % kSheet; j < i; ++j) all.push_back(difference(seen[i], seen[j]));
  if (all.empty()) return;
  const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
  std::ranges::nth_element(all, middle);
  to.median_difference = *middle;
  to.least_difference = *std::min_element(all.begin(), middle + 1);
}

std::string percent(double share) {
  return fmt::format("{:.1f}", 100 * share);
}

std::string asked_text(const PeopleCount& one) {
  if (!one.asked) return "";
  const auto& [least, most] = *one.asked;
  return fmt::format(
      "{:>11}{}",
      least == most ? percent(least) : fmt::format("{}-{}", percent(least), percent(most)),
      one.missed() ? "  missed" : "");
}

}  // namespace

bool PeopleCount::missed() const {
  if (!asked || law.of == 0) return false;
  const auto error = [&](double share) { return 3.0 * std::sqrt(share * (1.0 - share) / law.of); };
  return law.share() < asked->least - error(asked->least) ||
         law.share() > asked->most + error(asked->most);
}

PeopleStatistics people_statistics(const std::vector<FaceCode>& people) {
  PeopleStatistics made{.people = int(people.size()), .drawn = kDrawn};
  const PartLibrary& library = PartLibrary::shipped();
  std::vector<Appearance> seen;
  Tally here(&PeopleCount::here, made.counts);
  Tally law(&PeopleCount::law, made.counts);
  for (const FaceCode& code : people) {
    const Recipe recipe = recipe_from_code(code).value();
    here.add(recipe, sampled_lean(library, code));
    seen.push_back(appearance_of(recipe));
  }
  for (int i = 0; i < kDrawn; ++i) {
    const FaceCode code{.seed = seed_from_word(fmt::format("law/{}", i)), .held = {}};
    law.add(sampled_recipe(library, code), sampled_lean(library, code));
  }
  measure_differences(seen, made);
  return made;
}

std::string statistics_table(const PeopleStatistics& statistics) {
  std::string text = fmt::format(
      "{} people of the sheet, and {} as the law draws them\n\n"
      "{:14}{:22}{:>8}{:>8}{:>8}{:>11}\n",
      statistics.people, statistics.drawn, "", "", "people", "%", "law %", "asked %");
  std::string_view group;
  for (const PeopleCount& one : statistics.counts) {
    text += fmt::format("{:14}{:22}{:8}{:>8}{:>8}{}\n", one.group == group ? "" : one.group,
                        one.name, one.here.count, percent(one.here.share()),
                        percent(one.law.share()), asked_text(one));
    group = one.group;
  }
  if (statistics.people < 2) return text;
  const double least = statistics.least_difference;
  return text + fmt::format(
                    "\ndifference of two people on a sheet of {}: least {:.2f}, asked {}{}; median "
                    "{:.2f}\n",
                    kSheet, least, kLeastDifference, least < kLeastDifference ? ", missed" : "",
                    statistics.median_difference);
}

std::string statistics_json(const PeopleStatistics& statistics) {
  const auto counted = [](const Counted& of) {
    return fmt::format("{{\"count\": {}, \"of\": {}, \"share\": {}}}", of.count, of.of,
                       json_number(of.share()));
  };
  std::string text = fmt::format("{{\"people\": {}, \"drawn\": {}, \"counts\": [",
                                 statistics.people, statistics.drawn);
  for (const PeopleCount& one : statistics.counts) {
    text += fmt::format("{}\n {{\"group\": {}, \"name\": {}, \"sheet\": {}, \"law\": {}",
                        text.ends_with('[') ? "" : ",", json_string(one.group),
                        json_string(one.name), counted(one.here), counted(one.law));
    if (one.asked)
      text += fmt::format(", \"asked\": [{}, {}], \"missed\": {}", json_number(one.asked->least),
                          json_number(one.asked->most), one.missed());
    text += "}";
  }
  return text +
         fmt::format("],\n \"difference\": {{\"least\": {}, \"median\": {}, \"asked\": {}}}}}\n",
                     json_number(statistics.least_difference),
                     json_number(statistics.median_difference), json_number(kLeastDifference));
}

}  // namespace mien::command
