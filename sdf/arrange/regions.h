#pragma once
// The regions of an arrangement: the set of outlines that a place is inside of, and what it looks like.
//
// A sweep only ever crosses one outline at a time, so a region is found from its neighbour by a hash
// that changes with the outline crossed: one look-up, whatever the number of outlines.

#include <cstdint>
#include <span>
#include <vector>

namespace mien {

/// Says what a set of outlines looks like, as a number; equal numbers look alike. Asked once for every region. It
/// keeps words of its own for each region, so that it need not start from nothing.
class LookRule {
 public:
  virtual ~LookRule() = default;
  virtual int state_words() const = 0;
  /// Held by it.
  virtual std::size_t bytes() const { return 0; }
  /// Inside of no outline. Writes the region's words.
  virtual int first_look(std::uint64_t* state) = 0;
  /// After crossing `outline`; `before` are the words of the region on the near side, whose look is known.
  virtual int look(const std::uint64_t* inside, int outline, const std::uint64_t* before,
                   int look_before, std::uint64_t* state) = 0;
};

/// All regions met so far. Region 0 is inside of nothing.
class Regions {
 public:
  /// Begins again; memory is kept.
  void begin(int outlines, LookRule& rule);

  /// The region on the other side of an outline.
  int across(int region, int outline);

  int look(int region) const { return looks_[std::size_t(region)]; }
  int count() const { return int(looks_.size()); }
  /// Held by all of them.
  std::size_t bytes() const {
    return words_.capacity() * sizeof(words_[0]) + hashes_.capacity() * sizeof(hashes_[0]) +
           (looks_.capacity() + table_.capacity()) * sizeof(int) + (rule_ ? rule_->bytes() : 0);
  }
  bool inside(int region, int outline) const {
    return words(region)[outline >> 6] >> (outline & 63) & 1;
  }

 private:
  const std::uint64_t* words(int region) const {
    return words_.data() + std::size_t(region) * std::size_t(stride_);
  }
  int add(std::uint64_t hash);
  void grow_table();

  LookRule* rule_ = nullptr;
  int set_words_ = 0, stride_ = 0;
  std::vector<std::uint64_t> keys_;   ///< of outlines
  std::vector<std::uint64_t> words_;  ///< of regions: the set, then the rule's own
  std::vector<std::uint64_t> hashes_;
  std::vector<int> looks_;
  std::vector<int> table_;  ///< open addressing, a power of two; −1: free
};

}  // namespace mien
