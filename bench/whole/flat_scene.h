#pragma once

#include <mien/scene.h>

namespace mien::bench {

/// The same scene, no layer of it lit: what a rasteriser of paths can draw too.
Scene without_reliefs(const Scene& scene);

}  // namespace mien::bench
