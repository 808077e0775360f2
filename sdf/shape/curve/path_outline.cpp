#include "sdf/shape/curve/path_outline.h"
#include "lib/base/watch.h"
#include "sdf/shape/curve/path.h"

#include "path_meetings_private.h"
#include "path_sides_private.h"
#include "sdf/shape/curve/path_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace mien {
namespace {

/// A piece of a side, between two meetings.
struct SidePiece {
  QuadBezier curve;
  int from, to;  ///< places
  std::size_t side;
  double s, t;  ///< of the side: its begin and end
  bool backwards = false;
};

QuadBezier part_of(const QuadBezier& c, double s, double t, glm::dvec2 from, glm::dvec2 to) {
  if (is_straight(c)) return straight(from, to);
  if (s == 0.0 && t == 1.0) return {from, c.p1, to};
  return {from, (1.0 - s) * ((1.0 - t) * c.p0 + t * c.p1) + s * ((1.0 - t) * c.p1 + t * c.p2), to};
}

/// Sides cut where they meet, and what is outline of them.
class CutPath {
 public:
  CutPath(const PathMeetings& cut, const Path& path, const PathTree* tree)
      : cut_(cut), path_(path), tree_(tree) {}

  /// Whether some piece is not outline.
  bool find_outline();
  /// The outline's loops; none if they do not close.
  std::optional<Path> loops() const;

 private:
  void add_pieces();
  int inside_beside(const SidePiece& piece) const;
  int inside_beside(const SidePiece& piece, double share) const;
  bool inside(glm::dvec2 p) const {
    worked(tree_ ? 300 : 4 * std::int64_t(cut_.sides().size()));
    return (tree_ ? tree_->winding(p) : winding(path_, p)) != 0;
  }
  void keep(std::size_t begin, std::size_t end, int hand);
  void drop_doubles();

  const PathMeetings& cut_;
  const Path& path_;
  const PathTree* tree_;
  std::vector<SidePiece> pieces_;
  std::vector<std::size_t> loop_ends_;  ///< in `pieces_`
  std::vector<int> degree_;             ///< ends of pieces, by place
  std::vector<SidePiece> outline_;      ///< the inside to the left
};

void CutPath::add_pieces() {
  const auto& sides = cut_.sides();
  auto cut = cut_.cuts().begin();
  std::size_t loop = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    int from = cut_.begin_of(i);
    double t = 0.0;
    const auto until = [&](double at, int place) {
      if (place == from) return;
      const QuadBezier curve = part_of(sides[i], t, at, cut_.places()[std::size_t(from)],
                                       cut_.places()[std::size_t(place)]);
      pieces_.push_back({curve, from, place, i, t, at});
      from = place, t = at;
    };
    for (; cut != cut_.cuts().end() && cut->side == i; ++cut) until(cut->t, cut->place);
    until(1.0, cut_.end_of(i));
    if (i + 1 == cut_.loop_ends()[loop]) loop_ends_.push_back(pieces_.size()), ++loop;
  }
  degree_.assign(cut_.places().size(), 0);
  for (const SidePiece& piece : pieces_)
    ++degree_[std::size_t(piece.from)], ++degree_[std::size_t(piece.to)];
}

/// 1 if the inside is to the left of a piece alone, −1 to the right alone; 0: on both hands or on none. At one place it
/// may be wrong, as where the side turns back beside itself: two of three that say the same are believed.
int CutPath::inside_beside(const SidePiece& piece) const {
  constexpr double kPlaces[] = {0.41, 0.66, 0.27};
  const int a = inside_beside(piece, kPlaces[0]), b = inside_beside(piece, kPlaces[1]);
  return a == b ? a : inside_beside(piece, kPlaces[2]);
}

/// Asked beside the side itself, not its piece, which may be moved by a tolerance, and nearer than that.
int CutPath::inside_beside(const SidePiece& piece, double share) const {
  const QuadBezier& side = cut_.sides()[piece.side];
  const double t = piece.s + share * (piece.t - piece.s);
  const glm::dvec2 way = is_straight(side) ? side.p2 - side.p0 : tangent(side, t);
  const double length = glm::length(way);
  if (!(length > 0.0)) return 0;
  const glm::dvec2 left = 0.25 * cut_.tolerance() / length * glm::dvec2{-way.y, way.x};
  const glm::dvec2 p = point(side, t);
  return int(inside(p + left)) - int(inside(p - left));
}

void CutPath::keep(std::size_t begin, std::size_t end, int hand) {
  for (std::size_t i = begin; i < end; ++i) {
    const SidePiece& p = pieces_[i];
    outline_.push_back(
        hand > 0 ? p : SidePiece{reversed(p.curve), p.to, p.from, p.side, p.s, p.t, true});
  }
}

/// Pieces that nothing meets in between have the same on their hands: the longest one is asked.
bool CutPath::find_outline() {
  add_pieces();
  std::size_t first = 0;
  for (const std::size_t end : loop_ends_) {
    for (std::size_t begin = first, next; begin < end; begin = next) {
      std::size_t longest = begin;
      const auto length = [&](std::size_t i) {
        return glm::distance(pieces_[i].curve.p0, pieces_[i].curve.p2);
      };
      for (next = begin + 1; next < end && degree_[std::size_t(pieces_[next].from)] == 2; ++next)
        if (length(next) > length(longest)) longest = next;
      if (const int hand = inside_beside(pieces_[longest])) keep(begin, next, hand);
    }
    first = end;
  }
  drop_doubles();
  return outline_.size() < pieces_.size();
}

