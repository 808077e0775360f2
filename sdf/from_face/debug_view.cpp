#include "sdf/from_face/debug_view.h"

#include <mien/face_model.h>
#include "draw_face_private.h"
#include "lib/picture/srgb.h"
#include "sdf/from_face/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace mien {
namespace {

constexpr Color kInk{0.02, 0.02, 0.03, 1}, kVeil{1, 1, 1, 0.55}, kPlate{1, 1, 1, 0.6},
    kHandle{0.8, 0.1, 0.02, 1}, kPoint{0.01, 0.12, 0.55, 1};

glm::dvec2 point_at(const Face& face, int slice) {
  const auto begin = std::size_t(face.model->layout[slice].begin);
  return {face.vector[begin], face.vector[begin + 1]};
}

/// Sizes and places on a face's canvas, from its top left corner down.
struct Page {
  const FaceCanvas& canvas;
  const Lettering& letters;
  double size = std::min(canvas.box.size().x, canvas.box.size().y);

  glm::dvec2 at(double right, double down) const {
    const double top = canvas.y_up ? canvas.box.hi.y : canvas.box.lo.y;
    return {canvas.box.lo.x + right * size, top + (canvas.y_up ? -down : down) * size};
  }
};

void veil(SceneBuilder& build) {
  build.layer("veil", build.everywhere(), {.color = kVeil});
}

void draw_muscle(const Face& face, SceneBuilder& build, int muscle, double pull, double width) {
  const MuscleSystem& system = face.model->muscles;
  const Muscle& m = system.muscles[std::size_t(muscle)];
  Area all;
  for (const MusclePoint& point : system.points)
    for (const MuscleHold& hold : point.holds) {
      if (hold.muscle != Index<Muscle>{muscle}) continue;
      const Area line = build.shape(
          Line{m.origin, point_at(face, point.slice), width * (0.4 + 0.6 * hold.weight)});
      all = all.node < 0 ? line : build.unite(all, line);
    }
  if (all.node < 0) return;
  Color color = pull_color(pull);
  color.a = 0.75;
  build.layer(control_of_side(fmt::format("muscle.{}", m.name), m.side), all, {.color = color});
}

void draw_scale(SceneBuilder& build, const Page& page) {
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const double u = (i + 0.5) / kSteps;
    build.layer(
        "scale",
        build.shape(Line{page.at(0.03 + 0.25 * i / kSteps, 0.035),
                         page.at(0.03 + 0.25 * (i + 1) / kSteps, 0.035), 0.008 * page.size}),
        {.color = pull_color(u)});
  }
  for (const auto& [text, right] : {std::pair{"0", 0.022}, {"pull", 0.125}, {"1", 0.272}})
    draw_caption(build, page.letters, text, page.at(right, 0.078), 0.024 * page.size,
                 page.canvas.y_up, kInk);
}

constexpr double kValueSize = 0.018, kValueStep = 0.026, kFirstValue = 0.131, kValueLeft = 0.05,
                 kPullWidth = 0.05;

/// One line of the legend: a group of muscles, with the pulls of its sides.
struct MuscleValue {
  std::string name;
  std::vector<std::string> pulls;
  double most = 0;
};

/// In the order of the model, left before right.
std::vector<MuscleValue> muscle_values(const FaceModel& model, std::span<const double> pulls) {
  std::vector<MuscleValue> values;
  std::set<std::string_view> done;
  const auto& muscles = model.muscles.muscles;
  for (const Muscle& muscle : muscles) {
    if (!done.insert(muscle.name).second) continue;
    MuscleValue& value = values.emplace_back(MuscleValue{std::string(muscle.name), {}});
    for (const Side side : {Side::left, Side::right, Side::none})
      for (std::size_t m = 0; m < muscles.size(); ++m)
        if (muscles[m].name == muscle.name && muscles[m].side == side) {
          value.pulls.push_back(fmt::format("{:.2f}", pulls[m]));
          value.most = std::max(value.most, pulls[m]);
        }
  }
  return values;
}

/// A veil over the corner of the page that holds the legend: its words stay readable over the lines behind.
void draw_plate(SceneBuilder& build, const Page& page, double right, double down) {
  const glm::dvec2 corner = page.at(right, down);
  const double out = page.canvas.y_up ? -1.0 : 1.0;
  build.layer("plate",
              build.intersect(build.shape(HalfPlane{{1, 0}, corner.x}),
                              build.shape(HalfPlane{{0, out}, out * corner.y})),
              {.color = kPlate});
}

