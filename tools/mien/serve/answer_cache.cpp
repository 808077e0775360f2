#include "tools/mien/serve/answer_cache.h"

namespace mien::command {

const DrawnFace* AnswerCache::find(std::string_view meaning) {
  const auto found = by_meaning_.find(meaning);
  if (found == by_meaning_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return &found->second->drawn;
}

void AnswerCache::put(const std::string& meaning, const DrawnFace& drawn) {
  if (by_meaning_.contains(meaning)) return;  // of one meaning there is one picture
  Entry entry{meaning, drawn};
  if (entry.bytes() > most_bytes_) return;
  bytes_ += entry.bytes();
  entries_.push_front(std::move(entry));
  by_meaning_.emplace(entries_.front().meaning, entries_.begin());
  while (bytes_ > most_bytes_) {
    bytes_ -= entries_.back().bytes();
    by_meaning_.erase(entries_.back().meaning);
    entries_.pop_back();
  }
}

}  // namespace mien::command
