#include "tools/mien/people/parts_at_fault.h"

#include <mien/limits.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace mien::command {
namespace {

/// What a share is at least, seen `hits` times in `tries`, with 97.5 % confidence: the lower end of
/// Wilson's score interval (1927). Two of two say less than eight of nine.
double least_share(int hits, int tries) {
  constexpr double kScore = 1.96;
  const double n = tries, share = hits / n, spread = kScore * kScore / n;
  return (share + 0.5 * spread - kScore * std::sqrt((share * (1 - share) + 0.25 * spread) / n)) /
         (1 + spread);
}

}  // namespace

std::vector<PartAtFault> parts_at_fault(const std::vector<const Recipe*>& people,
                                        const std::vector<char>& faulty) {
  constexpr std::size_t kMostParts = 3;
  constexpr int kLeastPeople = 2;
  std::vector<char> open = faulty;  // not explained yet
  const double usual =
      double(std::ranges::count(faulty, char{1})) / double(std::max<std::size_t>(people.size(), 1));
  std::vector<PartAtFault> found;
  while (found.size() < kMostParts) {
    std::map<std::pair<std::string, std::string>, std::pair<int, int>> counts;
    for (std::size_t i = 0; i < people.size(); ++i) {
      end_if_stopped();
      for (const auto& part : people[i]->parts) {
        auto& [hits, tries] = counts[part];
        hits += open[i], ++tries;
      }
    }
    double surest = usual;
    const decltype(counts)::value_type* best = nullptr;
    for (const auto& count : counts) {
      const auto& [hits, tries] = count.second;
      if (hits < kLeastPeople || least_share(hits, tries) <= surest) continue;
      surest = least_share(hits, tries), best = &count;
    }
    if (!best) break;
    const auto& [family, part] = best->first;
    found.push_back({family, part, best->second.first, best->second.second});
    for (std::size_t i = 0; i < people.size(); ++i)
      if (const auto own = people[i]->parts.find(family);
          own != people[i]->parts.end() && own->second == part)
        open[i] = 0;
  }
  return found;
}

}  // namespace mien::command
