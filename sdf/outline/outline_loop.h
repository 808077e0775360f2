#pragma once
// A pen that writes closed loops as chains of pieces: cut where x or y turns, cut to the window, snapped.
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
  /// Nothing is added afterwards.
  void finish() { to_->finish(); }

  /// Sides of the loop at hand: monotone, in the loop's order.
  std::size_t sides() const { return sides_.size(); }
  /// Forgets the first ones, as if the loop had begun after them; returns how many of them would have been pieces.
  std::size_t forget_sides(std::size_t count);

 private:
  struct Side {
    glm::dvec2 control, to;
    bool straight;
  };
  void cut(glm::dvec2 control, glm::dvec2 to, bool clip);
  void side(glm::dvec2 control, glm::dvec2 to, bool straight);
  bool runs_along_border(glm::dvec2 to) const;
  bool runs_back(glm::dvec2 to) const;
  bool are_flat(glm::dvec2 control, glm::dvec2 to, bool straight) const;
  bool encloses_nothing() const;
  bool is_number(glm::dvec2 p);
  /// Where a side begins; past the last one: where the loop is.
  glm::dvec2 from(std::size_t side) const { return side ? sides_[side - 1].to : first_; }
  bool runs_down(std::size_t side) const;
  bool lies_beyond(std::size_t side) const;
  void write_chains();
  int write_chain(std::size_t first, std::size_t count);
  void write_piece(std::size_t side, bool down);

  Outlines* to_ = nullptr;
  glm::dvec2 start_{0.0}, first_{0.0};  ///< as given; and snapped
  std::vector<Side> sides_;
  bool bad_ = false;  ///< the loop has a coordinate that is no number
  bool backwards_ = false, may_run_back_ = true;
};

}  // namespace mien
