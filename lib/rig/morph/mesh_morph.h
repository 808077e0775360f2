#pragma once
// Morph targets of meshes: weighted sums, and displacements.

#include <mien/api.h>
#include <mien/mesh.h>

#include <span>
#include <vector>

namespace mien {

/// neutral + Σ wᵢ (targetᵢ − neutral), point by point, with the neutral's triangles. Every target has as many
/// points as the neutral (check_fits), and there is one weight per target. If all weights are 0 the result is
/// the neutral, bit for bit; if one is 1 and all others are 0, it is that target, bit for bit.
MIEN_API Mesh morphed_mesh(const Mesh& neutral, std::span<const Mesh> targets,
                           std::span<const double> weights);

/// The displacement of each point [units of the mesh].
MIEN_API std::vector<double> point_distances(const Mesh& from, const Mesh& to);

}  // namespace mien
