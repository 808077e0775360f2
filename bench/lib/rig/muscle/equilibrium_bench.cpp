// What muscles cost on the male face: the equilibrium of each emotion and of a mix, and a pose with its
// scene when the equilibrium is known.

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/poser.h>
#include <mien/scene_from_face.h>
#include "lib/rig/muscle/motion.h"
#include "lib/rig/pose/expression_setting.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

namespace mien {
namespace {

Face male() {
  const auto face = read_face("faces/compat/male.face.json");
  if (!face) std::abort();  // run it in the tree's root
  return *face;
}

Pose emotions(const Face& face, const std::vector<std::string>& texts) {
  Pose pose;
  for (const std::string& text : texts)
    pose.settings.push_back(*read_expression(face, "emotion", text));
  return pose;
}

void equilibrium(benchmark::State& state, const std::vector<std::string>& texts) {
  const Face face = male();
  Poser poser(face);
  poser.pose(emotions(face, texts));
  const std::vector<double> pulls(poser.pulls().begin(), poser.pulls().end());
  MuscleShape shape;
  MusclePointLaw law;
  for (auto _ : state) {
    muscle_still(*face.model, face.vector, pulls, shape, law);
    benchmark::DoNotOptimize(shape.points.data());
  }
}

void pose_and_scene(benchmark::State& state) {
  const Face face = male();
  Poser poser(face);
  const Pose pose = emotions(face, {"joy=0.8"});
  for (auto _ : state) benchmark::DoNotOptimize(scene_from_face(poser.pose(pose)));
}

BENCHMARK_CAPTURE(equilibrium, joy, {"joy"});
BENCHMARK_CAPTURE(equilibrium, sadness, {"sadness"});
BENCHMARK_CAPTURE(equilibrium, anger, {"anger"});
BENCHMARK_CAPTURE(equilibrium, disgust, {"disgust"});
BENCHMARK_CAPTURE(equilibrium, fear, {"fear"});
BENCHMARK_CAPTURE(equilibrium, surprise, {"surprise"});
BENCHMARK_CAPTURE(equilibrium, mix, {"joy=0.5", "surprise=0.7"});
BENCHMARK(pose_and_scene);

}  // namespace
}  // namespace mien
