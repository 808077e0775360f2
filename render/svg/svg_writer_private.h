#pragma once
// Writes a scene's layers, one after the other, as an SVG file.

#include <mien/svg.h>
#include "render/svg/area_boundary.h"
#include "render/svg/svg_gradient.h"
#include "render/svg/xml_text.h"

#include <string>
#include <vector>

namespace mien {

/// Used once. Its options have been looked at.
class SvgWriter {
 public:
  SvgWriter(const Scene& scene, const SvgOptions& options);

  /// `done`: the share so far.
  Svg write(double& done);

 private:
  /// An area that clips several layers.
  struct Clip {
    int users = 0;
    bool written = false;
    bool whole = false;
    std::string id;
  };
  std::string head();
  void background();
  void count_clips();
  bool mixes_below(int group) const;
  void go_to_group(int group);
  void open_group(int group);
  void layer(const Layer& layer);
  /// The layer's area, and ` clip-path="…"` where a clip is left to SVG.
  std::string clipped(Area& area, const std::string& name);
  const Clip& clip(int node, const std::string& name);
  void along_distance(const Layer& layer, Area area, const std::string& attributes);
  std::string path_of(const std::vector<AreaLevel>& all, const std::string& name);
  void path(const std::string& data, const std::string& attributes);
  /// ` id="…"`, and the name itself where the id is not it.
  std::string named(const std::string& name);
  void simplified(const Layer& layer, const std::string& what);

  const Scene& scene_;
  const SvgOptions& options_;
  const Map<GridSpace, FaceSpace> map_;
  const int decimals_;
  AreaBoundaries boundaries_;
  bool whole_ = false;  ///< whether the boundary made last covers all of the picture
  XmlIds ids_;
  std::vector<Clip> clips_;  ///< by node
  std::vector<int> open_;    ///< groups, from the outside in
  std::string definitions_, body_;
  std::vector<std::string> simplified_;
};

}  // namespace mien
