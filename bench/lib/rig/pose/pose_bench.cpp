// Posing, and posing with a scene: one frame of an animation on one core.

#include <mien/bound_motion.h>
#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/motion_file.h>
#include <mien/poser.h>
#include <mien/recipe.h>
#include <mien/scene_from_face.h>

#include <benchmark/benchmark.h>

#include <memory>
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

/// What following costs by itself: all shapes of ARKit and the head at a moment of a take of a million rows.
void moment_of_a_take(benchmark::State& state) {
  const auto table = std::make_shared<SampleTable>();
  constexpr std::size_t kRows = 1'000'000;
  const Face face = face_named("toon");
  Motion take{.name = "take", .settled = true};
  for (const SettableName& one : settable_names(face))
    if (one.control && one.name.starts_with("arkit."))
      take.channels.push_back({one.name, {SampledCurve{table, table->columns++}}});
  for (std::size_t row = 0; row < kRows; ++row) {
    table->times.push_back(double(row) / 60);
    for (std::size_t c = 0; c < table->columns; ++c)
      table->values.push_back(float((row * 7 + c) % 100) / 100);
  }
  const BoundMotion bound = bind_motion(take, face);
  double time = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(settings_at(*bound.motion, time += 1 / 25.0).data());
  state.counters["channels"] = double(table->columns);
}

/// A person who lives and talks, in a mood or none: mouth, speech and idle life in one pose.
void person_who_talks(benchmark::State& state, bool speaks, bool lives) {
  const Face face = *face_from_recipe(recipe_from_seed(5));
  const BoundMotion speech =
      bind_motion(*read_motion(MIEN_SOURCE_DIR "/examples/talk/hello.TextGrid"), face);
  Pose pose{.motions = {}};
  if (lives) pose.motions.push_back({.clip = face.model->default_clip});
  if (speaks) pose.motions.push_back({.motion = speech.motion});
  if (!lives && !speaks) pose.liveliness = 0;
  Poser poser(face);
  double time = 0;
  for (auto _ : state) {
    pose.time = time = time < 3 ? time + 1 / 60.0 : 0;
    benchmark::DoNotOptimize(poser.pose(pose).vector.data());
  }
}

BENCHMARK_CAPTURE(person_who_talks, rests, false, false);
BENCHMARK_CAPTURE(person_who_talks, lives, false, true);
BENCHMARK_CAPTURE(person_who_talks, talks, true, false);
BENCHMARK_CAPTURE(person_who_talks, lives_and_talks, true, true);
BENCHMARK(moment_of_a_take);
BENCHMARK_CAPTURE(pose_alone, toon, "toon");
BENCHMARK_CAPTURE(pose_alone, seed0, "seed0");
BENCHMARK_CAPTURE(pose_alone, male, "male");
BENCHMARK_CAPTURE(pose_and_scene, toon, "toon");
BENCHMARK_CAPTURE(pose_and_scene, seed0, "seed0");
BENCHMARK_CAPTURE(pose_and_scene, male, "male");

}  // namespace
}  // namespace mien
