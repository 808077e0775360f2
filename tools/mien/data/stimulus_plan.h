#pragma once
// The plan of an experiment: factors, crossed or drawn by lot, that make a set of pictures.

#include "tools/mien/data/stimulus.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mien::command {

enum class FactorKind { person, number, control, part, caricature, picture };

/// In what the steps of a scale are equal.
enum class EqualIn { number, displacement, picture };

/// One thing that is varied, and its levels.
struct Factor {
  std::string name;
  std::string where;  ///< in the plan
  FactorKind kind = FactorKind::number;
  std::string what;                 ///< the number, control or family; empty for other kinds
  std::vector<std::string> levels;  ///< as the manifest says them
  std::vector<double> values;       ///< of numbers, controls and caricatures
  std::vector<std::string> each;    ///< of several controls in turn: the one of each level
  EqualIn equal = EqualIn::number;
  std::vector<Recipe> people;  ///< of persons
  Recipe mean;                 ///< of persons: the mean of those named, whether it is shown or not

  /// What the manifest calls a level: by its name, and of several controls in turn how strong it is beside that.
  std::vector<std::string> columns() const {
    return each.empty() ? std::vector{name} : std::vector{name, name + "_strength"};
  }
};

struct StimulusPlan {
  Recipe face;                       ///< what no factor moves
  std::vector<std::string> without;  ///< families of which `face` says that nobody has a part
  bool neutral = true;  ///< people whom the plan names neither smile nor move of themselves
  int size = 256;       ///< [px] the longer side of a picture
  std::vector<Factor> factors;
  std::optional<int> sample;  ///< so many of all combinations, drawn by lot; none: all
  std::string seed = "1";     ///< of the lot
  std::optional<std::size_t>
      pairs;  ///< the factor in whose ends alone two pictures of a pair differ
};

inline constexpr std::uint64_t kMostStimuli = 100'000;

/// Reads a plan (docs/data.md). Errors have their place; one says how many pictures a plan asks for that asks
/// for more than kMostStimuli.
Expected<StimulusPlan> read_stimulus_plan(const std::filesystem::path& path,
                                          std::vector<Error>* warnings);

/// The pictures of a plan, in the order of its factors, the last one changing first. Errors, with the factor's
/// place: scales without steps that differ, controls that the first face does not have, or values beyond their
/// range. Caricatures that stop at the ends of numbers are warnings.
Expected<std::vector<Stimulus>> stimuli(const StimulusPlan& plan, std::vector<Error>* warnings);

}  // namespace mien::command
