#pragma once
// The items of a plan: which file each is, and what makes it.

#include "tools/mien/batch/batch_plan.h"
#include "tools/mien/cli/command_line.h"

namespace mien::command {

/// Built into every job: an item's number in its job, by thousands, for folders of a thousand files.
inline constexpr char kThousand[] = "thousand";

struct BatchItem {
  const BatchJob* job = nullptr;
  std::vector<long> at;  ///< of each of the job's names
  std::string name;      ///< of its file, with slashes
};

BatchItem item_of(const BatchPlan& plan, long number);

/// A template's text for the item.
std::string filled(const std::string& pattern, const BatchItem& item);
/// Names in braces in a template; an open brace that closes nowhere is one to the end.
std::vector<std::string> names_in(const std::string& pattern);

/// The arguments of its command, read. `output`: where its file goes. `whole`: without what its last name adds.
CommandLine command_of(const BatchItem& item, const std::string& output, bool whole = false);

/// An error if two names of files are one, or differ by case only, or none can be had of one.
Expected<Done> check_names(const BatchPlan& plan);

/// Numbers of items, the last one left out.
struct ItemRange {
  long first = 0, end = 0;
};
/// The items of the `part`-th of `of` parts, counted from 1. Each job is cut into so many runs of items that follow one another, as
/// evenly as it goes, so that every part has its share of what is slow; jobs of few items begin at other parts by turns.
std::vector<ItemRange> items_of_part(const BatchPlan& plan, long part, long of);
/// The part to which an item belongs.
long part_of_item(const BatchPlan& plan, long item, long of);
long count_items(const std::vector<ItemRange>& ranges);

}  // namespace mien::command
