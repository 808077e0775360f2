// mien mesh: draws heads of triangles: the neutral, its wires, targets, and how far each point moves.

#include <mien/mesh_morph.h>
#include <mien/obj.h>
#include <mien/render.h>
#include <mien/scene_from_mesh.h>
#include "lib/base/nearest_name.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/named_file.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/output/contact_sheet.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace mien::command {
namespace {

constexpr int kDefaultHead = 320, kMostHead = 4096;
constexpr int kHeadColumns = 5;
constexpr int kGap = 8;
constexpr double kWire = 0.0012;  // half-width of a wire, of the picture's longer side

struct Heads {
  Mesh neutral;
  std::vector<std::string> names;
  std::vector<Mesh> targets;
};

Expected<Heads> read_heads(const MeshArguments& arguments) {
  auto neutral = read_obj(arguments.neutral);
  if (!neutral) return neutral.error();
  if (neutral->triangles.empty())
    return Error{arguments.neutral, "has points and no faces: nothing can be drawn"};
  Heads heads{*std::move(neutral), {}, {}};
  for (const std::string& text : arguments.targets) {
    const auto [name, file] = name_and_file(text);
    auto mesh = read_obj(file);
    if (!mesh) return mesh.error();
    if (const auto fits = check_fits(heads.neutral, *mesh, file); !fits) return fits.error();
    heads.names.push_back(name);
    heads.targets.push_back(*std::move(mesh));
  }
  return heads;
}

/// One weight of each target, from NAME=WEIGHT.
Expected<std::vector<double>> read_weights(const MeshArguments& arguments, const Heads& heads) {
  std::vector<double> weights(heads.targets.size(), 0.0);
  for (const std::string& text : arguments.weights) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    const auto found = std::find(heads.names.begin(), heads.names.end(), name);
    if (found == heads.names.end())
      return Error{"--weight " + text,
                   unknown_name("target", name, {heads.names.begin(), heads.names.end()})};
    const auto weight =
        read_real("--weight", equals < text.size() ? text.substr(equals + 1) : "1", -100, 100);
    if (!weight) return weight.error();
    weights[std::size_t(found - heads.names.begin())] = *weight;
  }
  return weights;
}

/// The mesh turned to its left by yaw, then up by pitch [degrees].
Mesh turned(Mesh mesh, double yaw, double pitch) {
  const double a = glm::radians(yaw), b = glm::radians(pitch);
  for (glm::dvec3& p : mesh.points) {
    p = {p.x * std::cos(a) + p.z * std::sin(a), p.y, p.z * std::cos(a) - p.x * std::sin(a)};
    p = {p.x, p.y * std::cos(b) + p.z * std::sin(b), p.z * std::cos(b) - p.y * std::sin(b)};
  }
  return mesh;
}

/// Draws heads, all in one frame.
class HeadPainter {
 public:
  HeadPainter(int side, double yaw, double pitch) : side_(side), yaw_(yaw), pitch_(pitch) {}

  void include(const Mesh& mesh) {
    for (const glm::dvec3& p : turned({mesh.points, {}}, yaw_, pitch_).points)
      box_ = around(box_, {p.x, p.y});
  }

  Image paint(const Mesh& mesh, const std::string& caption, bool wire = false,
              std::span<const double> amounts = {}) const {
    const double longer = std::max({box_.size().x, box_.size().y, 1e-9});
    MeshLook look{.box = grown(box_, 0.05 * longer)};
    if (wire) look.wire = kWire * longer;
    const glm::dvec2 size = look.box.size();
    const auto pixels = [&](double length) {
      return std::max(1, int(std::lround(side_ * length / std::max(size.x, size.y))));
    };
    const View view{.width = pixels(size.x), .height = pixels(size.y)};
    return captioned(
        sheet_picture(scene_from_mesh(turned(mesh, yaw_, pitch_), amounts, look), view), caption);
  }

  /// A heat map of each point's distance from the neutral; the caption tells the end of the scale.
  Image paint_heat(const Mesh& neutral, const Mesh& mesh) const {
    std::vector<double> amounts = point_distances(neutral, mesh);
    const double largest = amounts.empty() ? 0 : *std::max_element(amounts.begin(), amounts.end());
    if (largest > 0)
      for (double& amount : amounts) amount /= largest;
    return paint(mesh, fmt::format("to {:.4g}", largest), false, amounts);
  }

 private:
  int side_;
  double yaw_, pitch_;
  Box2 box_;
};

/// Bands of two rows: heads above, and below each the heat map of its points' ways. The first is the
/// neutral over its wires.
std::vector<Image> sheet_of(const Heads& heads, const HeadPainter& painter, int columns) {
  const std::size_t count = heads.targets.size() + 1;
  std::vector<Image> pictures;
  const Image empty = painter.paint({}, "");
  WatchedWork work("heads", 2 * count);
  for (std::size_t first = 0; first < count; first += std::size_t(columns))
    for (const bool below : {false, true})
      for (std::size_t i = first; i < first + std::size_t(columns); ++i) {
        if (i >= count) {
          pictures.push_back(empty);
        } else if (i == 0) {
          const std::string caption =
              below ? fmt::format("{} triangles", heads.neutral.triangles.size()) : "neutral";
          pictures.push_back(painter.paint(heads.neutral, caption, below));
        } else {
          const Mesh& target = heads.targets[i - 1];
          pictures.push_back(below ? painter.paint_heat(heads.neutral, target)
                                   : painter.paint(target, heads.names[i - 1]));
        }
        if (i < count) work.step();
      }
  return pictures;
}

}  // namespace

int mesh_command(const MeshArguments& arguments) {
  const auto side =
      read_whole("--size", arguments.size.value_or(std::to_string(kDefaultHead)), 16, kMostHead);
  if (!side) return complain(side.error(), kUsedWrongly);
  const auto yaw = read_real("--yaw", arguments.yaw.value_or("0"), -180, 180);
  if (!yaw) return complain(yaw.error(), kUsedWrongly);
  const auto pitch = read_real("--pitch", arguments.pitch.value_or("0"), -90, 90);
  if (!pitch) return complain(pitch.error(), kUsedWrongly);
  const auto heads = read_heads(arguments);
  if (!heads) return complain(heads.error(), kFailed);
  const auto weights = read_weights(arguments, *heads);
  if (!weights) return complain(weights.error(), kUsedWrongly);

  HeadPainter painter(int(*side), *yaw, *pitch);
  painter.include(heads->neutral);
  std::vector<Image> pictures;
  int columns = std::min(kHeadColumns, int(heads->targets.size()) + 1);
  if (arguments.weights.empty()) {
    for (const Mesh& target : heads->targets) painter.include(target);
    pictures = sheet_of(*heads, painter, columns);
  } else {
    const Mesh mix = morphed_mesh(heads->neutral, heads->targets, *weights);
    painter.include(mix);
    pictures = {painter.paint(heads->neutral, "neutral"), painter.paint(mix, "mix"),
                painter.paint_heat(heads->neutral, mix)};
    columns = 3;
  }
  const auto done =
      write_image_by(load_encoder, contact_sheet(pictures, columns, kGap), arguments.output, {});
  return done ? kDone : complain(done.error(), kFailed);
}

}  // namespace mien::command
