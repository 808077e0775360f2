#include "tools/mien/batch/plan_hash.h"
#include "tools/mien/batch/items.h"
#include "tools/mien/cli/named_file.h"
#include "tools/mien/output/sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

namespace mien::command {
namespace {

constexpr long kMostTexts = 100'000;  // of one word: more are numbers, hardly files

/// Whether its values may be names of files.
bool names_files(const Variable& variable) {
  return variable.kind == Variable::Kind::words || variable.kind == Variable::Kind::numbers;
}

/// All texts that a word of a job has.
void add_texts(const std::string& word, const BatchJob& job, std::set<std::string>& to) {
  BatchItem item{.job = &job, .at = std::vector<long>(job.each.size(), 0), .name = {}};
  std::vector<std::size_t> varied;
  long count = 1;
  for (const std::string& name : names_in(word))
    for (std::size_t i = 0; i < job.each.size(); ++i) {
      if (job.each[i].name != name || std::ranges::count(varied, i) > 0) continue;
      if (!names_files(job.each[i])) return;
      varied.push_back(i);
      count = count > kMostTexts ? count : count * job.each[i].count;
    }
  if (count > kMostTexts) return;
  for (long k = 0; k < count; ++k) {
    long rest = k;
    for (const std::size_t i : varied) {
      item.at[i] = rest % job.each[i].count;
      rest /= job.each[i].count;
    }
    to.insert(filled(word, item));
  }
}

bool is_file(const std::string& path) {
  std::error_code failed;
  return std::filesystem::is_regular_file(path, failed);
}

}  // namespace

Expected<std::string> plan_hash(const BatchPlan& plan, std::string_view text) {
  std::set<std::string> texts;
  for (const BatchJob& job : plan.jobs) {
    for (const std::string& word : job.run) add_texts(word, job, texts);
    for (const Variable& one : job.each)
      if (!one.file.empty()) texts.insert(one.file);
  }
  std::string all(text);
  for (const std::string& one : texts)
    for (const std::string& path : {one, name_and_file(one).second}) {
      if (path.empty() || !is_file(path)) continue;
      const auto hash = sha256_of_file(path);
      if (!hash) return hash.error();
      all += fmt::format("\n{} {}", *hash, path);
      break;
    }
  return sha256(std::as_bytes(std::span(all)));
}

}  // namespace mien::command
