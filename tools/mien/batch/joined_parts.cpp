#include "tools/mien/batch/joined_parts.h"
#include <mien/version.h>
#include "lib/base/one_line.h"
#include "tools/mien/batch/items.h"
#include "tools/mien/batch/part_records.h"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>
#include <utility>

namespace mien::command {
namespace {

class Joining {
 public:
  explicit Joining(const OpenedBatch& batch)
      : batch_(batch), hashes_(std::size_t(batch.plan.items)), from_(hashes_.size(), nullptr) {
    for (long i = 0; i < batch.plan.items; ++i) numbers_[item_of(batch.plan, i).name] = i;
  }

  Expected<Done> add(const PartRecord& record) {
    if (const auto fits = check_header(record); !fits) return fits;
    const PartHeader& header = record.header;
    for (const auto& [name, hash] : record.items) {
      const auto found = numbers_.find(name);
      if (found == numbers_.end()) return refuse(record, name, "is no item of the plan");
      const long i = found->second;
      if (part_of_item(batch_.plan, i, header.of) != header.part)
        return refuse(record, name,
                      fmt::format("belongs to another part than {} of {}", header.part, header.of));
      std::string& known = hashes_[std::size_t(i)];
      const PartRecord*& from = from_[std::size_t(i)];
      if (from == &record) return refuse(record, name, "stands there twice");
      if (from && known != hash)
        return refuse(record, name, "is recorded otherwise in " + from->file);
      known = hash, from = &record;
    }
    return Done{};
  }

  /// `of`: into how many parts the plan was cut, as far as is known.
  Expected<std::vector<std::string>> all(long of) {
    long missing = 0, first = -1;
    for (long i = 0; i < batch_.plan.items; ++i)
      if (!from_[std::size_t(i)] && missing++ == 0) first = i;
    if (missing == 0) return std::move(hashes_);
    return Error{batch_.folder.string(),
                 fmt::format("{} of {} items are missing; the first is {}{}", missing,
                             batch_.plan.items, in_quotes(item_of(batch_.plan, first).name),
                             of > 0 ? fmt::format(", of part {}/{}",
                                                  part_of_item(batch_.plan, first, of), of)
                                    : "")};
  }

 private:
  Error refuse(const PartRecord& record, const std::string& item, const std::string& what) const {
    return {(batch_.folder / record.file).string(), in_quotes(item) + " " + what};
  }

  Expected<Done> check_header(const PartRecord& record) {
    const PartHeader& header = record.header;
    const auto other = [&](const std::string& what) {
      return Error{(batch_.folder / record.file).string(), what};
    };
    if (header.version != MIEN_VERSION_STRING)
      return other(fmt::format("was drawn by mien {}, and this is {}", one_line(header.version, 20),
                               MIEN_VERSION_STRING));
    if (header.plan != batch_.plan.hash)
      return other(
          "is a part of another plan, or of this one before it or a file that it names was "
          "changed");
    if (!instructions_.empty() && header.instructions != instructions_)
      return other(
          fmt::format("was drawn with {} multiply-adds, and other parts with {} ones: bytes "
                      "may differ",
                      one_line(header.instructions, 20), instructions_));
    instructions_ = header.instructions;
    if (header.part > header.of ||
        header.items != count_items(items_of_part(batch_.plan, header.part, header.of)))
      return other("is no part of this plan: it has another number of items");
    return Done{};
  }

  const OpenedBatch& batch_;
  std::unordered_map<std::string, long> numbers_;
  std::vector<std::string> hashes_;
  std::vector<const PartRecord*> from_;
  std::string instructions_;
};

}  // namespace

Expected<std::vector<std::string>> recorded_items(const OpenedBatch& batch) {
  const auto records = read_part_records(batch.folder);
  if (!records) return records.error();
  Joining joining(batch);
  long of = 0;
  // Journals tell of parts that have not ended. They only help to say what is missing.
  for (const PartRecord& record : *records) {
    of = std::max(of, record.header.of);
    if (record.journal) continue;
    if (const auto added = joining.add(record); !added) return added.error();
  }
  return joining.all(of);
}

}  // namespace mien::command
