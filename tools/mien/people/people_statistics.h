#pragma once
// What a number of people are like, counted, beside what the law that draws them is to give.

#include <mien/face_code.h>

#include <optional>
#include <string>
#include <vector>

namespace mien::command {

/// A share that is asked for; `least` and `most` are equal where it is one number.
struct AskedShare {
  double least, most;
};

/// How many of some people have something.
struct Counted {
  int count = 0;
  int of = 0;

  double share() const { return of > 0 ? double(count) / of : 0.0; }
};

/// One line: "age", "teens 13-19"; "hair", "bob".
struct PeopleCount {
  std::string group, name;
  Counted here, law;  ///< of the people given; of those whom the law draws
  std::optional<AskedShare> asked;

  /// Whether the law's share is beyond what is asked by more than chance explains: three standard errors.
  bool missed() const;
};

struct PeopleStatistics {
  int people = 0, drawn = 0;        ///< given; by the law
  std::vector<PeopleCount> counts;  ///< first what something is asked of, then each family's parts
  /// Of any two people given who stand on one sheet of a hundred (`difference`); 0 for one person.
  double least_difference = 0, median_difference = 0;
};

/// Of people by code, beside ten thousand as the law draws them. A crowd's shares are others than
/// the law's: who looks like somebody before has less of a chance.
PeopleStatistics people_statistics(const std::vector<FaceCode>& people);

std::string statistics_table(const PeopleStatistics& statistics);
std::string statistics_json(const PeopleStatistics& statistics);

}  // namespace mien::command
