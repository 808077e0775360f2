#include "lib/parts/recipe/person_axes.h"
#include "lib/base/nearest_name.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace mien {
namespace {

// Questions that no family and no number asks.
constexpr std::uint64_t kAgeBand = 2000, kAge = 2001, kLean = 2002, kLeanSide = 2003, kHeavy = 2004,
                        kLong = 2005, kCoily = 2006, kArchetype = 2007, kMostlyFirst = 2008;

constexpr int kMostArchetypeTickets = 64;

/// What a number's law holds beside axes: how far chance goes, and between which ends.
constexpr KnownKeys<5> kLawful({"spread", "even", "chance", "least", "most"});

/// What tickets and laws are sums over beside archetypes, in the order of axis().
constexpr KnownKeys<14> kAxes({"any", "lean", "masculine", "feminine", "child", "minor", "adult",
                               "elder", "young", "heavy", "long", "dark", "light", "coily"});

int sampled_age(const KeyedChance& chance) {
  struct Band {
    double until;
    int youngest, oldest;
  };
  constexpr std::array<Band, 5> kBands{
      {{0.46, 20, 44}, {0.65, 45, 64}, {0.78, 65, 88}, {0.87, 13, 19}, {1.0, 5, 12}}};
  const double which = chance.share(kAgeBand);
  const Band& band =
      *std::find_if(kBands.begin(), kBands.end(), [&](const Band& b) { return which < b.until; });
  return band.youngest + int(chance.share(kAge) * (band.oldest - band.youngest + 1));
}

double axis(const PersonAxes& person, const PartLibrary& library, const Reading& in,
            const JsonNode& node) {
  const double lean = person.lean;
  const std::array<double, kAxes.names.size()> all{1.0,
                                                   lean,
                                                   std::max(lean, 0.0),
                                                   std::max(-lean, 0.0),
                                                   person.child,
                                                   person.minor,
                                                   1.0 - person.child,
                                                   person.elder,
                                                   1.0 - person.elder,
                                                   person.heavy,
                                                   person.lengthy,
                                                   person.dark,
                                                   1.0 - person.dark,
                                                   person.coily};
  const std::string_view key = in.tree.key(node);
  if (const std::size_t i = kAxes.find(node.key_sign, key); i < all.size()) return all[i];
  const std::vector<Archetype>& archetypes = library.archetypes();
  // Laws of archetypes themselves are asked before there are any.
  for (std::size_t i = 0; i < person.archetypes.size(); ++i)
    if (archetypes[i].name == key) return person.archetypes[i];
  std::vector<std::string_view> names(kAxes.names.begin(), kAxes.names.end());
  for (const Archetype& one : archetypes) names.push_back(one.name);
  in.refuse(node, unknown_name("axis or archetype", key, names));
}

/// The places of the two drawn archetypes that win; as many as there are.
std::vector<std::size_t> drawn_archetypes(const PartLibrary& library, const KeyedChance& chance,
                                          const PersonAxes& person) {
  std::vector<std::pair<std::uint64_t, std::size_t>> drawn;
  for (std::size_t i = 0; i < library.archetypes().size(); ++i) {
    const Archetype& one = library.archetypes()[i];
    if (!one.drawn) continue;
    const Reading& in = one.at.in();
    const double law = person.sum(library, in, in.need(*one.at.node, "tickets"));
    const int tickets = std::clamp(int(std::floor(law + 0.5)), 0, kMostArchetypeTickets);
    if (const std::uint64_t best = best_ticket(chance, kArchetype, one.number, tickets); best > 0)
      drawn.emplace_back(best, i);
  }
  std::sort(drawn.rbegin(), drawn.rend());
  std::vector<std::size_t> places;
  for (const auto& [best, place] : drawn)
    if (places.size() < 2) places.push_back(place);
  return places;
}

void mix_archetypes(const PartLibrary& library, const KeyedChance& chance, PersonAxes& person) {
  constexpr double kLeastOfFirst = 0.7;
  std::vector<double> shares(library.archetypes().size());
  double left = 1.0;  // for those that are drawn
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Archetype& one = library.archetypes()[i];
    if (one.drawn) continue;
    const Reading& in = one.at.in();
    shares[i] = std::clamp(person.sum(library, in, in.need(*one.at.node, "by")), 0.0, 1.0);
    left *= 1.0 - shares[i] * (1.0 - in.number(in.need(*one.at.node, "leaves")));
  }
  const std::vector<std::size_t> drawn = drawn_archetypes(library, chance, person);
  const double first = kLeastOfFirst + (1.0 - kLeastOfFirst) * chance.share(kMostlyFirst);
  if (!drawn.empty()) shares[drawn[0]] = left * (drawn.size() > 1 ? first : 1.0);
  if (drawn.size() > 1) shares[drawn[1]] = left * (1.0 - first);
  person.archetypes = std::move(shares);
}

}  // namespace

double PersonAxes::sum(const PartLibrary& library, const Reading& in, const JsonNode& law) const {
  double all = 0.0;
  in.for_each(law, [&](const JsonNode& node, int) {
    if (kLawful.find(node.key_sign, in.tree.key(node)) == kLawful.names.size())
      all += in.number(node) * axis(*this, library, in, node);
  });
  return all;
}

PersonAxes person_axes(const PartLibrary& library, const KeyedChance& chance, double dark,
                       std::optional<double> years) {
  constexpr double kGrown = 16, kChildYears = 11, kOfAge = 18, kOld = 50, kOldYears = 35;
  PersonAxes person;
  person.dark = dark;
  person.age = years ? *years : sampled_age(chance);
  person.child = std::clamp((kGrown - person.age) / kChildYears, 0.0, 1.0);
  person.minor = person.age < kOfAge ? 1.0 : 0.0;
  person.elder = std::clamp((person.age - kOld) / kOldYears, 0.0, 1.0);
  const double side = chance.share(kLeanSide) < 0.5 ? -1.0 : 1.0;
  person.lean = side * (0.35 + 0.65 * chance.share(kLean)) * (1.0 - 0.75 * person.child);
  person.heavy = 2.0 * chance.bell(kHeavy), person.lengthy = 2.0 * chance.bell(kLong);
  person.coily =
      std::clamp((person.dark - 0.25) / 0.6, 0.0, 1.0) * (0.6 + 0.4 * chance.share(kCoily));
  mix_archetypes(library, chance, person);
  return person;
}

double archetypes_add(const PartLibrary& library, const PersonAxes& axes, std::size_t number) {
  double sum = 0.0;
  for (std::size_t i = 0; i < axes.archetypes.size(); ++i) {
    const std::vector<double>& offsets = library.archetypes()[i].offsets;
    if (number < offsets.size()) sum += axes.archetypes[i] * offsets[number];
  }
  return sum;
}

std::uint64_t best_ticket(const KeyedChance& chance, std::uint64_t question, int of, int tickets) {
  std::uint64_t best = 0;
  for (int i = 0; i < tickets; ++i)
    best = std::max(best, chance.bits(question, std::uint64_t(of) * 64 + std::uint64_t(i)));
  return best;
}

}  // namespace mien
