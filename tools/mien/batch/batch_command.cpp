// mien batch: one part of a plan's items, each drawn by its command, or left as it is where it is whole already.

#include "lib/base/one_line.h"
#include "tools/mien/batch/drawn_items.h"
#include "tools/mien/batch/opened_batch.h"
#include "tools/mien/batch/part_records.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/output/sha256.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/progress_display.h"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>
#include <vector>

namespace mien::command {
namespace {

namespace fs = std::filesystem;

constexpr long kMostParts = 1'000'000;

struct PartOf {
  long part = 1, of = 1;
};

Expected<PartOf> read_part(const std::string& text) {
  const Error wrong{"--part " + one_line(text, 60),
                    "expected K/N, the K-th of N parts, 1/4 to 4/4"};
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return wrong;
  const auto of = read_whole("--part", text.substr(slash + 1), 1, kMostParts);
  if (!of) return wrong;
  const auto part = read_whole("--part", text.substr(0, slash), 1, *of);
  if (!part) return wrong;
  return PartOf{*part, *of};
}

/// The work on one part.
class PartWork {
 public:
  PartWork(const OpenedBatch& batch, const PartOf& which)
      : batch_(batch),
        ranges_(items_of_part(batch.plan, which.part, which.of)),
        header_(header_here(batch.plan.hash, which.part, which.of, count_items(ranges_))),
        drawer_(batch.plan, batch.folder) {}

  int run() {
    if (const auto read = read_records(); !read) return complain(read.error(), kFailed);
    {
      ProgressDisplay display;
      whole_ = display.watch("items");
      for (const ItemRange& range : ranges_)
        for (long i = range.first; i < range.end;)
          if (const int code = step(i, range.end); code != kDone) return code;
      whole_(1);
    }
    if (const auto done = finish(); !done) return complain(done.error(), kFailed);
    return print(fmt::format("{} items: {} drawn, {} there already\n", items_.size(),
                             long(items_.size()) - kept_, kept_));
  }

 private:
  /// Those of other splits tell of the same items; those of this split's other parts do not.
  Expected<Done> read_records() {
    const auto records = read_part_records(batch_.folder);
    if (!records) return records.error();
    for (const PartRecord& record : *records) {
      const PartHeader& other = record.header;
      if (other.plan != header_.plan || other.version != header_.version ||
          other.instructions != header_.instructions ||
          (other.of == header_.of && other.part != header_.part))
        continue;
      for (const auto& [item, hash] : record.items) known_[item] = hash;
      if (other.of != header_.of) continue;
      if (record.journal)
        journals_.push_back(batch_.folder / record.file);
      else
        manifest_ = record.items;
    }
    return Done{};
  }

  /// Of the part, once so many items are done.
  double share(std::size_t done) const {
    return double(done) / double(std::max(header_.items, 1l));
  }

  /// The item, or those before `range_end` that are drawn with it; moves `i` behind them.
  int step(long& i, long range_end) {
    if (!whole_(share(items_.size()))) return complain("interrupted", kFailed);
    const BatchItem item = item_of(batch_.plan, i);
    if (is_whole(item)) {
      items_.emplace_back(item.name, known_.at(item.name));
      ++kept_, ++i;
      return kDone;
    }
    if (interrupted()) return complain("interrupted", kFailed);
    const long count = missing(i, range_end);
    if (const auto begun = begin_journal(); !begun) return complain(begun.error(), kFailed);
    const double from = share(items_.size()), to = share(items_.size() + std::size_t(count));
    if (const int code = drawer_.draw(i, count, whole_, from, to); code != kDone) return code;
    for (const long end = i + count; i < end; ++i)
      if (const auto done = record(item_of(batch_.plan, i)); !done)
        return interrupted() ? complain("interrupted", kFailed) : complain(done.error(), kFailed);
    return kDone;
  }

  /// So many from i on are drawn together.
  long missing(long i, long range_end) const {
    const long together = drawer_.together(i, range_end);
    long count = 1;
    while (count < together && !is_whole(item_of(batch_.plan, i + count))) ++count;
    return count;
  }

  bool is_whole(const BatchItem& item) const {
    const auto known = known_.find(item.name);
    if (known == known_.end()) return false;
    const auto hash = sha256_of_file(drawer_.path_of(item));
    return hash && *hash == known->second;
  }

  Expected<Done> begin_journal() {
    if (journal_) return Done{};
    auto begun = PartJournal::begin(batch_.folder, header_);
    if (!begun) return begun.error();
    journal_.emplace(*std::move(begun));
    journals_.push_back(journal_->path());
    return Done{};
  }

  Expected<Done> record(const BatchItem& item) {
    const auto hash = sha256_of_file(drawer_.path_of(item));
    if (!hash) return hash.error();
    items_.emplace_back(item.name, *hash);
    return journal_->add(item.name, *hash);
  }

  /// The manifest first, and then what it replaces.
  Expected<Done> finish() {
    if (!manifest_ || *manifest_ != items_)
      if (const auto done = write_manifest_file(batch_.folder, header_, items_); !done)
        return done.error();
    std::error_code failed;  // a journal that stays does no harm
    for (const fs::path& journal : journals_) fs::remove(journal, failed);
    return Done{};
  }

  const OpenedBatch& batch_;
  const std::vector<ItemRange> ranges_;
  const PartHeader header_;
  ItemDrawer drawer_;
  Progress whole_;
  std::unordered_map<std::string, std::string> known_;  // items and their hashes, of earlier runs
  std::vector<std::pair<std::string, std::string>> items_;
  std::optional<std::vector<std::pair<std::string, std::string>>> manifest_;  // of an earlier run
  std::optional<PartJournal> journal_;
  std::vector<fs::path> journals_;
  long kept_ = 0;
};

}  // namespace

int batch_command(const BatchArguments& arguments) {
  const auto which = read_part(arguments.part.value_or("1/1"));
  if (!which) return complain(which.error(), kUsedWrongly);
  // Until something is written, Ctrl-C may end the process where it is.
  const auto batch = open_batch(arguments.plan, arguments.output);
  if (!batch) return complain(batch.error(), kFailed);
  watch_interrupts();
  std::error_code failed;
  fs::create_directories(batch->folder, failed);
  if (failed) return complain({arguments.output, "cannot be made: " + failed.message()}, kFailed);
  const int code = PartWork(*batch, *which).run();
  if (code != kDone && interrupted()) die_of_interrupt();
  return code;
}

}  // namespace mien::command
