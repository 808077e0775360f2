#pragma once
// A pen that writes closed loops as pieces: cut where x or y turns, cut to the window, snapped.
//
//   OutlineLoop loop;
//   loop.frame(window, 1.0 / 800, outlines);
//   const int index = loop.outline(FillRule::nonzero);
//   loop.begin({0, 0}); loop.line({9, 0}); loop.quad({9, 9}, {0, 9}); loop.close();
//   loop.finish();
//
// What lies beyond the window is replaced by its projection onto the window's border, some pixels
// outside of it: no way between two points of one outer half-plane passes the window, so no winding
// number inside changes (docs/derivations/outlines.md).

#include <mien/lib/geom/box2.h>
#include <mien/sdf/outline/outlines.h>

#include <glm/vec2.hpp>

namespace mien {

class OutlineLoop {
 public:
  /// All that follows goes to `to`, right inside `window` [px] and to `tolerance` [px].
  void frame(const Box2& window, double tolerance, Outlines& to);

  /// A new outline, to which the loops that follow belong; its index.
  int outline(FillRule rule);

  void begin(glm::dvec2 p);
  void line(glm::dvec2 to);
  void quad(glm::dvec2 control, glm::dvec2 to);
  /// Any way to `to` that lies in one of the half-planes beyond the window, as `beyond` says.
  void beyond_to(glm::dvec2 to) { line(to); }
  /// Back to the begin, straight. A loop that encloses nothing in the window, or one with a number
  /// that is none, vanishes.
  void close();
  /// Ties pieces to vertices and turns them to run down.
  void finish();

  glm::dvec2 at() const { return at_; }
  double tolerance() const { return tolerance_; }
  /// The window with its margin: what is cut is cut here.
  const Box2& window() const { return window_; }
  /// Whether all of a box lies on one outer side of the window.
  bool beyond(const Box2& box) const {
    return box.hi.x <= window_.lo.x || box.hi.y <= window_.lo.y || box.lo.x >= window_.hi.x ||
           box.lo.y >= window_.hi.y;
  }

 private:
  void cut(glm::dvec2 control, glm::dvec2 to, bool clip);
  void piece(glm::dvec2 control, glm::dvec2 to, bool straight);
  bool runs_along_border(int vertex, glm::dvec2 to) const;
  bool encloses_nothing() const;
  void drop();
  bool is_number(glm::dvec2 p);

  Outlines* to_ = nullptr;
  Box2 window_;
  double tolerance_ = 1.0;
  glm::dvec2 start_{0}, at_{0};  ///< uncut
  int first_vertex_ = 0, first_piece_ = 0;
  bool bad_ = false;  ///< the loop has a number that is none
};

}  // namespace mien
