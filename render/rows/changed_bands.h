#pragma once
// Which bands of rows have to be drawn again after a scene has changed a little.
//
// A band's bytes follow from the outlines that cross it, in their order, and from what the sets of outlines that places
// in it are inside of look like. So a band has changed if
//
// * an outline that differs has a piece in it, before or now: outside its heights nothing is inside of it. Heights
//   include both ends: a chain that ends on a band's top is seen from there;
// * a layer that differs may be seen in it: one with another paint or other operands, or whose gradient or relief goes
//   by the distance of an area that differs. A distance may change at any distance from what moved, so such a change
//   reaches wherever the layer may be. That is told by its program, on heights instead of bits: `and` is where both
//   may be, `or` from the upper to the lower one, `not` everywhere.
//
// Whole bands, not rows: within one, the steps of the sweep depend on all that begins or ends in it.

#include "render/shade/paint_table.h"
#include "sdf/outline/outlines.h"
#include "sdf/scene/same_scene.h"

#include <utility>
#include <vector>

namespace mien {

/// A scene as far as it does not depend on rows.
struct PreparedScene {
  Scene scene;
  PaintTable paints;
  Outlines outlines;
};

class ChangedBands {
 public:
  void begin(int bands, bool changed) { changed_.assign(std::size_t(bands), changed); }
  /// Adds those that differ. `same_as`: by outline, as AreaPrograms::find_same tells.
  void find(const PreparedScene& before, const PreparedScene& now, const InCommon& common,
            const std::vector<int>& same_as);

  bool operator[](int band) const { return changed_[std::size_t(band)]; }

 private:
  using Heights = std::pair<double, double>;
  void add(const Heights& heights);
  Heights reach(const PreparedScene& of, const AreaProgram& program);

  std::vector<char> changed_;
  std::vector<int> now_;  ///< by outline before: the same one now
  std::vector<Heights> stack_;
};

}  // namespace mien
