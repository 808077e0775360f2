#pragma once
// What a person is like before any part or number is chosen: the axes that laws of chance speak of.

#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/library/part_library.h"

#include <optional>
#include <vector>

namespace mien {

/// Each from 0 to 1, or −1 to 1.
struct PersonAxes {
  double age = 30;  ///< [years]
  double child = 0, elder = 0;
  double minor = 0;  ///< 1 below 18 years
  double lean = 0;   ///< −1 feminine, 1 masculine; people between them are as likely
  double heavy = 0, lengthy = 0;
  double dark = 0;  ///< of the skin
  double coily = 0;
  std::vector<double> archetypes;  ///< how much of each of the library's, in its order

  /// The sum of a law over these axes and archetypes, without what is not an axis, such as "spread".
  double sum(const PartLibrary& library, const Reading& in, const JsonNode& law) const;
};

/// `dark`: the skin's; `years`: where the age is not left to chance. Age picks the archetypes that have a law "by", such
/// as a small child; of the others two win by tickets, and a person is mostly the first.
PersonAxes person_axes(const PartLibrary& library, const KeyedChance& chance, double dark,
                       std::optional<double> years);

/// What the archetypes add to a common number.
double archetypes_add(const PartLibrary& library, const PersonAxes& axes, std::size_t number);

/// Chance's answer for something that has so many tickets: the highest of as many hashes.
std::uint64_t best_ticket(const KeyedChance& chance, std::uint64_t question, int of, int tickets);

}  // namespace mien
