#pragma once
// A face of every primitive beyond plain figures: patterns, made areas, clips, pen contours, feathers. Each is named, so
// that it can be drawn alone.

#include <map>
#include <string>

namespace mien::test {

/// By what they show; "head" and "cap" are what the others stand on.
inline const std::map<std::string, std::string>& primitive_features() {
  static const std::map<std::string, std::string> all{
      {"head",
       R"({"name": "head", "kind": "path", "paint": "skin", "points": [[0, 0.8, "bend"], [0.6, 0.7, "bend"], [0.6, 0, "bend"],
           [0.4, -0.6, "bend"], [0, -0.7, "bend"], [-0.4, -0.6, "bend"], [-0.6, 0, "bend"], [-0.6, 0.7, "bend"]]})"},
      {"cap",
       R"({"name": "cap", "kind": "path", "points": [[-0.6, 0.35], [0, 0.5, "bend"], [0.6, 0.35], [0.62, 0.95, "bend"], [-0.62, 0.95, "bend"]]})"},
      {"outside",
       R"({"name": "hair", "kind": "path", "paint": "black", "clip": {"outside": "cap"}, "points": [[0, 1, "bend"], [0.8, 0.9, "bend"],
           [0.75, 0, "bend"], [0.5, -0.3, "bend"], [0.5, 0.3, "bend"], [-0.5, 0.3, "bend"], [-0.5, -0.3, "bend"], [-0.75, 0, "bend"], [-0.8, 0.9, "bend"]]})"},
      {"clips",
       R"({"name": "band", "kind": "ellipse", "paint": "black", "center": [0.1, 0.3], "radii": [0.7, 0.3], "tilt": 20, "clip": ["head", {"outside": "cap"}]})"},
      {"area",
       R"({"name": "ring", "kind": "disc", "center": [0.1, 0], "radius": 0.5}, {"name": "hole", "kind": "disc", "center": [0.2, 0], "radius": 0.35},
          {"name": "made", "kind": "area", "paint": "black", "all": ["head"], "any": ["ring", "cap"], "minus": ["hole"]})"},
      {"scatter",
       R"({"name": "freckles", "kind": "scatter", "side": "left", "paint": "half", "patch": [[[0, 0.1], [0.3, 0.2], [0.5, 0]], [[0, -0.3], [0.3, -0.4], [0.5, -0.3]]],
           "count": 30, "seed": 4, "jitter": 0.8, "round": true, "of": "ellipse", "radii": [0.05, 0.03], "vary": 0.5, "sway": 90})"},
      {"lattice",
       R"({"name": "dots", "kind": "scatter", "paint": "black", "patch": [[[-0.9, -0.9], [0.9, -0.8]], [[-0.7, 0.9], [0.8, 0.7]]], "count": [5, 6],
           "stagger": true, "of": "disc", "radius": 0.09, "clip": "head"})"},
      {"repeat",
       R"({"name": "beads", "kind": "repeat", "paint": "black", "points": [[-0.8, 0.2], [0, -0.7], [0.8, 0.2]], "smooth": true, "count": 11,
           "of": "stroke", "length": 0.3, "half_width": [0.01, 0.05, 0.02], "tilt": 70, "jitter": 0.5, "sway": 20, "seed": 2})"},
      {"stripes",
       R"({"name": "hatching", "kind": "stripes", "paint": "half", "patch": [[[-0.8, 0.7], [0, 0.9], [0.8, 0.7]], [[-0.6, -0.6], [0, -0.2], [0.6, -0.8]]],
           "count": 9, "half_width": [0, 0.05, 0.01], "jitter": 0.6, "vary": 0.4, "seed": 3})"},
      {"rounded",
       R"({"name": "glass", "kind": "rounded", "paint": "black", "center": [0.1, 0.1], "radii": [0.7, 0.4], "corner": 0.2, "tilt": 25})"},
      {"pen by angle",
       R"({"name": "ear", "kind": "path", "paint": "half", "clip": "head", "points": [[-0.7, -0.4, "bend"], [0.1, -0.8, "bend"], [0.8, 0.6, "bend"], [0, 0.1, "bend"]],
           "contour": {"color": "black", "widths": [0.02, 0.08], "by": "angle"}})"},
      {"pen along",
       R"({"name": "leaf", "kind": "path", "paint": "half", "points": [[-0.7, -0.5], [-0.6, 0.7, "bend"], [0.8, 0.5, "bend"], [0.5, -0.7]],
           "contour": {"color": "black", "widths": [0, 0.09], "by": "along"}})"},
      {"widths",
       R"({"name": "lash", "kind": "polyline", "paint": "half", "points": [[-0.8, -0.3], [-0.3, 0.4], [0.3, -0.2], [0.8, 0.5]], "smooth": true, "half_width": [0, 0.1, 0.03, 0]},
          {"name": "whisker", "kind": "polyline", "paint": "half", "points": [[-0.8, -0.6], [0, -0.4], [0.8, -0.8]], "half_width": [0.08, 0.03, 0.01]})"},
      {"feather",
       R"({"name": "blush", "kind": "ellipse", "paint": "black", "center": [0.1, 0.1], "radii": [0.7, 0.5], "feather": 0.3, "opacity": 0.8})"},
      {"shadow on",
       R"({"name": "brim", "kind": "stroke", "paint": "black", "spine": [[-0.9, 0.4], [0, 0.6], [0.9, 0.3]], "half_width": 0.1,
           "shadow": {"color": "half", "blur": 0.15, "shift": [0, -0.3], "on": "head"}})"}};
  return all;
}

/// A face of some of them, on a head with a cap that is not drawn.
inline std::string face_of_primitives(const std::string& features) {
  const auto& all = primitive_features();
  return R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"skin": "#f7db9c", "black": [0, 0, 0], "half": "#80204090", "white": [255, 255, 255]}, "background": "white",
"features": [)" +
         all.at("head") + ",\n" + all.at("cap") + ",\n" + features + "]}";
}

}  // namespace mien::test
