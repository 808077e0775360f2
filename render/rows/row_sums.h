#pragma once
// Jumps of colour summed into the cells of some rows, and the parts of pixels that varied looks take.
//
// A fragment that leaves area a of a pixel, and dy of all those after it, to its right adds
// jump · a to the pixel and jump · (dy − a) to the next: a running sum along the row is the picture.

#include "render/cover/cells.h"
#include "render/cover/part_form.h"
#include "render/rows/pixel_format.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mien {

/// What a stretch of outline beside a varied look leaves to its right: area of its pixel, and of every pixel after it.
struct LookShare {
  int next;         ///< of the same pixel; −1: no more
  int left, right;  ///< looks that vary; −1: it does not
  float area, rest;
};

class RowSums {
 public:
  /// Empty rows of so many pixels.
  void begin(int rows, int width);

  /// A fragment's cells; `first` is the row of the picture that is row 0 here, heights lie within the
  /// rows. `jump`: right colour minus left; looks that vary are −1 or an index.
  void add(const OutlinePiece& piece, double top, double bottom, int first, const Rgba& jump,
           int left_varied, int right_varied, int right_look);

  /// Row by row: its sums, which the reader resets to zero; a bit for each column that outlines cross (the one
  /// after it has a sum, too); and the shares of varied looks.
  Rgba* sums(int row) { return sums_.data() + std::size_t(row) * stride_; }
  std::uint64_t* marks(int row) { return marks_.data() + std::size_t(row) * mark_words_; }
  const int* hints(int row) const { return hints_.data() + std::size_t(row) * stride_; }
  /// Of a row, in any order; and each one's stretch, of sign 1.
  std::span<const LookShare> shares(int row) const { return shares_[std::size_t(row)]; }
  std::span<const PartStretch> stretches(int row) const { return stretches_[std::size_t(row)]; }
  /// By column: its first share; −1: none. The reader resets them.
  int* first_shares(int row) { return first_shares_.data() + std::size_t(row) * stride_; }
  void forget_shares(int row) {
    shares_[std::size_t(row)].clear(), stretches_[std::size_t(row)].clear();
  }
  int mark_words() const { return int(mark_words_); }
  long long cells() const { return cells_; }  ///< since it was made

 private:
  void share(int row, int column, const CellPart& part, const PartStretch& stretch, int left_varied,
             int right_varied);

  long long cells_ = 0;
  int width_ = 0;
  std::size_t stride_ = 0, mark_words_ = 0;
  std::vector<Rgba> sums_;
  std::vector<std::uint64_t> marks_;
  std::vector<int> hints_;  ///< the look that may follow a cell
  std::vector<int> first_shares_;
  std::vector<std::vector<LookShare>> shares_;
  std::vector<std::vector<PartStretch>> stretches_;
};

}  // namespace mien
