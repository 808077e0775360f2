#pragma once
// Turns a face into a scene: each feature becomes a layer, in drawing order.

#include <mien/api.h>
#include <mien/face.h>
#include <mien/scene.h>

namespace mien {

/// Total: every valid face gives a scene, in the face's own units.
MIEN_API Scene scene_from_face(const Face& face);

}  // namespace mien
