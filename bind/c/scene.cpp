// Scenes: layers, and what is where.

#include <mien/feature_at.h>
#include <mien/scene_from_face.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"

using namespace mien::c;

extern "C" {

mien_status mien_scene_new(mien_pose* pose, mien_scene** out, mien_error** error) {
  return pass("mien_scene_new", error, [&] {
    mien_scene*& made = place(out);
    made = new mien_scene{mien::scene_from_face(need(pose, "pose").posed())};
  });
}

void mien_scene_free(mien_scene* scene) {
  delete scene;
}

mien_status mien_scene_text(const mien_scene* scene, mien_texts** out, mien_error** error) {
  return pass("mien_scene_text", error, [&] {
    mien_texts*& made = place(out);
    made = new_texts({need(scene, "scene").scene.text()});
  });
}

mien_status mien_scene_background(const mien_scene* scene, double color[4], mien_error** error) {
  return pass("mien_scene_background", error, [&] {
    const mien::Color& c = need(scene, "scene").scene.background();
    need(color, "color");
    color[0] = c.r, color[1] = c.g, color[2] = c.b, color[3] = c.a;
  });
}

int32_t mien_scene_layer_count(const mien_scene* scene) {
  return scene ? int32_t(scene->scene.layers().size()) : 0;
}

const char* mien_scene_layer_name(const mien_scene* scene, int32_t layer) {
  if (layer < 0 || layer >= mien_scene_layer_count(scene)) return "";
  return scene->scene.layers()[std::size_t(layer)].name.c_str();
}

mien_status mien_scene_distance(const mien_scene* scene, int32_t layer, double x, double y,
                                double* out, mien_error** error) {
  return pass("mien_scene_distance", error, [&] {
    const mien::Scene& in = need(scene, "scene").scene;
    need(out, "out") = 0;
    const auto at = std::size_t(index_of(layer, in.layers().size(), "layer"));
    *out = in.distance(in.layers()[at].area, {need_finite(x, "x"), need_finite(y, "y")});
  });
}

mien_status mien_scene_layer_at(const mien_scene* scene, double x, double y, int32_t* out,
                                mien_error** error) {
  return pass("mien_scene_layer_at", error, [&] {
    const mien::Scene& in = need(scene, "scene").scene;
    need(out, "out") = -1;
    const glm::dvec2 p{need_finite(x, "x"), need_finite(y, "y")};
    for (auto layer = int32_t(in.layers().size()) - 1; layer >= 0; --layer)
      if (in.distance(in.layers()[std::size_t(layer)].area, p) <= 0) {
        *out = layer;
        return;
      }
  });
}

mien_status mien_scene_feature_at(const mien_scene* scene, double x, double y, mien_texts** out,
                                  mien_error** error) {
  return pass("mien_scene_feature_at", error, [&] {
    const mien::Scene& in = need(scene, "scene").scene;
    mien_texts*& made = place(out);
    const std::string_view feature =
        mien::feature_at(in, {need_finite(x, "x"), need_finite(y, "y")});
    made = feature.empty() ? new_texts({}) : new_texts({std::string(feature)});
  });
}
}
