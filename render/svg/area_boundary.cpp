#include "render/svg/area_boundary.h"
#include "sdf/arrange/foreseen.h"
#include "sdf/outline/area_tests.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// Of the tolerance: what outlines may take, what joining sides may, and the order of neighbours.
constexpr double kOutlineShare = 0.8, kJoinShare = 0.05, kOrderShare = 0.1;
/// [px] The sweep begins and ends where nothing is inside.
constexpr double kAround = 1.0;

Path window_path(const Box2& box, const Map<FaceSpace, GridSpace>& map) {
  const glm::dvec2 corners[] = {map(box.lo), map({box.hi.x, box.lo.y}), map(box.hi),
                                map({box.lo.x, box.hi.y})};
  Path path{.loops = {{}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % 4];
    path.loops[0].sides.push_back({a, 0.5 * (a + b), b});
  }
  return path;
}

double enclosed_by(const FragmentLoop& loop) {
  double twice = 0.0;
  glm::dvec2 at = loop.start;
  for (const LoopSide& side : loop.sides) {
    twice += at.x * side.to.y - at.y * side.to.x;
    at = side.to;
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

/// Look 1 where the program holds.
class AreaBoundaries::Inside final : public LookRule {
 public:
  explicit Inside(std::span<const AreaStep> program) : start_(tests_.add(program)) {}
  int state_words() const override { return 0; }
  int first_look(std::uint64_t*) override { return 0; }  // outside of the window
  int look(const std::uint64_t* inside, int, const std::uint64_t*, int, std::uint64_t*) override {
    return tests_.holds(start_, inside);
  }

 private:
  AreaTests tests_;
  AreaTests::Start start_;
};

AreaBoundaries::AreaBoundaries(const Scene& scene, const Map<GridSpace, FaceSpace>& map,
                               const Box2& window, double tolerance)
    : map_(map), window_(window), tolerance_(tolerance), frame_(window_path(window, inverse(map))) {
  programs_.begin(scene);
}

/// The outline's own index in this arrangement.
int AreaBoundaries::local(int outline) {
  if (std::size_t(outline) >= local_.size()) local_.resize(std::size_t(outline) + 1, -1);
  int& index = local_[std::size_t(outline)];
  if (index < 0) {
    index = maker_.add(programs_, programs_.outlines()[std::size_t(outline)]);
    global_.push_back(outline);
  }
  return index;
}

AreaBoundary AreaBoundaries::of(std::span<const AreaLevel> all) {
  const OutlineFrame frame{map_, window_, kOutlineShare * tolerance_};
  const std::size_t known = programs_.outlines().size();
  std::vector<AreaProgram> programs;
  for (const AreaLevel& level : all) programs.push_back(programs_.add(level.area, level.level));
  foresee(programs_, programs_.outlines().subspan(known), frame);
  maker_.begin(frame, outlines_);
  for (const int outline : global_) local_[std::size_t(outline)] = -1;
  global_.clear(), steps_.clear();
  steps_.push_back({AreaStep::Kind::outline, maker_.fill(frame_)});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const AreaLevel& level = all[i];
    const AreaProgram program = programs[i];
    for (AreaStep step : programs_.steps(program)) {
      if (step.kind == AreaStep::Kind::outline) step.outline = local(step.outline);
      steps_.push_back(step);
    }
    if (program.count == 0)  // everywhere
      steps_.push_back({AreaStep::Kind::nothing}), steps_.push_back({AreaStep::Kind::not_});
    if (level.outside) steps_.push_back({AreaStep::Kind::not_});
    steps_.push_back({AreaStep::Kind::and_});
  }
  maker_.finish();
  Inside inside(steps_);
  regions_.begin(int(outlines_.rules.size()), inside);
  sweep_.run(outlines_, window_.lo.y - kAround, window_.hi.y + kAround, regions_,
             std::min(kOrder, kOrderShare * tolerance_));
  AreaBoundary made;
  made.loops = fragment_loops(sweep_.fragments(), outlines_.pieces, kJoinShare * tolerance_);
  made.doubts = int(sweep_.doubts().size());
  const glm::dvec2 size = window_.size();
  made.whole = made.loops.size() == 1 && made.loops[0].sides.size() == 4 &&
               enclosed_by(made.loops[0]) >= size.x * size.y * (1.0 - 1e-9);
  return made;
}

}  // namespace mien
