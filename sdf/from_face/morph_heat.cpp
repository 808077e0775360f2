#include <mien/morph_heat.h>

#include <mien/face_model.h>
#include <mien/morph.h>
#include "feature_areas_private.h"
#include "sdf/from_face/caption.h"
#include "sdf/from_face/heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace mien {
namespace {

// Sizes, as shares of the canvas's shorter side.
constexpr double kDisc = 0.008, kLine = 0.0025;
constexpr double kBarWidth = 0.03, kBarHeight = 0.7, kBarMargin = 0.03;
constexpr double kLabel = 0.035;
constexpr int kBarSteps = 64;

Color grey_of(const Face& face, int slice) {
  const double* c = &face.vector[std::size_t(face.model->layout[slice].begin)];
  const double light = 0.25 * (0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]) + 0.02;
  return {light, light, light, c[3]};
}

Path rectangle(glm::dvec2 lo, glm::dvec2 hi) {
  const glm::dvec2 corners[] = {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
  Path::Loop loop;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % 4];
    loop.sides.push_back({a, 0.5 * (a + b), b});
  }
  return {{loop}, FillRule::nonzero};
}

/// The bar: 0 at its lower end, the largest amount at its upper.
void add_bar(SceneBuilder& build, const FaceCanvas& canvas, double unit) {
  const double x1 = canvas.box.hi.x - kBarMargin * unit, x0 = x1 - kBarWidth * unit;
  const double height = kBarHeight * canvas.box.size().y, middle = canvas.box.center().y;
  for (int i = 0; i < kBarSteps; ++i) {
    double y0 = middle - 0.5 * height + height * i / kBarSteps;
    double y1 = middle - 0.5 * height + height * (i + 1) / kBarSteps;
    if (!canvas.y_up) std::tie(y0, y1) = std::pair{2 * middle - y1, 2 * middle - y0};
    build.layer("bar", build.shape(rectangle({x0, y0}, {x1, y1})),
                {.color = heat_color((i + 0.5) / kBarSteps)});
  }
}

/// What the bar's ends stand for.
void add_labels(SceneBuilder& build, const Lettering& letters, const FaceCanvas& canvas,
                double unit, double largest) {
  if (!letters.path) return;
  const double right = canvas.box.hi.x - kBarMargin * unit, middle = canvas.box.center().y;
  const double half = 0.5 * kBarHeight * canvas.box.size().y, high = kLabel * unit;
  const Color ink{0.75, 0.75, 0.72, 1}, shade{0.01, 0.01, 0.012, 0.75};
  const auto label = [&](const std::string& text, double up) {
    const double width = high * caption_width(letters, text), up_sign = canvas.y_up ? 1 : -1;
    const glm::dvec2 at{right - width, middle + up_sign * up};
    const glm::dvec2 far{right, at.y + up_sign * high};
    const double margin = 0.35 * high;
    build.layer("label",
                build.shape(rectangle({at.x - margin, std::min(at.y, far.y) - 0.4 * margin},
                                      {far.x + margin, std::max(at.y, far.y) + 0.4 * margin})),
                {.color = shade});
    draw_caption(build, letters, text, at, high, canvas.y_up, ink);
  };
  label(fmt::format("{:.3g} {}", largest, canvas.unit), half + 0.4 * high);
  label("0", -half - 1.4 * high);
}

}  // namespace

MorphHeat morph_heat(const Face& rest, const Face& posed, const Lettering& letters) {
  const FaceModel& model = *posed.model;
  SceneBuilder build({model.canvas.box, model.canvas.y_up}, grey_of(posed, model.background));
  FeatureAreas areas(posed, build);
  for (Index<Feature> i{0}; i.at < int(model.features.size()); ++i.at) {
    const Feature& feature = i.in(model.features);
    areas.add(i);
    if (feature.paint >= 0)
      build.layer(std::string(feature.name), areas.of(i), {.color = grey_of(posed, feature.paint)});
  }
  std::vector<PointShift> shifts = point_shifts(rest, posed);
  const double largest = largest_shift(shifts);
  const double unit = std::min(model.canvas.box.size().x, model.canvas.box.size().y);
  std::stable_sort(shifts.begin(), shifts.end(),
                   [](const PointShift& a, const PointShift& b) { return a.amount < b.amount; });
  for (const PointShift& shift : shifts) {
    const Color color = heat_color(largest > 0 ? shift.amount / largest : 0);
    const std::string name(model.layout[shift.slice].name);
    if (shift.amount > 0)
      build.layer(name, build.shape(Line{shift.from, shift.to, kLine * unit}), {.color = color});
    build.layer(name, build.shape(Disc{shift.to, kDisc * unit}), {.color = color});
  }
  add_bar(build, model.canvas, unit);
  add_labels(build, letters, model.canvas, unit, largest);
  return {std::move(build).finish(), largest};
}

}  // namespace mien
