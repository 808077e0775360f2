#include "lib/base/watch.h"
#include "render/svg/distance_bands.h"
#include "render/svg/path_data.h"
#include "render/svg/svg_color.h"
#include "render/svg/svg_writer_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace mien {
namespace {

/// Of the tolerance: what boundaries may take, and what rounding may.
constexpr double kBoundaryShare = 0.9, kRoundingShare = 0.1;
/// [px] Paths go on so far beyond the picture, so that its sides are not drawn as edges where it is scaled.
constexpr double kBeyond = 1.0;

Map<GridSpace, FaceSpace> grid_of(const Canvas& canvas, const SvgOptions& options) {
  const glm::dvec2 size{options.width, options.height};
  const Map<PixelSpace, FaceSpace> map = pixel_from_face(canvas, size, options.fit);
  return {map.linear, map.shift + 0.5 * size};
}

Box2 window_of(const SvgOptions& options) {
  return grown({{0.0, 0.0}, {options.width, options.height}}, kBeyond);
}

/// Whether light falls on it as on a level surface, which keeps its colours.
bool is_level(const Relief& relief) {
  const bool profile =
      relief.area.node >= 0 && relief.profile != Profile::flat && relief.height != 0.0;
  return !profile && std::all_of(relief.domes.begin(), relief.domes.end(),
                                 [](const Dome& dome) { return dome.height == 0.0; });
}

}  // namespace

SvgWriter::SvgWriter(const Scene& scene, const SvgOptions& options)
    : scene_(scene),
      options_(options),
      map_(grid_of(scene.canvas(), options)),
      decimals_(decimals_for(kRoundingShare * options.tolerance)),
      boundaries_(scene, map_, window_of(options), kBoundaryShare * options.tolerance),
      ids_(options.id_prefix.value_or("")),
      clips_(scene.nodes().size()) {}

Svg SvgWriter::write(double& done) {
  background();
  count_clips();
  for (const Layer& l : scene_.layers()) {
    layer(l);
    done += 1.0 / double(scene_.layers().size());
    worked(1000);
  }
  go_to_group(-1);
  std::string text = head();
  if (!definitions_.empty()) text += "<defs>\n" + definitions_ + "</defs>\n";
  return {text + body_ + "</svg>\n", std::move(simplified_)};
}

std::string SvgWriter::head() {
  const bool mixes = std::any_of(scene_.groups().begin(), scene_.groups().end(),
                                 [](const Group& g) { return g.mix != MixMode::normal; });
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" fill-rule=\"evenodd\" clip-rule=\"evenodd\"{2}>\n",
      options_.width, options_.height, mixes ? " style=\"isolation:isolate\"" : "");
  if (!options_.title.empty()) text += "<title>" + xml_escaped(options_.title) + "</title>\n";
  if (!options_.recipe.empty())
    text += "<metadata>" + xml_escaped(options_.recipe) + "</metadata>\n";
  return text;
}

void SvgWriter::background() {
  const Color color = options_.background.value_or(scene_.background());
  if (!(color.a > 0.0)) return;
  const Box2 box = window_of(options_);
  const glm::dvec2 size = box.size();
  body_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", box.lo.x, box.lo.y,
                  size.x, size.y, svg_paint(mix_from_color(color, Blend::srgb)).fill);
}

/// What stands right in an intersection of several layers is a clip: builders put it there.
void SvgWriter::count_clips() {
  for (const Layer& l : scene_.layers()) {
    if (l.area.node < 0) continue;
    const Node& node = scene_.nodes()[std::size_t(l.area.node)];
    if (node.op == Op::intersect) ++clips_[std::size_t(node.b)].users;
  }
}

bool SvgWriter::mixes_below(int group) const {
  return std::any_of(scene_.groups().begin(), scene_.groups().end(),
                     [&](const Group& g) { return g.parent == group && g.mix != MixMode::normal; });
}

void SvgWriter::go_to_group(int group) {
  std::vector<int> chain;
  for (int g = group; g >= 0; g = scene_.groups()[std::size_t(g)].parent) chain.push_back(g);
  std::reverse(chain.begin(), chain.end());
  const auto parted = std::mismatch(open_.begin(), open_.end(), chain.begin(), chain.end());
  const auto same = std::size_t(parted.first - open_.begin());
  for (; open_.size() > same; open_.pop_back()) body_ += "</g>\n";
  for (std::size_t i = same; i < chain.size(); ++i) open_group(chain[i]);
}

void SvgWriter::open_group(int index) {
  const Group& group = scene_.groups()[std::size_t(index)];
  body_ += "<g" + named(group.name) + svg_opacity("opacity", group.opacity);
  if (group.mix != MixMode::normal)
    body_ += fmt::format(" style=\"mix-blend-mode:{}\"", kMixModes[std::size_t(group.mix)]);
  else if (mixes_below(index))
    body_ += " style=\"isolation:isolate\"";
  body_ += ">\n";
  open_.push_back(index);
}

