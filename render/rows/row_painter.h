#pragma once
// One row of pixels from its sums: cells that outlines cross one by one, and runs between them.
//
// What a run looks like is known from the look that its left neighbour noted; it counts only where the
// sum agrees, and then the look's own colour goes on in place of the sum: roundings end there.

#include <mien/render/render_stats.h>
#include <mien/render/rows/row_sums.h>
#include <mien/render/shade/look_shader.h>

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace mien {

/// The looks of a picture as its rows need them.
struct Palette {
  struct Entry {
    Rgba color;  ///< nothing where it varies
    bool varies;
    std::array<std::byte, 16> pixel;  ///< a whole pixel of it
  };
  std::vector<Entry> entries;  ///< by look
  int first = 0;               ///< the look left of the picture
  void make(const Looks& looks, const PixelFormat& format, int first_look);
};

/// Keeps its scratch; one per thread.
class RowPainter {
 public:
  void begin(const Palette& palette, const Looks& looks, const PixelFormat& format, bool dither);

  /// Columns x0 to x1 of the picture's row y; `to` is where x0 goes. Sets the sums back to nothing.
  void paint(int y, RowSums& sums, int row, int x0, int x1, std::byte* to, RenderStats& stats);

  /// Tells what means by centroids neglect of a pixel, in levels of 255; none: nobody asks.
  void note_errors(std::function<void(int x, int y, float levels)> note) {
    note_ = std::move(note);
  }

  /// Columns of that row whose colours vary too much for means by centroids: to be resolved otherwise.
  std::span<const int> refused() const { return refused_; }

 private:
  /// What a varied look takes of the pixels from here on, and of the pixel at hand.
  struct Open {
    int look;
    float height, height_y;
    float area, mx, my;
    std::array<float, PartForm::kRows> left;  ///< its height before this pixel, where forms count
  };
  static Open whole(int look);
  void move_on();
  void run(int from, int until);
  void run_of(int look, int from, int until);
  void cell(int column);
  void take_shares(int column);
  int cell_side() const { return format_->depth() == Depth::u8 ? 16 : 32; }
  Rgba parts(int column, bool by_cells);
  glm::vec4 part(const Open& open, int column, bool by_cells);
  int look_of_run(int column) const;
  bool looks_like(int look) const;
  std::byte* at(int column) const { return to_ + std::size_t(column - x0_) * bytes_; }
  float carry(int x) const;
  bool too_rough(double neglected, const Rgba& mix, int column) const;

  const Palette* palette_ = nullptr;
  const Looks* looks_ = nullptr;
  const PixelFormat* format_ = nullptr;
  bool dither_ = false;
  std::size_t bytes_ = 4;
  LookShader shader_;

  // The row at hand.
  int y_ = 0, x0_ = 0, x1_ = 0;
  std::byte* to_ = nullptr;
  const std::uint16_t* hints_ = nullptr;
  RenderStats* stats_ = nullptr;
  Rgba sum_;
  int look_ = 0;  ///< of the run before
  std::vector<LookShare>* shares_ = nullptr;
  std::size_t next_share_ = 0;
  std::vector<Open> open_;
  struct Formed {
    int look;
    PartStretch stretch;
  };
  std::vector<Formed> formed_;          ///< stretches in the pixel at hand
  std::vector<int> rough_;              ///< columns of a run that cells are asked for
  std::vector<PartStretch> stretches_;  ///< those of one look
  std::vector<int> refused_;
  std::function<void(int, int, float)> note_;
};

}  // namespace mien
