#pragma once
// Turns a mesh into a scene: flat-shaded triangles, the farthest first, seen along −z (x right, y up).
//
// Neighbouring triangles share their edge exactly, so the background does not show through a seam.

#include <mien/api.h>
#include <mien/box2.h>
#include <mien/mesh.h>
#include <mien/scene.h>

#include <span>

namespace mien {

struct MeshLook {
  Box2 box;  ///< what the picture shows; if empty, the mesh with a margin of a twentieth
  Color background{0.010, 0.011, 0.015, 1};
  Color surface{0.55, 0.46, 0.40, 1};
  double wire = 0;  ///< half-width of lines along the edges, in the mesh's units; 0: none
};

/// `amounts` may be empty. Otherwise it holds a number in 0 … 1 for each point, and the heat spectrum replaces
/// the surface's colour. Triangles without area are not drawn. Without triangles, points are drawn as discs.
MIEN_API Scene scene_from_mesh(const Mesh& mesh, std::span<const double> amounts = {},
                               const MeshLook& look = {});

}  // namespace mien
