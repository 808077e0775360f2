#pragma once
// Rows of runs of equal pixels to DEFLATE's tokens.

#include "render/image/png/deflate_writer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mien {

/// Bytes of a row that are coded as one: its filter's number, or one pixel repeated.
struct PixelRun {
  std::uint64_t pixel;  ///< its bytes, the first one lowest; or the filter's number
  std::uint32_t at;     ///< its first byte's place in the strip
  std::uint32_t bytes;  ///< 1: a filter's number
  int before;           ///< the last run whose pixel shares a bucket with it
};

/// What tokens cost, learned from those that came before.
class TokenCosts {
 public:
  static constexpr int kBit = 64;  ///< a row of 2^20 pixels fits an int
  TokenCosts();
  void count(DeflateToken token) { counts_.add(token); }
  void learn();
  int literal(std::uint64_t byte) const { return literals_[byte & 255]; }
  int length(std::size_t n) const { return lengths_[n]; }
  int distance(std::size_t n) const { return distances_[distance_symbol(n).symbol]; }

 private:
  DeflateCounts counts_;
  std::array<int, 256> literals_;
  std::array<int, kDeflateLongest + 1> lengths_;
  std::array<int, DeflateCounts::kDistances> distances_;
};

/// Finds how to code a strip's rows in the fewest bits, run by run and never byte by byte: a run begins with its
/// pixel or a match and goes on as a match with itself. Matches begin where runs do; of a longer run they take the
/// end, so that they go on behind it.
class RunMatcher {
 public:
  explicit RunMatcher(std::size_t pixel_bytes) : pixel_(pixel_bytes) {}

  /// A strip: nothing before it is referred to.
  void begin();
  /// A row is its filter's number and its runs, in order.
  void add(std::uint64_t pixel, std::size_t bytes);
  void end_row(std::vector<DeflateToken>& to);

  /// An upper bound of the bytes that one of these holds, at so many runs a row.
  static std::size_t memory(std::size_t runs);

 private:
  struct Step {
    int cost;
    int from;
    std::uint32_t length, distance,
        rest;  // a match (0: the pixel itself), and the run that goes on
  };
  struct Found {
    std::size_t length, distance;
  };
  Found match(int here, int there) const;
  void try_match(int here, const Found& found);
  void step_from(int here);
  void relax(int from, int to, int cost, const Found& found, std::size_t rest);
  int run_cost(std::size_t bytes) const;
  void put(const Step& step, int run, std::vector<DeflateToken>& to);

  const std::size_t pixel_;
  std::vector<PixelRun> runs_;  // of the strip
  int row_ = 0, row_before_ = -1;
  std::uint32_t at_ = 0;
  std::vector<int> last_;  // run, by bucket
  std::vector<Step> steps_;
  std::vector<int> path_;
  TokenCosts costs_;
};

}  // namespace mien
