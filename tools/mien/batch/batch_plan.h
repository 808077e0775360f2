#pragma once
// A plan: jobs that multiply out into items, each of which is one file.
//
//   {"format": "mien-batch", "format_version": 1, "jobs": [
//     {"run": ["render", "{who}", "--emotion", "{feeling}", "--size", "256"],
//      "each": {"who": {"people": 10000, "seed": "crowd"}, "feeling": ["joy", "fear"]},
//      "output": "crowd/{thousand}/{who}-{feeling}.png"},
//     {"run": ["render", "toon", "--size", "65536"], "each": {"at": {"regions": [4, 4]}},
//      "output": "toon/{at}.tif", "join": "toon.tif"}]}
//
// Items are counted from 0, in the jobs' order; within a job the last name changes first. Files that a plan names are seen from its
// folder.

#include "tools/mien/batch/variable.h"

#include <mien/expected.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mien::command {

struct BatchJob {
  std::string where;             ///< in the plan: "FILE:LINE:COLUMN: /jobs/0"
  std::vector<std::string> run;  ///< a command and its arguments, with {names} in them
  std::string output;            ///< a name with {names} in it
  std::optional<std::string> join;
  std::vector<Variable> each;
  long first = 0, count = 1;  ///< of all items

  /// Whether its last name is of pieces of one file.
  bool cuts() const { return !each.empty() && each.back().cuts(); }
};

struct BatchPlan {
  std::string name;  ///< of the file, for messages
  std::vector<BatchJob> jobs;
  long items = 0;
  std::string hash;  ///< of the plan and of all files that its words name
};

inline constexpr long kMostItems = 10'000'000;

/// Reads a plan, multiplies it out and looks at every name. The process must be in the plan's folder (`enter_folder_of`) where
/// relative names lead. Errors have their place.
Expected<BatchPlan> read_batch_plan(const std::filesystem::path& path, const std::string& name);

}  // namespace mien::command
