#pragma once
// Heads of triangles in other shapes: the sums that morph targets are made of, before any face.

#include <mien/api.h>
#include <mien/mesh.h>

#include <span>
#include <vector>

namespace mien {

/// neutral + Σ wᵢ (targetᵢ − neutral), point by point, with the neutral's triangles. Targets have as
/// many points as the neutral (check_fits), and there are as many weights. All weights 0 give the
/// neutral, and one alone at 1 its target, bit for bit.
MIEN_API Mesh morphed_mesh(const Mesh& neutral, std::span<const Mesh> targets,
                           std::span<const double> weights);

/// How far each point is from where it was [units of the mesh].
MIEN_API std::vector<double> point_distances(const Mesh& from, const Mesh& to);

}  // namespace mien
