#include "tools/mien/batch/items.h"
#include "lib/base/one_line.h"
#include "tools/mien/batch/part_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace mien::command {
namespace {

/// What stands for {name}.
std::string value_of(const std::string& name, const BatchItem& item, long in_job) {
  if (name == kThousand)
    return fmt::format("{:0{}}", in_job / 1000,
                       fmt::format("{}", (item.job->count - 1) / 1000).size());
  const auto& each = item.job->each;
  for (std::size_t i = 0; i < each.size(); ++i)
    if (each[i].name == name) return each[i].text(item.at[i]);
  return "{" + name + "}";  // refused when the plan was read
}

long number_in_job(const BatchItem& item) {
  long number = 0;
  for (std::size_t i = 0; i < item.at.size(); ++i)
    number = number * item.job->each[i].count + item.at[i];
  return number;
}

/// As a file system that does not tell case would see it.
std::uint64_t caseless_hash(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : name)
    hash = (hash ^ static_cast<unsigned char>(c >= 'A' && c <= 'Z' ? c + 32 : c)) * 0x100000001b3u;
  return hash;
}

Expected<Done> check_name(const BatchItem& item) {
  const std::string& name = item.name;
  const auto refuse = [&](const char* why) {
    return Error{item.job->where + "/output", fmt::format("{} {}", in_quotes(name), why)};
  };
  if (name.empty() || name.ends_with('/')) return refuse("is no file's name");
  if (name.starts_with('/')) return refuse("must lead into the folder, not begin with a slash");
  for (const auto& part : std::filesystem::path(name))
    if (part == ".." || part == "." || part.empty())
      return refuse("must lead into the folder, without \"..\" and empty parts");
  if (is_record_name(name)) return refuse("is what a part's record is called");
  return Done{};
}

/// Two names of one hash; names that do not differ at all are said so.
Expected<Done> check_twins(const BatchPlan& plan, std::uint64_t hash) {
  std::optional<BatchItem> first;
  for (long i = 0; i < plan.items; ++i) {
    const BatchItem item = item_of(plan, i);
    if (caseless_hash(item.name) != hash) continue;
    if (!first) {
      first = item;
      continue;
    }
    const std::string where = item.job->where + "/output";
    if (first->name == item.name)
      return Error{where,
                   fmt::format("two items are called {}; every name of \"each\" belongs in it",
                               in_quotes(item.name))};
    return Error{where, fmt::format("{} and {} differ by case only, and some file systems take "
                                    "them for one",
                                    in_quotes(first->name), in_quotes(item.name))};
  }
  return Done{};
}

}  // namespace

std::vector<std::string> names_in(const std::string& pattern) {
  std::vector<std::string> names;
  for (std::size_t at = 0; (at = pattern.find('{', at)) != std::string::npos; ++at) {
    const std::size_t end = pattern.find('}', at);
    names.push_back(pattern.substr(at + 1, end == std::string::npos ? end : end - at - 1));
  }
  return names;
}

std::string filled(const std::string& pattern, const BatchItem& item) {
  std::string text;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = pattern.find('{', from)) != std::string::npos;) {
    const std::size_t end = pattern.find('}', at);
    if (end == std::string::npos) break;
    text += pattern.substr(from, at - from);
    text += value_of(pattern.substr(at + 1, end - at - 1), item, number_in_job(item));
    from = end + 1;
  }
  return text + pattern.substr(from);
}

BatchItem item_of(const BatchPlan& plan, long number) {
  const auto after = std::ranges::upper_bound(plan.jobs, number, {}, &BatchJob::first);
  BatchItem item{.job = &*(after - 1), .at = {}, .name = {}};
  long rest = number - item.job->first;
  item.at.resize(item.job->each.size());
  for (std::size_t i = item.at.size(); i-- > 0;) {
    item.at[i] = rest % item.job->each[i].count;
    rest /= item.job->each[i].count;
  }
  item.name = filled(item.job->output, item);
  return item;
}

CommandLine command_of(const BatchItem& item, const std::string& output, bool whole) {
  std::vector<std::string> words{"mien"};
  for (const std::string& word : item.job->run) words.push_back(filled(word, item));
  const std::size_t names = item.at.size() - (whole && !item.at.empty() ? 1 : 0);
  for (std::size_t i = 0; i < names; ++i)
    for (std::string& word : item.job->each[i].arguments(item.at[i]))
      words.push_back(std::move(word));
  words.insert(words.end(), {"-o", output});
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  return read_command_line(int(argv.size()), argv.data());
}

Expected<Done> check_names(const BatchPlan& plan) {
  std::vector<std::uint64_t> hashes;
  hashes.reserve(std::size_t(plan.items));
  for (long i = 0; i < plan.items; ++i) {
    const BatchItem item = item_of(plan, i);
    if (const auto done = check_name(item); !done) return done;
    hashes.push_back(caseless_hash(item.name));
  }
  std::ranges::sort(hashes);
  const auto twin = std::ranges::adjacent_find(hashes);
  return twin == hashes.end() ? Expected<Done>(Done{}) : check_twins(plan, *twin);
}

std::vector<ItemRange> items_of_part(const BatchPlan& plan, long part, long of) {
  std::vector<ItemRange> ranges;
  for (const BatchJob& job : plan.jobs) {
    const long run = (part - 1 + of - job.first % of) % of;
    const ItemRange range{job.first + job.count * run / of, job.first + job.count * (run + 1) / of};
    if (range.first < range.end) ranges.push_back(range);
  }
  return ranges;
}

long part_of_item(const BatchPlan& plan, long item, long of) {
  const BatchJob& job = *item_of(plan, item).job;
  const long run = ((item - job.first + 1) * of + job.count - 1) / job.count - 1;
  return (run + job.first) % of + 1;
}

long count_items(const std::vector<ItemRange>& ranges) {
  long count = 0;
  for (const ItemRange& range : ranges) count += range.end - range.first;
  return count;
}

}  // namespace mien::command
