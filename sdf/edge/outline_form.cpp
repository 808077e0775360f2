#include <mien/sdf/edge/outline_form.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// The parabola a side lies on, with the way it runs. Nothing where there is none, or the side stops at an
/// end.
std::optional<OutlineSide> side_of(const QuadBezier& s) {
  const auto piece = parabola_piece(s);
  const glm::dvec2 leave = tangent(s, 0.0), arrive = tangent(s, 1.0);
  if (!piece || !(glm::length(leave) > 0.0) || !(glm::length(arrive) > 0.0)) return {};
  if (s.p0 == s.p2) return {};
  OutlineSide side{.curve = s, .form = piece->form, .forwards = piece->forwards};
  side.begin = s.p0, side.end = s.p2;
  side.begin_way = glm::normalize(leave), side.end_way = glm::normalize(arrive);
  double margin = ParabolaForm::kMargin;
  for (double& reach : side.reaches) reach = reach_of(side.form, margin), margin *= 0.5;
  side.form.reach = side.reaches[0];
  for (const glm::dvec2 p : {s.p0, s.p1, s.p2}) side.box = around(side.box, p);
  return side;
}

/// Sides of a loop, joined to each other; false where one has no form or the loop is open.
bool add_loop(const std::vector<QuadBezier>& loop, OutlineForm& form) {
  const int first = int(form.sides.size());
  for (const QuadBezier& quad : loop) {
    if (quad.p0 == quad.p1 && quad.p1 == quad.p2) continue;
    const auto side = side_of(quad);
    if (!side) return false;
    form.sides.push_back(*side);
  }
  const int count = int(form.sides.size()) - first;
  for (int i = 0; i < count; ++i) {
    OutlineSide& side = form.sides[std::size_t(first + i)];
    side.next = first + (i + 1) % count, side.before = first + (i + count - 1) % count;
    if (side.end != form.sides[std::size_t(side.next)].begin) return false;
  }
  return true;
}

std::optional<OutlineForm> path_form(const Path& path) {
  OutlineForm form{.path = path};
  for (const Path::Loop& loop : path.loops)
    if (!add_loop(loop.sides, form)) return {};
  return form;
}

/// Quadratic curves along an arc from a to b around a centre, turning left, for counting windings: off by
/// at most radius · turn⁴ / 128 for the turn of one of them.
void add_arc(glm::dvec2 center, double radius, glm::dvec2 a, glm::dvec2 b,
             std::vector<QuadBezier>& loop) {
  const double from = std::atan2(a.y - center.y, a.x - center.x);
  double turn = std::atan2(b.y - center.y, b.x - center.x) - from;
  constexpr double kTurn = 6.283185307179586;
  if (turn < 0.0) turn += kTurn;
  constexpr int kPieces = 8;
  const double step = turn / kPieces, out = radius / std::cos(0.5 * step);
  const auto on = [&](double angle, double r) {
    return center + r * glm::dvec2{std::cos(angle), std::sin(angle)};
  };
  glm::dvec2 last = a;
  for (int i = 1; i <= kPieces; ++i) {
    const glm::dvec2 p = i == kPieces ? b : on(from + step * i, radius);
    loop.push_back({last, on(from + step * (i - 0.5), out), p});
    last = p;
  }
}

std::optional<OutlineForm> tapered_form(const TaperedStroke& stroke, double offset,
                                        double tolerance) {
  constexpr double kLeast = 1e-3;  // [px] ends smaller than this are points: not worth a form
  const auto outline = tapered_outline(stroke, offset, tolerance);
  if (!outline || !(outline->begin_radius > kLeast) || !(outline->end_radius > kLeast)) return {};
  OutlineForm form{.error = tolerance};
  for (const auto* quads : {&outline->right, &outline->left})
    for (const QuadBezier& quad : *quads) {
      const auto side = side_of(quad);
      if (!side) return {};
      form.sides.push_back(*side);
    }
  const int rights = int(outline->right.size()), all = int(form.sides.size());
  for (int i = 0; i < all; ++i) {
    OutlineSide& side = form.sides[std::size_t(i)];
    side.next = (i + 1) % all, side.before = (i + all - 1) % all;
  }
  form.sides[std::size_t(rights - 1)].round_after = 0;
  form.sides[std::size_t(all - 1)].round_after = 1;
  form.ends = {{stroke.spine.p2, outline->end_radius, rights - 1, rights},
               {stroke.spine.p0, outline->begin_radius, all - 1, 0}};
  form.path.rule = FillRule::nonzero;
  Path::Loop loop{outline->right};
  add_arc(form.ends[0].center, form.ends[0].radius, outline->right.back().p2,
          outline->left.front().p0, loop.sides);
  loop.sides.insert(loop.sides.end(), outline->left.begin(), outline->left.end());
  add_arc(form.ends[1].center, form.ends[1].radius, outline->left.back().p2,
          outline->right.front().p0, loop.sides);
  form.path.loops.push_back(std::move(loop));
  return form;
}

}  // namespace

std::optional<OutlineForm> outline_form(const OffsetShape& shape, double tolerance) {
  if (const auto* path = std::get_if<Path>(&shape.shape); path && shape.offset == 0.0)
    return path_form(*path);
  if (const auto* stroke = std::get_if<TaperedStroke>(&shape.shape))
    return tapered_form(*stroke, shape.offset, tolerance);
  return {};
}

}  // namespace mien
