// mien bench: times whole frames, from pose to pixels, into an existing buffer. Frames are cold: each is of
// a face a little smaller than the one before, so nothing kept from one helps the next.

#include <mien/face_model.h>
#include <mien/renderer.h>
#include <mien/scene_from_face.h>
#include "lib/file/json/json_text.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/commands/render_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <vector>

namespace mien::command {
namespace {

constexpr int kWarmUp = 3;  // frames before the first that counts: pages, caches, threads
constexpr std::array<const char*, 3> kParts{"pose", "scene", "draw"};

constexpr int kSteps = 100;       // faces that differ from each other
constexpr double kShrink = 1e-5;  // of every length, per step

/// The face to draw in its place, with every point and length smaller by `step` times kShrink. Two steps in
/// a row have none of those numbers in common.
Face smaller(Face face, int step) {
  for (const Slice& slice : face.model->layout.slices()) {
    if (slice.kind != SliceKind::point && slice.kind != SliceKind::shift &&
        slice.kind != SliceKind::length && slice.kind != SliceKind::parabola)
      continue;
    for (int i = slice.begin; i < slice.begin + slice.size; ++i)
      face.vector[std::size_t(i)] *= 1 - kShrink * (step % kSteps);
  }
  return face;
}

double now_ms() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// [ms] of each frame measured, as a whole and by its parts.
struct Measured {
  std::vector<double> whole;
  std::array<std::vector<double>, kParts.size()> parts;
};

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const std::size_t half = times.size() / 2;
  return times.size() % 2 ? times[half] : 0.5 * (times[half - 1] + times[half]);
}

double least(const std::vector<double>& times) {
  return *std::min_element(times.begin(), times.end());
}

/// Frames of one picture, no two in a row quite alike.
class Frames {
 public:
  Frames(const Face& face, const Pose& pose, const RenderPlan& plan)
      : face_(face), pose_(pose), plan_(plan) {
    buffer_.depth = plan.picture.depth.value_or(Depth::u8);
    how_.threads = plan.picture.write.threads;
    const PixelRect drawn = drawn_rect(plan.view);
    buffer_.stride = std::size_t(drawn.width) * 4 * bytes_per_channel(buffer_.depth);
    pixels_.resize(buffer_.stride * std::size_t(drawn.height));
    buffer_.data = pixels_.data();
  }

  void frame(Measured& to) {
    const Face face = smaller(face_, step_++);
    std::array<double, kParts.size() + 1> at;
    at[0] = now_ms();
    const Face posed = pose_face(face, pose_);
    at[1] = now_ms();
    const Scene scene = scene_from_face(posed);
    at[2] = now_ms();
    renderer_.render_into(buffer_, scene, plan_.view, how_).value();  // it was drawn before
    at[3] = now_ms();
    to.whole.push_back(at.back() - at[0]);
    for (std::size_t i = 0; i < kParts.size(); ++i) to.parts[i].push_back(at[i + 1] - at[i]);
  }

 private:
  const Face& face_;
  const Pose& pose_;
  const RenderPlan& plan_;
  RenderOptions how_;
  std::vector<std::byte> pixels_;
  PixelBuffer buffer_;
  Renderer renderer_;
  int step_ = 0;
};

Measured measure(const Face& face, const Pose& pose, const RenderPlan& plan, int repeat) {
  Frames frames(face, pose, plan);
  Measured warm, counted;
  for (int i = 0; i < kWarmUp; ++i) frames.frame(warm);
  for (int i = 0; i < repeat; ++i) frames.frame(counted);
  return counted;
}

std::string json_text(const Measured& took, const BenchArguments& arguments,
                      const RenderPlan& plan) {
  std::string parts;
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    parts += fmt::format("{}\"{}\": {:.6f}", i ? ", " : "", kParts[i], median(took.parts[i]));
  }
  const PixelRect drawn = drawn_rect(plan.view);
  return fmt::format(
      "{{\"median_ms\": {:.6f}, \"min_ms\": {:.6f}, \"parts\": {{{}}}, \"face\": {}, \"width\": "
      "{}, \"height\": {}, \"threads\": {}, \"repeat\": {}}}\n",
      median(took.whole), least(took.whole), parts,
      json_string(std::filesystem::path(arguments.render.posed.face).filename().string()),
      drawn.width, drawn.height, plan.picture.write.threads.count, took.whole.size());
}

std::string table_text(const Measured& took, const RenderPlan& plan) {
  const PixelRect drawn = drawn_rect(plan.view);
  std::string text = fmt::format(
      "{} cold frames of {} x {} pixels: each face is a little smaller than the last\n"
      "{:8}{:>12}{:>12}\n",
      took.whole.size(), drawn.width, drawn.height, "", "median ms", "min ms");
  const auto line = [&](const char* name, const std::vector<double>& times) {
    text += fmt::format("{:8}{:12.4f}{:12.4f}\n", name, median(times), least(times));
  };
  for (std::size_t i = 0; i < kParts.size(); ++i) line(kParts[i], took.parts[i]);
  line("frame", took.whole);
  return text;
}

}  // namespace

int bench_command(const BenchArguments& arguments) {
  auto plan = plan_frame(arguments.render);
  if (!plan) return complain(plan.error(), kUsedWrongly);
  int repeat = kDefaultRepeat;
  if (arguments.repeat) {
    const auto given = read_repeat(*arguments.repeat);
    if (!given) return complain(given.error(), kUsedWrongly);
    repeat = *given;
  }
  const auto read = read_face_and_pose(arguments.render.posed);
  if (!read.face) return read.code;
  const Canvas canvas = scene_from_face(*read.face).canvas();
  if (auto planned = plan_view(*plan, arguments.render, canvas); !planned) {
    return complain(planned.error(), kUsedWrongly);
  }
  const Measured took = measure(*read.face, read.pose, *plan, repeat);
  return print(arguments.json ? json_text(took, arguments, *plan) : table_text(took, *plan));
}

}  // namespace mien::command
