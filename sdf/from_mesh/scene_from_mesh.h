#pragma once
// A mesh as a scene: flat-shaded triangles, the farthest first, seen along −z (x right, y up).
//
// Triangles that share an edge share it exactly, so that no seam shows the background between them.

#include <mien/api.h>
#include <mien/box2.h>
#include <mien/mesh.h>
#include <mien/scene.h>

#include <span>

namespace mien {

struct MeshLook {
  Box2 box;  ///< what the picture shows; empty: the mesh, with a margin of a twentieth
  Color background{0.010, 0.011, 0.015, 1};
  Color surface{0.55, 0.46, 0.40, 1};
  double wire = 0;  ///< half-width of lines along the edges, in the mesh's units; 0: none
};

/// `amounts`: one of each point, 0 … 1 of the heat spectrum, instead of the surface's colour; may be
/// empty. Triangles of no area are not drawn; without triangles points are drawn as discs.
MIEN_API Scene scene_from_mesh(const Mesh& mesh, std::span<const double> amounts = {},
                               const MeshLook& look = {});

}  // namespace mien
