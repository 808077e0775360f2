#pragma once
// Items become files, by the commands that a plan names.

#include "tools/mien/batch/items.h"
#include "tools/mien/data/stimulus_plan.h"

#include <mien/progress.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mien::command {

/// Draws items of a plan into a folder. Errors have been printed; the exit code tells.
class ItemDrawer {
 public:
  ItemDrawer(const BatchPlan& plan, std::filesystem::path folder)
      : plan_(plan), folder_(std::move(folder)) {}

  /// Items from `first` on, but none from `end` on, that one command makes together: frames of one film whose names differ by
  /// their numbers alone. Else 1.
  long together(long first, long end) const;

  /// Draws so many items; `whole` is told shares from `from` to `to`.
  int draw(long first, long count, const Progress& whole, double from, double to);

  std::filesystem::path path_of(const BatchItem& item) const { return folder_ / item.name; }

 private:
  int make_folder(const BatchItem& item);
  int draw_stimulus(const BatchItem& item);

  struct Experiment {
    StimulusPlan plan;
    std::vector<Stimulus> what;
  };

  const BatchPlan& plan_;
  const std::filesystem::path folder_;
  std::filesystem::path made_;                     // the last folder that was made
  std::map<std::string, Experiment> experiments_;  // by their plan's file
};

/// How `mien animate` calls the frames: the item's name with %05d for its number.
std::string frame_pattern(const BatchItem& item);

}  // namespace mien::command
