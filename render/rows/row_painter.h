#pragma once
// One row of pixels from its sums: the cells that outlines cross, one by one, and the runs between them.
//
// The fragment left of a run noted the run's look. That look counts only where the sum agrees; then its own colour
// replaces the sum, so rounding errors end there.

#include <mien/render_stats.h>
#include "render/cover/part_moments.h"
#include "render/rows/error_notes.h"
#include "render/rows/row_sums.h"
#include "render/rows/stores.h"
#include "render/shade/look_shader.h"

#include <array>
#include <span>
#include <vector>

namespace mien {

/// The looks of a picture as its rows need them.
struct Palette {
  struct Entry {
    Rgba color;  ///< nothing where it varies
    bool varies;
    RunPattern pixels;  ///< whole ones of it
  };
  std::vector<Entry> entries;  ///< by look
  bool any_varies = false;
  int first = 0;  ///< the look left of the picture
  void make(const Looks& looks, const PixelFormat& format, int first_look);
};

/// Keeps its scratch; one per thread.
class RowPainter {
 public:
  void begin(const Palette& palette, const Looks& looks, const PixelFormat& format, bool dither,
             Stores stores = Stores::ordinary);

  /// Columns x0 to x1 of the picture's row y; `to` is where x0 goes. Resets the sums to zero.
  void paint(int y, RowSums& sums, int row, int x0, int x1, std::byte* to, RenderStats& stats);

  /// Where to write what means by centroids neglect of a pixel, and which are estimated; null: nobody asks.
  void note_errors(const ErrorNotes* notes) { notes_ = notes; }

  /// Adds the work of the rows since the last call.
  void tell(RenderStats& stats) {
    const LitPaint::Scratch::Work work = shader_.take_work();
    stats.distances += work.feet, stats.distance_seconds += work.seconds;
  }

  /// Columns of that row whose colours vary too much for means by centroids, or see too many branches: the caller
  /// resolves them by distances.
  std::span<const int> refused() const { return refused_; }

 private:
  static constexpr int kBlock = LookShader::kBlock;
  /// Area and moments about a pixel's middle.
  struct Moments {
    float area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  /// What bounds something from the left: shares from `since` on, as they were taken, and all of the row's border.
  struct LeftBound {
    int since;
    bool whole;
    bool operator==(const LeftBound&) const = default;
  };
  /// What enters pixels of a look from the left, up to a share.
  struct Entered {
    int look;
    LeftBound left;
    int until;
  };
  /// What a varied look takes of the pixels from here on, and of the current one.
  struct Open {
    int look;
    LeftBound left;
    float height, height_y, height_yy;
    Moments here;
    /// As if no outline crossed the pixel.
    void go_on() { here = {height, 0.0f, height_y, height / 12, 0.0f, height_yy}; }
  };
  /// A look's part of a pixel.
  struct Part {
    int look, cell;  ///< the latter among those kept
    LeftBound left;
    int before, until;  ///< shares taken: before its pixel, and in it, too
    Moments of;
    Rgba color;
    float neglected;
  };
  Open whole(int look) const;
  void paint_varied(RowSums& sums, int row);
  void paint_flat(RowSums& sums, int row);
  Rgba flat_run(int from, int until, const Rgba& sum);
  RunPattern pattern_of(const Rgba& mix) const;
  void fill(int first, int end, const RunPattern& pattern);
  void run(int from, int until);
  void run_of(int look, int from, int until);
  void cell(int column, int before);
  void take_shares(int first);
  void take(int look, float sign, int share);
  void sort_parts();
  void shade_parts();
  void shade_look(std::size_t first, std::size_t count);
  void lay_parts();
  Rgba parts_in_cells(std::size_t first, std::size_t end, int side);
  const PartForm& form(const Part& part);
  int look_of_run(int column);
  bool looks_like(int look) const;
  std::byte* at(int column) const { return to_ + std::size_t(column - x0_) * bytes_; }
  void mend_run(int look, int from, int count, const ColorRow& colors);
  void keep_cell(const Rgba& mix, float carry, int column);
  void put_cells();
  void refuse_doubtful();
  void set_thresholds();
  void room_for(std::size_t cells);
  float threshold(int column) const { return thresholds_[std::size_t(column % kBlock)]; }
  int cells_for(double neglected, const Rgba& mix, int column) const;

  const Palette* palette_ = nullptr;
  const Looks* looks_ = nullptr;
  const PixelFormat* format_ = nullptr;
  bool dither_ = false;
  Stores stores_ = Stores::ordinary;
  double allowed_ = 0;  ///< how much may be neglected
  double least_ = 0;    ///< how much is not even looked at
  std::size_t bytes_ = 4;
  LookShader shader_;

  // The row at hand.
  int y_ = 0, x0_ = 0, x1_ = 0;
  std::byte* to_ = nullptr;
  const int* hints_ = nullptr;
  RenderStats* stats_ = nullptr;
  Rgba sum_;
  int look_ = 0;  ///< of the run before
  std::span<const LookShare> shares_;
  std::span<const PartStretch> stretches_;
  PartMoments moments_;     ///< of the stretches
  std::vector<int> taken_;  ///< shares, in the order of columns
  std::vector<Open> open_;
  std::vector<Part> parts_;  ///< cell by cell
  std::vector<std::pair<int, int>>
      by_look_;                     ///< of sorted parts: where those of one begin, and how many
  std::vector<int> index_of_look_;  ///< in that
  std::vector<int> sorted_;         ///< parts
  ColorRow places_, variances_;     ///< of sorted parts: column, x, y, area; xx, xy, yy
  PartForm form_;
  Entered entered_{};  ///< what `form_.left` holds
  std::vector<PartStretch> in_pixel_;
  std::vector<std::pair<int, int>> rough_;  ///< columns of a run, and cells to see them in
  std::vector<int> refused_;
  ColorRow cells_;  ///< mixed, to be put together, after the runs
  std::vector<int> columns_;
  int kept_ = 0;
  std::vector<float> carries_;
  std::vector<std::byte> made_;
  std::array<float, kBlock + kColorSpare> thresholds_;  ///< of the row's dither
  const ErrorNotes* notes_ = nullptr;
};

}  // namespace mien
