#pragma once
// What a region looks like: one colour, or how to find the colour of a place.
//
// A region is a set of outlines. The layers whose programs hold there are laid over each other, from the topmost
// opaque one up; constant colours are composited at once. Looks made alike are one look: no outline is seen between
// them.

#include "render/shade/paint_table.h"
#include "sdf/arrange/regions.h"
#include "sdf/outline/area_tests.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mien {

/// One step of composing the colour of a place, in order.
struct LookStep {
  enum class Kind : unsigned char {
    open,   ///< begin with `mix`: the picture's ground, or a group's
    over,   ///< lay `mix` over it, by `mode`
    paint,  ///< lay a varied paint over it, in one of the segments between its kinks
    close   ///< the group ends: lay it over what was there, times mix.a, by `mode`
  } kind;
  int varied = -1, segment = 0;  ///< of `paint`; segment −1: all of the ramp, by its integral
  int zone = -1;                 ///< of a lit paint, where it is not level; −1: its ramp alone
  MixMode mode = MixMode::normal;
  Mix mix{0.0};
};

class Looks final : public LookRule {
 public:
  /// Begins anew; memory is kept. The table must outlive its use here.
  void begin(const PaintTable& paints);

  int state_words() const override { return words_; }
  std::size_t bytes() const override {
    return looks_.capacity() * sizeof(Look) + steps_.capacity() * sizeof(LookStep);
  }
  int first_look(std::uint64_t* state) override;
  int look(const std::uint64_t* inside, int outline, const std::uint64_t* before, int look_before,
           std::uint64_t* state) override;

  int count() const { return int(looks_.size()); }
  bool constant(int look) const { return looks_[std::size_t(look)].count == 1; }
  /// The colour of a constant look; nothing of another.
  const Mix& mix(int look) const { return looks_[std::size_t(look)].mix; }
  std::span<const LookStep> steps(int look) const {
    const Look& l = looks_[std::size_t(look)];
    return std::span(steps_).subspan(std::size_t(l.first), std::size_t(l.count));
  }
  const RampSegment& segment(const LookStep& step) const {
    return segments_[std::size_t(first_segment_[std::size_t(step.varied)] + step.segment)];
  }
  /// Of all of the ramp, or of its segment along a distance.
  const RampIntegral& integral(const LookStep& step) const {
    return step.segment < 0
               ? paints_->varied[std::size_t(step.varied)].integral
               : along_[std::size_t(first_segment_[std::size_t(step.varied)] + step.segment)];
  }
  /// Whether means of a step that is not lit are by integrals.
  bool by_integral(const LookStep& step) const {
    return step.segment < 0 ||
           paints_->varied[std::size_t(step.varied)].paint.field.kind == PaintField::Kind::distance;
  }
  const PaintTable& paints() const { return *paints_; }

  /// What a ramp between two kinks changes by per pixel.
  double slope_of(const LookStep& step) const;
  /// A bound on the error of means by centroids, in the blending space. Of two ramps over each other the mean of
  /// the product differs from the product of the means, by a twelfth of the product of their changes per pixel.
  double neglected(int look) const { return looks_[std::size_t(look)].neglected; }
  /// Whether its means are LitPaint's, in part, whose error has no proven bound.
  bool estimated(int look) const;
  /// Whether cells do not help either, so that its pixels are resolved by distances: it is lit and its ramp has too
  /// many kinks, or two such ramps lie over each other and do not cross.
  bool open(int look) const { return looks_[std::size_t(look)].open; }
  /// Whether a paint's opacity varies.
  bool fades(const LookStep& step) const;
  /// Where two ramps with integrals lie over each other, one along a distance, or light under what fades or mixes: that
  /// one. Else null.
  const VariedPaint* products(int look) const {
    const int varied = looks_[std::size_t(look)].products;
    return varied < 0 ? nullptr : &paints_->varied[std::size_t(varied)];
  }

 private:
  struct Look {
    Mix mix;
    double neglected;
    bool open;
    int products;  ///< index into PaintTable::varied; −1: none
    int first, count;
    std::uint64_t hash;
  };
  struct Lie {
    int zone = 0;
    bool slopes = false;
  };
  Lie lie_of(const VariedPaint& paint, const std::uint64_t* inside);
  struct Level {
    bool varies = false;  ///< steps are written
    Mix mix{0.0};         ///< of what is constant since
  };
  void note_outlines();
  void make_segments();
  void note_test(const AreaProgram& program);
  bool holds(const AreaProgram& program, const std::uint64_t* inside) const;
  int segment_of(int varied, const std::uint64_t* inside);
  int compose(const std::uint64_t* inside, const std::uint64_t* covered);
  void lay_over(const Mix& mix);
  void lay_group(const Mix& mix, MixMode mode);
  void lay_paint(int varied, const std::uint64_t* inside);
  void write_pending(Level& level, bool opens);
  void enter_group(int group);
  void leave_groups(std::size_t depth);
  int known_or_new(std::size_t first_step);
  // looks_neglected.cpp
  double neglected_by(std::span<const LookStep> steps);
  bool open_by(std::span<const LookStep> steps) const;
  int products_of(std::span<const LookStep> steps) const;

  const PaintTable* paints_ = nullptr;
  int words_ = 0;
  std::vector<Look> looks_;
  std::vector<LookStep> steps_;
  std::vector<int> table_;  ///< of looks by hash, open addressing

  // Layers of outlines: those whose program or paint reads them.
  std::vector<int> first_reader_, readers_;
  std::vector<std::pair<int, int>> reading_;
  std::vector<char> kink_;             ///< by outline: some paint's kink
  std::vector<std::uint64_t> opaque_;  ///< a bit per layer
  std::vector<int> first_segment_;     ///< by varied paint
  std::vector<RampSegment> segments_;
  std::vector<RampIntegral> along_;  ///< by segment, of those along distances
  AreaTests tests_;
  std::vector<std::optional<AreaTests::Start>> starts_;  ///< by a program's first step

  std::vector<std::uint64_t> nothing_;  ///< inside of no outline
  std::vector<Level> levels_;
  std::vector<int> open_;  ///< groups
  std::vector<int> chain_;
  std::vector<double> grounds_;  ///< of groups: what lies below them changes by per pixel
};

}  // namespace mien