void draw_legend(const FaceModel& model, std::span<const double> pulls, SceneBuilder& build,
                 const Page& page) {
  const std::vector<MuscleValue> values = muscle_values(model, pulls);
  double column = 0.18;  // where the first pulls stand
  for (const MuscleValue& value : values)
    column = std::max(column, kValueSize * caption_width(page.letters, value.name));
  column += kValueLeft + 0.02;
  const auto write = [&](std::string_view text, double right, double down) {
    draw_caption(build, page.letters, text, page.at(right, down), kValueSize * page.size,
                 page.canvas.y_up, kInk);
  };
  const auto columns = std::max_element(values.begin(), values.end(), [](auto& a, auto& b) {
    return a.pulls.size() < b.pulls.size();
  });
  const double end = column + kPullWidth * (values.empty() ? 2.0 : double(columns->pulls.size()));
  draw_plate(build, page, end + 0.01, kFirstValue + kValueStep * double(values.size()));
  draw_scale(build, page);
  write("left", column, kFirstValue - kValueStep);
  write("right", column + kPullWidth, kFirstValue - kValueStep);
  double down = kFirstValue;
  for (const MuscleValue& value : values) {
    build.layer("value", build.shape(Disc{page.at(0.034, down - 0.008), 0.006 * page.size}),
                {.color = pull_color(value.most)});
    write(value.name, kValueLeft, down);
    for (std::size_t i = 0; i < value.pulls.size(); ++i)
      write(value.pulls[i], column + kPullWidth * double(i), down);
    down += kValueStep;
  }
}

void draw_point(SceneBuilder& build, const Page& page, glm::dvec2 p, bool handle) {
  const Area disc = build.shape(Disc{p, 0.007 * page.size});
  build.layer("point", handle ? build.shell(disc, 0.0018 * page.size) : disc,
              {.color = handle ? kHandle : kPoint});
}

/// Lines from a handle to the points before and after it.
void draw_arms(SceneBuilder& build, const Page& page, glm::dvec2 a, glm::dvec2 handle,
               glm::dvec2 b) {
  for (const glm::dvec2 end : {a, b})
    build.layer("arm", build.shape(Line{handle, end, 0.001 * page.size}), {.color = kHandle});
}

/// Which slices are handles; draws their arms.
std::set<int> draw_handles(const Face& face, SceneBuilder& build, const Page& page) {
  std::set<int> handles;
  const auto arm = [&](int before, int handle, int after) {
    handles.insert(handle);
    draw_arms(build, page, point_at(face, before), point_at(face, handle), point_at(face, after));
  };
  for (const Feature& feature : face.model->features) {
    if (const auto* stroke = std::get_if<StrokeFigure>(&feature.figure))
      arm(stroke->spine[0], stroke->spine[1], stroke->spine[2]);
    if (const auto* eye = std::get_if<OpeningFigure>(&feature.figure)) {
      arm(eye->inner, eye->upper, eye->outer);
      arm(eye->inner, eye->lower, eye->outer);
    }
    if (const auto* path = std::get_if<PathFigure>(&feature.figure))
      for (const PathFigure::Loop& loop : path->loops)
        for (std::size_t i = 0; i < loop.nodes.size(); ++i)
          if (loop.nodes[i].bend)
            arm(loop.nodes[(i + loop.nodes.size() - 1) % loop.nodes.size()].point,
                loop.nodes[i].point, loop.nodes[(i + 1) % loop.nodes.size()].point);
  }
  return handles;
}

}  // namespace

Color pull_color(double pull) {
  const double hue = 4 * (1 - std::clamp(pull, 0.0, 1.0));  // in sixths of the circle
  const auto channel = [&](double middle) {
    const double away = std::abs(std::fmod(hue - middle + 9, 6) - 3);
    return linear_from_srgb(std::clamp(2 - away, 0.0, 1.0));
  };
  return {channel(0), channel(2), channel(4), 1};
}

Scene debug_muscles(const Face& posed, std::span<const double> pulls, const Lettering& letters) {
  SceneBuilder build = begin_face(posed);
  draw_face(posed, build);
  veil(build);
  const Page page{posed.model->canvas, letters};
  for (std::size_t m = 0; m < posed.model->muscles.muscles.size(); ++m)
    draw_muscle(posed, build, int(m), pulls[m], 0.003 * page.size);
  draw_legend(*posed.model, pulls, build, page);
  return std::move(build).finish();
}

Scene debug_points(const Face& posed, const Lettering& letters) {
  SceneBuilder build = begin_face(posed);
  draw_face(posed, build);
  veil(build);
  const Page page{posed.model->canvas, letters};
  const std::set<int> handles = draw_handles(posed, build, page);
  const Layout& layout = posed.model->layout;
  for (int s = 0; s < int(layout.slices().size()); ++s) {
    if (layout[s].kind != SliceKind::point) continue;
    const glm::dvec2 p = point_at(posed, s);
    draw_point(build, page, p, handles.contains(s));
    draw_caption(build, page.letters, layout[s].name, p + glm::dvec2{0.009 * page.size, 0},
                 0.011 * page.size, page.canvas.y_up, kInk);
  }
  return std::move(build).finish();
}

}  // namespace mien
