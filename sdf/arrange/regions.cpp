#include "sdf/arrange/regions.h"
#include "lib/base/watch.h"

#include <algorithm>

namespace mien {
namespace {

/// The splitmix64 sequence (Steele, Lea and Flood 2014). Crossing an outline xors its key into the hash. Some two
/// of n regions share a hash with a probability of n² / 2⁶⁵.
std::uint64_t key_of(std::uint64_t i) {
  std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

constexpr std::size_t kFirstTable = 1024;

}  // namespace

void Regions::begin(int outlines, LookRule& rule) {
  rule_ = &rule;
  set_words_ = (outlines + 63) / 64;
  stride_ = set_words_ + rule.state_words();
  while (keys_.size() < std::size_t(outlines)) keys_.push_back(key_of(keys_.size()));
  words_.assign(std::size_t(stride_), 0);
  hashes_.assign(1, 0);
  if (table_.size() > 16 * kFirstTable) table_.resize(kFirstTable);  // after a crowded picture
  table_.assign(std::max(table_.size(), kFirstTable), -1);
  table_[0] = 0;
  looks_.assign(1, rule.first_look(words_.data() + set_words_));
}

int Regions::across(int region, int outline) {
  const std::uint64_t hash = hashes_[std::size_t(region)] ^ keys_[std::size_t(outline)];
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = hash & mask; table_[i] >= 0; i = (i + 1) & mask)
    if (hashes_[std::size_t(table_[i])] == hash) return table_[i];
  worked(100 + 2 * stride_);
  const int made = add(hash);
  std::uint64_t* const to = words_.data() + std::size_t(made) * std::size_t(stride_);
  const std::uint64_t* const from = words(region);
  std::copy(from, from + stride_, to);
  to[outline >> 6] ^= std::uint64_t{1} << (outline & 63);
  looks_.push_back(rule_->look(to, outline, from + set_words_, look(region), to + set_words_));
  return made;
}

int Regions::add(std::uint64_t hash) {
  const int made = int(hashes_.size());
  hashes_.push_back(hash);
  words_.resize(hashes_.size() * std::size_t(stride_));
  if (2 * hashes_.size() > table_.size()) {
    grow_table();
    return made;
  }
  std::size_t i = hash & (table_.size() - 1);
  while (table_[i] >= 0) i = (i + 1) & (table_.size() - 1);
  table_[i] = made;
  return made;
}

void Regions::grow_table() {
  table_.assign(2 * table_.size(), -1);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t region = 0; region < hashes_.size(); ++region) {
    std::size_t i = hashes_[region] & mask;
    while (table_[i] >= 0) i = (i + 1) & mask;
    table_[i] = int(region);
  }
}

}  // namespace mien
