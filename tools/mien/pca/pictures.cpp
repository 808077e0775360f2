#include "tools/mien/pca/pictures.h"
#include <mien/face_model.h>
#include <mien/obj.h>
#include <mien/render.h>
#include <mien/scene_from_face.h>
#include <mien/scene_from_mesh.h>
#include "sdf/from_face/caption.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mien::command {
namespace {

constexpr int kDefaultPicture = 512;

View view_of(const Box2& box, int side) {
  const glm::dvec2 size = box.size();
  const double longer = std::max(size.x, size.y);
  const auto pixels = [&](double length) {
    return std::max(1, int(std::lround(side * length / longer)));
  };
  View view{.width = pixels(size.x), .height = pixels(size.y)};
  return view;
}

Mesh mesh_of(std::span<const double> frame, std::size_t vertices, std::size_t dimensions,
             const std::vector<std::array<int, 3>>& triangles) {
  Mesh mesh{{}, triangles};
  for (std::size_t v = 0; v < vertices; ++v) {
    const double* p = &frame[v * dimensions];
    mesh.points.emplace_back(p[0], dimensions > 1 ? p[1] : 0.0, dimensions > 2 ? p[2] : 0.0);
  }
  return mesh;
}

/// A picture of the scene with its background made opaque.
Image opaque_picture(const Scene& scene, int side) {
  View view = view_of(scene.canvas().box, side);
  Color background = scene.background();
  background.a = 1;
  view.background = background;
  return sheet_picture(scene, view);
}

}  // namespace

Expected<FramePainter> FramePainter::of(const PcaArguments& arguments, const BasisFile& basis,
                                        const std::optional<Face>& face) {
  FramePainter painter;
  painter.side_ = kDefaultPicture;
  if (arguments.size) {
    const auto size = read_whole("--size", *arguments.size, 16, 4096);
    if (!size) return size.error();
    painter.side_ = int(*size);
  }
  painter.vertices_ = basis.vertices;
  painter.dimensions_ = basis.dimensions;
  if (!basis.slices.empty()) {
    painter.face_ = face;
    if (!face && arguments.face) {
      std::vector<Error> warnings;
      auto read = read_face_or_code(*arguments.face, {}, &warnings);
      warn(warnings);
      if (!read) return read.error();
      painter.face_ = *std::move(read);
    }
    if (!painter.face_)
      return Error{"--face", "is needed: the basis is of a face, and the file that draws it"};
    if (const auto fits = face_basis(basis, *painter.face_); !fits) return fits.error();
    return painter;
  }
  if (basis.dimensions < 2)
    return Error{"", "frames of single numbers have no picture; shape them [F, V, 2] or [F, V, 3]"};
  if (!arguments.mesh) return painter;
  auto mesh = read_obj(*arguments.mesh);
  if (!mesh) return mesh.error();
  if (mesh->points.size() != basis.vertices)
    return Error{*arguments.mesh, "has another number of points than the basis"};
  painter.triangles_ = std::move(mesh->triangles);
  return painter;
}

void FramePainter::include(std::span<const double> frame) {
  if (face_) return;
  for (std::size_t v = 0; v < vertices_; ++v)
    box_ = around(box_, {frame[v * dimensions_], frame[v * dimensions_ + 1]});
}

Image FramePainter::paint(std::span<const double> frame) const {
  return paint_heat(frame, {});
}

Image FramePainter::paint_heat(std::span<const double> frame,
                               std::span<const double> amounts) const {
  if (face_) {
    Face face{face_->model, FaceVector(frame.begin(), frame.end())};
    apply_rules(face.model->layout, face_->vector, face.vector);
    return opaque_picture(scene_from_face(face), side_);
  }
  const Box2 box = grown(box_, 0.05 * std::max({box_.size().x, box_.size().y, 1e-9}));
  const Mesh mesh = mesh_of(frame, vertices_, dimensions_, triangles_);
  return opaque_picture(scene_from_mesh(mesh, amounts, {.box = box}), side_);
}

namespace {

constexpr double kWord = 0.032;  // height of letters, of the plot's
const Color kPaper{0.93, 0.93, 0.91, 1}, kRule{0.72, 0.72, 0.70, 1}, kInk{0.03, 0.03, 0.05, 1},
    kMostColor{0.55, 0.05, 0.05, 1}, kRmsColor{0.04, 0.20, 0.45, 1};

/// Points of a curve in the unit square: the count across, the logarithm up.
std::vector<glm::dvec2> points_of(const std::vector<PcaError>& curve, double low, double high,
                                  double PcaError::*what, double width) {
  std::vector<glm::dvec2> points;
  const double counts = std::max<double>(double(curve.back().count), 1);
  for (const PcaError& error : curve) {
    const double value = std::log10(std::max(error.*what, std::pow(10, low)));
    points.push_back({width * double(error.count) / counts, (value - low) / (high - low)});
  }
  return points;
}

}  // namespace

Image curve_picture(const std::vector<PcaError>& curve, int width, int height) {
  const double aspect = double(width) / height;
  double low = 1e300, high = 1e-300;
  for (const PcaError& error : curve) {
    if (error.rms > 0) low = std::min(low, error.rms);
    high = std::max(high, error.max);
  }
  high = std::ceil(std::log10(high) + 1e-9);
  low = std::clamp(std::floor(std::log10(low)), high - 14, high - 1);
  SceneBuilder build({{{-0.13, -0.08}, {1.16 * aspect - 0.13, 1.08}}, true}, kPaper);
  const auto word = [&](const std::string& text, glm::dvec2 at, double anchor, const Color& ink) {
    at.x -= anchor * kWord * caption_width(letters(), text);
    draw_caption(build, letters(), text, {at.x, at.y - 0.6 * kWord}, kWord, true, ink);
  };
  for (double decade = low; decade <= high; ++decade) {
    const double y = (decade - low) / (high - low);
    build.layer("decade", build.shape(Line{{0, y}, {aspect, y}, 0.0015}), {.color = kRule});
    word(fmt::format("1e{:.0f}", decade), {-0.015, y}, 1, kInk);
  }
  word("0", {0, -0.035}, 0.5, kInk);
  word("components", {0.5 * aspect, -0.035}, 0.5, kInk);
  word(fmt::format("{}", curve.back().count), {aspect, -0.035}, 0.5, kInk);
  build.layer("axis", build.shape(Polyline{{{0, 1}, {0, 0}, {aspect, 0}}, 0.003}), {.color = kInk});
  const auto line = [&](double PcaError::*what, const char* name, const Color& color) {
    const auto points = points_of(curve, low, high, what, aspect);
    build.layer("curve", build.shape(Polyline{points, 0.004}), {.color = color});
    if (points.size() <= 65)
      for (const glm::dvec2 p : points)
        build.layer("point", build.shape(Disc{p, 0.011}), {.color = color});
    word(name, points.back() + glm::dvec2{0.025, 0}, 0, color);
  };
  line(&PcaError::rms, "rms", kRmsColor);
  line(&PcaError::max, "max", kMostColor);
  return sheet_picture(std::move(build).finish(), {.width = width, .height = height});
}

}  // namespace mien::command
