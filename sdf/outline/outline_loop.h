#pragma once
// A pen that writes closed loops as pieces: cut where x or y turns, cut to the window, snapped.
//
//   OutlineLoop loop;
//   loop.frame(window, 1.0 / 800, outlines);
//   const int index = loop.outline(FillRule::nonzero);
//   loop.begin({0, 0}); loop.line({9, 0}); loop.quad({9, 9}, {0, 9}); loop.close();
//   loop.finish();
//
// What lies beyond the window is replaced by its projection onto the window's border, some pixels outside of it. A
// path between two points of one outer half-plane never passes through the window, so no winding number inside
// changes (docs/derivations/outlines.md).

#include "sdf/outline/curve/curve_pen.h"
#include "sdf/outline/outlines.h"

namespace mien {

class OutlineLoop final : public CurvePen {
 public:
  /// All that follows goes to `to`: correct inside `window` [px], to `tolerance` [px].
  void frame(const Box2& window, double tolerance, Outlines& to);
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }
  /// Whether loops that follow count as run the other way round.
  void set_backwards(bool backwards) { backwards_ = backwards; }
  /// Whether sides of loops that follow may lie on each other: ways there and back without area become one line.
  void set_may_run_back(bool may_run_back) { may_run_back_ = may_run_back; }

  /// A new outline, to which the loops that follow belong; its index.
  int outline(FillRule rule);

  void begin(glm::dvec2 p) override;
  void line(glm::dvec2 to) override;
  void quad(glm::dvec2 control, glm::dvec2 to) override;
  /// A loop vanishes if it encloses nothing in the window or has a coordinate that is no number.
  void close() override;
  /// Ties pieces to vertices and turns them to run down.
  void finish();

 private:
  void cut(glm::dvec2 control, glm::dvec2 to, bool clip);
  void piece(glm::dvec2 control, glm::dvec2 to, bool straight);
  bool runs_along_border(int vertex, glm::dvec2 to) const;
  bool runs_back(glm::dvec2 to) const;
  bool are_flat(glm::dvec2 control, glm::dvec2 to, bool straight) const;
  bool encloses_nothing() const;
  void drop();
  bool is_number(glm::dvec2 p);

  Outlines* to_ = nullptr;
  glm::dvec2 start_{0.0};
  int first_vertex_ = 0, first_piece_ = 0;
  bool bad_ = false;  ///< the loop has a coordinate that is no number
  bool backwards_ = false, may_run_back_ = true;
};

}  // namespace mien
