#pragma once
// The feature seen at a place of a picture, by name: for pointers and for questions.
//
//   const glm::dvec2 p = face_from_pixel(place);
//   feature_at(scene, p);  // "iris.left"; "" where nothing is drawn

#include <mien/api.h>
#include <mien/scene.h>

#include <string_view>

namespace mien {

/// What a feature's further layers are called after its name: "lid.left/contour".
inline constexpr std::string_view kShadowLayer = "/shadow", kGlowLayer = "/glow",
                                  kContourLayer = "/contour";

/// The feature that a layer belongs to: its name without one of these endings.
MIEN_API std::string_view feature_of(const Layer& layer);

/// How opaque a layer and its groups are at p, 0 … 1; 0 outside its area.
MIEN_API double opacity_at(const Scene& scene, int layer, glm::dvec2 p);

/// The index of the uppermost layer at p, by the areas' distances; −1: none. Layers that are too transparent there to
/// change a pixel of 8 bits do not count, nor do shadows and glows: they fall on features but are not features.
MIEN_API int layer_seen_at(const Scene& scene, glm::dvec2 p);

/// The feature of that layer; "" where there is none. The text lives as long as the scene.
MIEN_API std::string_view feature_at(const Scene& scene, glm::dvec2 p);

}  // namespace mien
