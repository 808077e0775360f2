#pragma once
// The mean colour of a look over whole pixels of a row, over parts of pixels, or over one in cells.
//
// A region has no kink inside it (paint_table.h), so over a part of a pixel a ramp along t is its value at the part's
// mean t. For a linear gradient that is t at the centroid, exactly; for a radial one its variances count, too
// (look_lanes.h). What goes by an integral, a distance or light is found one by one and asks for the part's form.

#include "render/shade/color_row.h"
#include "render/shade/look_lanes.h"
#include "render/shade/looks.h"
#include "render/shade/ramp/mean.h"
#include "render/shade/ramp/planes.h"

#include <functional>
#include <vector>

namespace mien {

/// Keeps its scratch; one per thread.
class LookShader {
 public:
  void begin(const Looks& looks) { looks_ = &looks, ramp_rows_.clear(), planes_.begin(); }

  /// Parts of pixels in one row. A pixel's part does not depend on those beside it.
  struct Parts {
    LanePlaces at;
    const float* area;
    std::function<const PartForm&(int part)> form;
  };

  /// Whole pixels of row y, `count` from x on, none beyond the next multiple of kBlock.
  const ColorRow& pixels(int look, int x, int y, int count);
  static constexpr int kBlock = 64;
  const ColorRow& parts(int look, int y, const Parts& parts);
  /// What the last answer neglects, place by place, as a bound; and no less than the largest of that.
  std::span<const float> neglected() const { return neglected_; }
  float most_neglected() const { return most_neglected_; }

  /// The mean over a pixel or a part of one by side × side cells, which reduces what centroids neglect.
  /// `coarse`: within 1e-3 px² a cell, which 8 bits do not show.
  glm::vec4 by_cells(int look, int x, int y, const PartForm* form, int side, bool coarse);

  /// The feet that were looked for since it was last taken, and the time of means with them.
  LitPaint::Scratch::Work take_work() {
    LitPaint::Scratch::Work work = lit_scratch_.take_work();
    work.feet += planes_.take_feet();
    return work;
  }

  /// Columns that want the reference, since the caller emptied it.
  std::vector<LitPaint::Doubt>& doubts() { return lit_scratch_.doubts(); }

 private:
  /// Pixels of a row, a part of one, or one in cells: of all of it or of a part.
  struct Places {
    int x, y, count;
    const LitPart* part = nullptr;
    const PartCells* cells = nullptr;
    const PartForm* form() const;
  };
  template <class Give>
  const ColorRow& shade(int look, double y, const LanePlaces& at, const Give& give);
  LaneStep ramp_step(const LookStep& step, double y) const;
  void linear_step(const PaintField& field, double y, LaneStep& made) const;
  void radial_step(const LookStep& step, double y, LaneStep& made) const;
  void give(const LookStep& step, const Places& at, std::size_t first, ColorRow& to);
  void give_light(const LookStep& step, const Places& at, std::size_t first, ColorRow& to);
  void give_means(const LookStep& step, const Places& at, std::size_t first, ColorRow& to);
  const LitPaint* lit_of(const VariedPaint& varied) const {
    return varied.lit < 0 ? nullptr : &looks_->paints().lit[std::size_t(varied.lit)];
  }
  glm::vec4 with_products(const VariedPaint& varied, const glm::vec4& mean, float& off);
  Mix ramp_mean_of_part(const LookStep& step, const Places& at);
  void give_means_of_cells(const LookStep& step, const Places& at, ColorRow& to);

  const Looks* looks_ = nullptr;
  std::vector<LaneStep> steps_;
  std::vector<ColorRow> given_;        ///< by step
  std::vector<ColorRow*> given_rows_;  ///< those of the look at hand
  std::vector<float> stack_, neglected_, columns_;
  float most_neglected_ = 0;
  ColorRow colors_;
  PartCells cells_;
  RampPlanes planes_;
  RampRows ramp_rows_;
  RampBoxes boxes_;
  std::vector<RampPlane> cell_planes_;
  RampPartMean part_mean_;
  std::vector<PartChord> chords_;
  bool each_ = false;  ///< cells of lit paints are looked at one by one
  LitPaint::Scratch lit_scratch_;
};

}  // namespace mien
