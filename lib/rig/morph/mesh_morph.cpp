#include <mien/mesh_morph.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace mien {

Mesh morphed_mesh(const Mesh& neutral, std::span<const Mesh> targets,
                  std::span<const double> weights) {
  Mesh out = neutral;
  const auto moved = [](double weight) { return weight != 0; };
  const auto alone = std::find_if(weights.begin(), weights.end(), moved);
  if (alone == weights.end()) return out;
  if (*alone == 1 && std::none_of(alone + 1, weights.end(), moved)) {
    out.points = targets[std::size_t(alone - weights.begin())].points;  // p + (q − p) is not q
    return out;
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (weights[i] == 0) continue;
    for (std::size_t p = 0; p < out.points.size(); ++p)
      out.points[p] += weights[i] * (targets[i].points[p] - neutral.points[p]);
  }
  return out;
}

std::vector<double> point_distances(const Mesh& from, const Mesh& to) {
  std::vector<double> distances(from.points.size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = glm::length(to.points[i] - from.points[i]);
  return distances;
}

}  // namespace mien
