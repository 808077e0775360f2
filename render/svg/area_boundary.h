#pragma once
// The boundary of an area, whatever it was combined from, as loops of lines and parabolas: its own arrangement, and
// of that only what lies between inside and outside.
//
//   AreaBoundaries boundaries(scene, grid_from_face, window, 0.01);
//   const AreaBoundary face = boundaries.of(head);               // {distance <= 0}
//   const AreaLevel rim[] = {{head, 0.1}, {head, -0.1, true}};
//   const AreaBoundary around = boundaries.of(rim);              // between two levels

#include "render/svg/fragment_loops.h"
#include "sdf/outline/area_program.h"
#include "sdf/outline/outline_maker.h"

#include <span>
#include <vector>

namespace mien {

/// {distance(area) <= level}, or all that is outside of it.
struct AreaLevel {
  Area area;
  double level = 0;  ///< [face units]
  bool outside = false;
};

struct AreaBoundary {
  /// They do not cross each other or themselves, but for roundings. Even-odd and nonzero are the same.
  std::vector<FragmentLoop> loops;
  /// The area covers all of the window.
  bool whole = false;
  /// Places where the order of its outlines could not be proven, so that a loop may be wrong there.
  int doubts = 0;
};

/// Makes them one after the other; keeps its scratch.
class AreaBoundaries {
 public:
  /// Boundaries are cut to `window` [px], finite and not empty, and leave the outline by `tolerance` [px] at most.
  AreaBoundaries(const Scene& scene, const Map<GridSpace, FaceSpace>& map, const Box2& window,
                 double tolerance);

  /// Of what all of these have in common; at least one.
  AreaBoundary of(std::span<const AreaLevel> all);
  AreaBoundary of(Area area) {
    const AreaLevel one{area};
    return of({&one, 1});
  }

 private:
  class Inside;
  int local(int outline);

  Map<GridSpace, FaceSpace> map_;
  Box2 window_;
  double tolerance_;
  Shape frame_;  ///< the window, in face units
  AreaPrograms programs_;
  OutlineMaker maker_;
  Outlines outlines_;
  Regions regions_;
  Sweep sweep_;
  std::vector<int> local_;   ///< by outline of the programs: that of outlines_; −1: not there
  std::vector<int> global_;  ///< the other way round
  std::vector<AreaStep> steps_;
};

}  // namespace mien
