// Posing, and posing with a scene: one frame of an animation on one core.

#include <mien/face_file.h>
#include <mien/poser.h>
#include <mien/scene_from_face.h>

#include <benchmark/benchmark.h>

#include <string>

namespace mien {
namespace {

Face face_named(const char* name) {
  return *read_face(std::string(MIEN_SOURCE_DIR "/faces/compat/") + name + ".face.json");
}

/// Everything the eyes can do at once.
Pose pose_at(double time) {
  return {.time = time, .look_at = glm::dvec3{0.3, 0.1, 1 + time}};
}

void pose_alone(benchmark::State& state, const char* name) {
  Poser poser(face_named(name));
  double time = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(poser.pose(pose_at(time += 1 / 60.0)).vector.data());
}

void pose_and_scene(benchmark::State& state, const char* name) {
  Poser poser(face_named(name));
  double time = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        scene_from_face(poser.pose(pose_at(time += 1 / 60.0))).layers().data());
}

BENCHMARK_CAPTURE(pose_alone, toon, "toon");
BENCHMARK_CAPTURE(pose_alone, seed0, "seed0");
BENCHMARK_CAPTURE(pose_alone, male, "male");
BENCHMARK_CAPTURE(pose_and_scene, toon, "toon");
BENCHMARK_CAPTURE(pose_and_scene, seed0, "seed0");
BENCHMARK_CAPTURE(pose_and_scene, male, "male");

}  // namespace
}  // namespace mien