/// Of pieces that lie on each other one is left.
void CutPath::drop_doubles() {
  std::vector<std::size_t> order(outline_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    const SidePiece &a = outline_[i], &b = outline_[k];
    return a.from != b.from ? a.from < b.from : a.to != b.to ? a.to < b.to : i < k;
  });
  std::vector<char> twice(outline_.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const SidePiece &a = outline_[order[i]], &b = outline_[order[k]];
      if (a.from != b.from || a.to != b.to) break;
      if (glm::distance(point(a.curve, 0.5), point(b.curve, 0.5)) < 8.0 * cut_.tolerance())
        twice[order[k]] = 1;
    }
  std::size_t left = 0;
  for (std::size_t i = 0; i < outline_.size(); ++i)
    if (!twice[i]) outline_[left++] = outline_[i];
  outline_.resize(left);
}

/// Which piece follows on which, at every place.
class Joints {
 public:
  Joints(const std::vector<SidePiece>& pieces, std::size_t places);

  /// Whether as many pieces begin as end at every place.
  bool close() const { return close_; }
  std::size_t after(std::size_t piece) const { return after_[piece]; }

 private:
  void join(std::vector<std::size_t>& ending, std::vector<std::size_t>& beginning);
  /// The angle from the end of one piece to the begin of another, through the inside.
  double inside_between(std::size_t ending, std::size_t beginning) const;

  const std::vector<SidePiece>& pieces_;
  std::vector<std::size_t> after_;
  bool close_ = true;
};

Joints::Joints(const std::vector<SidePiece>& pieces, std::size_t places)
    : pieces_(pieces), after_(pieces.size(), pieces.size()) {
  std::vector<std::vector<std::size_t>> ending(places), beginning(places);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ending[std::size_t(pieces[i].to)].push_back(i);
    beginning[std::size_t(pieces[i].from)].push_back(i);
  }
  for (std::size_t i = 0; i < places && close_; ++i) {
    close_ = ending[i].size() == beginning[i].size();
    if (close_) join(ending[i], beginning[i]);
  }
}

double Joints::inside_between(std::size_t ending, std::size_t beginning) const {
  const QuadBezier &a = pieces_[ending].curve, &b = pieces_[beginning].curve;
  const glm::dvec2 back = a.p1 != a.p2 ? a.p1 - a.p2 : a.p0 - a.p2,
                   on = b.p1 != b.p0 ? b.p1 - b.p0 : b.p2 - b.p0;
  const double angle = std::atan2(on.x * back.y - on.y * back.x, glm::dot(on, back));
  return angle > 0.0 ? angle : angle + 6.283185307179586;
}

/// Where several pieces begin, loops touch. They go on along the inside between two pieces, or, where that is more than
/// half a turn, along the outside: so that what is nearest to the place lies beside both pieces of a joint.
void Joints::join(std::vector<std::size_t>& ending, std::vector<std::size_t>& beginning) {
  constexpr double kHalfTurn = 3.141592653589793;
  bool outside = false;
  const auto nearest = [&](std::size_t e) {
    return std::min_element(beginning.begin(), beginning.end(), [&](std::size_t i, std::size_t k) {
      const double a = inside_between(e, i), b = inside_between(e, k);
      return outside ? a > b : a < b;
    });
  };
  if (ending.size() > 1)
    for (const std::size_t e : ending)
      outside = outside || inside_between(e, *nearest(e)) > kHalfTurn;
  for (const std::size_t e : ending) {
    const auto next = nearest(e);
    after_[e] = *next;
    beginning.erase(next);
  }
}

/// Each begins where the first of its pieces did.
std::optional<Path> CutPath::loops() const {
  const Joints joints(outline_, cut_.places().size());
  if (!joints.close()) return {};
  Path made{.loops = {}, .rule = FillRule::nonzero};
  std::vector<char> done(outline_.size(), 0);
  for (std::size_t first = 0; first < outline_.size(); ++first) {
    if (done[first]) continue;
    Path::Loop loop;
    for (std::size_t i = outline_[first].backwards ? joints.after(first) : first; !done[i];
         i = joints.after(i)) {
      done[i] = 1;
      loop.sides.push_back(outline_[i].curve);
    }
    made.loops.push_back(std::move(loop));
  }
  return made;
}

}  // namespace

std::optional<Path> visible_outline(const Path& path) {
  constexpr double kTolerance = 0x1p-42, kCoarser = 256.0;
  constexpr int kTries = 3;
  if (path.rule == FillRule::even_odd || is_simple(path)) return {};
  std::optional<PathTree> tree;
  double share = kTolerance;
  for (int i = 0; i < kTries; ++i, share *= kCoarser) {
    PathMeetings cut(path, share);
    if (!cut.find()) return {};
    if (!tree && cut.sides().size() > 4 * PathTree::kFewSides) tree.emplace(path);
    CutPath pieces(cut, path, tree ? &*tree : nullptr);
    if (!pieces.find_outline()) return {};
    std::optional<Path> made = pieces.loops();
    if (made && made->loops.empty()) return {};
    if (made) return made;
  }
  return {};
}

}  // namespace mien
