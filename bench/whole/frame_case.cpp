#include "bench/whole/frame_case.h"

#include <mien/face_model.h>

#include <array>
#include <optional>
#include <utility>

#include "bench/whole/flat_scene.h"

namespace mien::bench {
namespace {

using Size = std::array<int, 2>;

constexpr int kSteps = 100;         // faces that differ from each other
constexpr double kShrink = 1e-5;    // of every length, per step
constexpr double kGazeStep = 1e-4;  // [units of the control]

bool is_length(SliceKind kind) {
  return kind == SliceKind::point || kind == SliceKind::shift || kind == SliceKind::length ||
         kind == SliceKind::parabola;
}

void add(std::vector<FrameCase>& to, FrameCase c, const std::vector<Size>& sizes) {
  for (const Size& size : sizes) {
    c.width = size[0], c.height = size[1];
    to.push_back(c);
  }
}

}  // namespace

std::vector<FrameCase> frame_cases() {
  const std::vector<Size> wide{{64, 36}, {256, 144}, {640, 360}, {1920, 1080}, {7680, 4320}};
  std::vector<Size> wider = wide;
  wider.push_back({15360, 8640});
  const std::vector<Size> square{{64, 64}, {256, 256}, {640, 640}, {1920, 1920}, {7680, 7680}};
  const std::vector<Size> squares{{64, 64},     {256, 256},   {512, 512},   {640, 640},
                                  {1920, 1920}, {2048, 2048}, {7680, 7680}, {8192, 8192}};
  std::vector<FrameCase> cases;
  add(cases, {'A', "seed0", {"gaze.x=0.03", "gaze.y=-0.02"}, true}, wider);
  add(cases, {'B', "male", {}, true}, squares);
  add(cases, {'C', "toon", {}, true}, wide);
  add(cases, {'D', "bruno", {}, true}, wide);
  add(cases, {'E', "clay", {}, true}, square);
  add(cases, {'F', "bruno", {}, false}, wide);
  return cases;
}

std::vector<FrameCase> reuse_cases() {
  std::vector<FrameCase> cases;
  for (const FrameCase& c : frame_cases())
    if (c.reliefs && (cases.empty() || cases.back().scene != c.scene)) {
      cases.push_back(c);
      cases.back().width = 640, cases.back().height = 360;
    }
  return cases;
}

std::string face_path(const FrameCase& c) {
  return std::string(MIEN_SOURCE_DIR) + "/faces/compat/" + c.face + ".face.json";
}

Subject::Subject(const FrameCase& c) : face_(*read_face(face_path(c))), reliefs_(c.reliefs) {
  for (const char* text : c.settings) pose_.settings.push_back(*read_setting(face_, text));
  if (const auto gaze = read_setting(face_, "gaze.x=0")) {
    gaze_ = *gaze;
    for (const Setting& setting : pose_.settings)
      if (setting.control && setting.index == gaze_->index) gaze_ = setting;
  }
}

Face Subject::face(int step) const {
  Face smaller = face_;
  const double by = 1 - kShrink * (step % kSteps);
  for (const Slice& slice : face_.model->layout.slices()) {
    if (!is_length(slice.kind)) continue;
    for (int i = slice.begin; i < slice.begin + slice.size; ++i)
      smaller.vector[std::size_t(i)] *= by;
  }
  return smaller;
}

Pose Subject::pose(int step) const {
  Pose pose = pose_;
  if (gaze_ && step) {
    pose.settings.push_back(*gaze_);
    pose.settings.back().values[0] += kGazeStep * (step % kSteps);
  }
  return pose;
}

Scene Subject::as_wanted(Scene scene) const {
  return reliefs_ ? std::move(scene) : without_reliefs(scene);
}

Scene Subject::scene(int step) const {
  return as_wanted(scene_from_face(pose_face(face(step), pose())));
}

}  // namespace mien::bench
