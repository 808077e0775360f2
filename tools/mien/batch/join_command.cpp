// mien join: whether everything that a plan asks for is there and whole, and one file of pieces.

#include "render/image/load_encoder.h"
#include "tools/mien/batch/items.h"
#include "tools/mien/batch/joined_parts.h"
#include "tools/mien/batch/joined_pieces.h"
#include "tools/mien/batch/opened_batch.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/output/sha256.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/outer_work.h"
#include "tools/mien/terminal/progress_display.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace mien::command {
namespace {

/// Every file has the hash that its part recorded. The first that has not is told, in the plan's order.
Expected<Done> check_files(const OpenedBatch& batch, const std::vector<std::string>& hashes) {
  std::mutex mutex;
  long first = batch.plan.items, wrong = 0;
  Error why;
  watched_for("check", int(batch.plan.items), {}, [&](int i) {
    const BatchItem item = item_of(batch.plan, i);
    const auto hash = sha256_of_file(batch.folder / item.name);
    if (interrupted() || (hash && *hash == hashes[std::size_t(i)])) return;
    const std::lock_guard lock(mutex);
    ++wrong;
    if (i > first) return;
    first = i;
    why = hash ? Error{(batch.folder / item.name).string(), "is not the file that was recorded"}
               : hash.error();
  });
  if (wrong == 0) return Done{};
  return Error{why.where,
               fmt::format("{}{}", why.what,
                           wrong > 1 ? fmt::format(", and {} more are wrong", wrong - 1) : "")};
}

/// Everything that the plan joins.
int join_all(const OpenedBatch& batch, const std::vector<std::string>& hashes, long& joined) {
  long pieces = 0, done = 0;
  for (const BatchJob& job : batch.plan.jobs) pieces += job.join ? job.count : 0;
  ProgressDisplay display;
  const Progress whole = display.watch("join");
  for (const BatchJob& job : batch.plan.jobs) {
    if (!job.join) continue;
    const long each = job.each.back().count;
    for (long i = 0; i < job.count; i += each, done += each, ++joined) {
      const OuterWork within(job.where + "/join", whole, double(done) / double(pieces),
                             double(done + each) / double(pieces));
      if (const int code = join_pieces(batch, job.first + i, hashes); code != kDone) return code;
    }
  }
  return kDone;
}

}  // namespace

int join_command(const JoinArguments& arguments) {
  const auto batch = open_batch(arguments.plan, arguments.folder);
  if (!batch) return complain(batch.error(), kFailed);
  const auto hashes = recorded_items(*batch);
  if (!hashes) return complain(hashes.error(), kFailed);
  if (std::ranges::any_of(batch->plan.jobs,
                          [](const BatchJob& job) { return job.join.has_value(); }))
    if (const auto ready = prepare_to_read(); !ready) return complain(ready.error(), kFailed);
  if (const auto whole = check_files(*batch, *hashes); !whole)
    return complain(whole.error(), kFailed);
  long joined = 0;
  const int code = join_all(*batch, *hashes, joined);
  if (code != kDone && interrupted()) die_of_interrupt();
  if (code != kDone) return code;
  return print(fmt::format("{} items, all whole; {} joined\n", batch->plan.items, joined));
}

}  // namespace mien::command