void SvgWriter::simplified(const Layer& layer, const std::string& what) {
  simplified_.push_back(fmt::format("layer \"{}\": {}", layer.name, what));
}

std::string SvgWriter::named(const std::string& name) {
  const std::string id = ids_.unique(name);
  const std::string_view said =
      std::string_view(id).substr(std::min(options_.id_prefix->size(), id.size()));
  if (said == name) return fmt::format(" id=\"{}\"", id);
  return fmt::format(" id=\"{}\" data-name=\"{}\"", id, xml_escaped(name));
}

void SvgWriter::layer(const Layer& layer) {
  go_to_group(layer.group);
  const Paint& paint = layer.paint;
  if (paint.relief && !is_level(*paint.relief))
    simplified(layer, "its relief is left out, for SVG knows no such light");
  const Mix plain = mix_from_color(paint.color, Blend::srgb);
  if (!(plain.a > 0.0)) return;
  Area area = layer.area;
  const std::string clip = clipped(area, layer.name);
  if (paint.gradient && std::holds_alternative<DistanceGradient>(paint.gradient->along))
    return along_distance(layer, area, clip);
  const std::string data = path_of({{area}}, layer.name);
  if (data.empty()) return;
  SvgPaint fill = svg_paint(plain);
  if (paint.gradient) {
    const Ramp ramp(*paint.gradient, paint.color.a, Blend::srgb);
    const std::string id = ids_.unique(layer.name + ".paint");
    if (const auto* line = std::get_if<LinearGradient>(&paint.gradient->along))
      fill = svg_paint(*line, ramp, map_, id);
    else if (const auto* center = std::get_if<RadialGradient>(&paint.gradient->along))
      fill = svg_paint(*center, ramp, map_, id);
    definitions_ += fill.definition;
  }
  path(data, named(layer.name) + fill.fill + clip);
}

void SvgWriter::along_distance(const Layer& layer, Area area, const std::string& attributes) {
  const Gradient& gradient = *layer.paint.gradient;
  const auto& along = std::get<DistanceGradient>(gradient.along);
  const DistanceBands steps =
      distance_bands(along, Ramp(gradient, layer.paint.color.a, Blend::srgb));
  body_ += "<g" + named(layer.name) + svg_opacity("opacity", steps.opacity) + attributes + ">\n";
  int drawn = 0;
  for (const DistanceBand& band : steps.bands) {
    std::vector<AreaLevel> all{{area}};
    all.insert(all.end(), band.within.begin(), band.within.end());
    const std::string data = path_of(all, layer.name);
    if (data.empty()) continue;
    path(data, svg_paint(band.mix).fill);
    ++drawn;
  }
  body_ += "</g>\n";
  simplified(layer,
             fmt::format("its gradient along a distance is drawn in {} steps{}", drawn,
                         gradient.extend == Extend::pad ? "" : ", once, not again and again"));
}

std::string SvgWriter::clipped(Area& area, const std::string& name) {
  if (area.node < 0) return {};
  const Node& node = scene_.nodes()[std::size_t(area.node)];
  if (node.op != Op::intersect || clips_[std::size_t(node.b)].users < 2) return {};
  const Clip& by = clip(node.b, name);
  area = {node.a};
  return by.whole ? std::string() : fmt::format(" clip-path=\"url(#{})\"", by.id);
}

const SvgWriter::Clip& SvgWriter::clip(int node, const std::string& name) {
  Clip& made = clips_[std::size_t(node)];
  if (made.written) return made;
  made.written = true;
  const std::string data = path_of({{Area{node}}}, name);
  made.whole = whole_;
  if (made.whole) return made;
  made.id = ids_.unique(name + ".clip");
  definitions_ += fmt::format("<clipPath id=\"{}\">{}</clipPath>\n", made.id,
                              data.empty() ? std::string() : fmt::format("<path d=\"{}\"/>", data));
  return made;
}

std::string SvgWriter::path_of(const std::vector<AreaLevel>& all, const std::string& name) {
  const AreaBoundary boundary = boundaries_.of(all);
  whole_ = boundary.whole;
  if (boundary.doubts > 0)
    simplified_.push_back(
        fmt::format("layer \"{}\": the order of its outlines is not proven in {} places, where its "
                    "path may be wrong",
                    name, boundary.doubts));
  return path_data(boundary.loops, decimals_);
}

void SvgWriter::path(const std::string& data, const std::string& attributes) {
  body_ += fmt::format("<path{} d=\"{}\"/>\n", attributes, data);
}

}  // namespace mien
