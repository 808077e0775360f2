// Takes as the programs of their dialects write them (examples/take) on faces of every kind: lips are shut and lids down
// when the take says so, and not when it does not, but for a frame.

#include <mien/bound_motion.h>
#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/face_model.h>
#include <mien/motion_file.h>
#include <mien/poser.h>
#include "lib/rig/pose/curve.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

constexpr double kFrame = 1 / 25.0;
constexpr int kFrames = 76;

Motion read_take(const std::string& name) {
  std::vector<Error> told;
  auto take = read_motion(MIEN_SOURCE_DIR "/examples/take/" + name, &told);
  if (!take) throw std::runtime_error(sentence(take.error()));
  for (const Error& one : told) EXPECT_NE(one.what.find("\"pose_Tx\""), std::string::npos) << name;
  return *std::move(take);
}

double value(const Motion& take, std::string_view channel, double time) {
  for (const MotionChannel& one : take.channels)
    if (one.name == channel) return value_at(one.curves[0], time);
  throw std::runtime_error("no channel " + std::string(channel));
}

/// The rows of a take as frames of JSON, by frame(row, shapes).
template <class Frame>
Motion as_json(const Motion& take, Frame&& frame) {
  std::string text;
  for (int row = 0; row < kFrames; ++row) {
    std::vector<std::pair<std::string, double>> shapes;
    for (const MotionChannel& one : take.channels)
      if (one.name.starts_with("arkit."))
        shapes.emplace_back(one.name.substr(6), value_at(one.curves[0], row * kFrame));
    text += frame(row, shapes) + "\n";
  }
  std::vector<Error> told;
  auto read = read_motion_text(text, "json", &told);
  if (!read) throw std::runtime_error(sentence(read.error()));
  return *std::move(read);
}

Motion as_arkit(const Motion& take) {
  return as_json(take, [](int row, const auto& shapes) {
    std::string all;
    for (const auto& [name, number] : shapes)
      all += fmt::format("{}\"{}\":{}", all.empty() ? "" : ",", name, number);
    return fmt::format("{{\"timestamp\":{:.3f},\"isTracked\":true,\"blendShapes\":{{{}}}}}",
                       81234.5 + row * kFrame, all);
  });
}

Motion as_media_pipe(const Motion& take) {
  return as_json(take, [&](int row, const auto& shapes) {
    std::string all = "{\"categoryName\":\"_neutral\",\"score\":0.1}";
    for (const auto& [name, number] : shapes)
      if (name != "tongueOut")
        all += fmt::format(",{{\"categoryName\":\"{}\",\"score\":{}}}", name, number);
    const double yaw = value(take, "yaw", row * kFrame) * M_PI / 180;
    return fmt::format(
        "{{\"timestamp_ms\":{},\"faceBlendshapes\":[{{\"categories\":[{}]}}],"
        "\"facialTransformationMatrixes\":[{{\"rows\":4,\"columns\":4,\"data\":"
        "[{:.6f},0,{:.6f},0,0,1,0,0,{:.6f},0,{:.6f},0,0,0,-40,1]}}]}}",
        5000 + 40 * row, all, std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw));
  });
}

struct Take {
  std::string name;
  Motion motion;
};

std::vector<Take> takes() {
  const Motion live_link = read_take("live_link.csv");
  return {{"Live Link Face", live_link},
          {"ARKit", as_arkit(live_link)},
          {"MediaPipe", as_media_pipe(live_link)},
          {"OpenFace", read_take("open_face.csv")}};
}

std::vector<Face> actors() {
  std::vector<Face> all{test::sample_face("faces/toon"), test::sample_face("faces/bruno"),
                        test::sample_face("faces/clay")};
  for (int i = 0; i < 3; ++i)
    all.push_back(
        face_from_recipe(recipe_from_seed(seed_from_word(fmt::format("acts/{}", i)))).value());
  return all;
}

using Frames = std::vector<bool>;

/// What a take says, by its own numbers.
Frames said_shut(const Motion& live_link) {
  Frames shut;
  for (int row = 0; row < kFrames; ++row) {
    const double jaw = value(live_link, "arkit.jawOpen", row * kFrame);
    shut.push_back(jaw > 0.1 && value(live_link, "arkit.mouthClose", row * kFrame) >= jaw);
  }
  return shut;
}
Frames said_blinks(const Motion& live_link) {
  Frames down;
  for (int row = 0; row < kFrames; ++row)
    down.push_back(value(live_link, "arkit.eyeBlinkLeft", row * kFrame) >= 0.999);
  return down;
}

/// Frames at which one is true and the other is so in none of the three about it.
int errors(const Frames& said, const Frames& seen) {
  int wrong = 0;
  const auto near = [](const Frames& of, std::size_t at) {
    for (std::size_t i = at > 0 ? at - 1 : 0; i <= std::min(at + 1, of.size() - 1); ++i)
      if (of[i]) return true;
    return false;
  };
  for (std::size_t i = 0; i < said.size(); ++i)
    wrong += (said[i] && !near(seen, i)) || (seen[i] && !near(said, i));
  return wrong;
}

double gap(const Face& face, const std::string& upper, const std::string& lower) {
  return test::point_of(face, upper).y - test::point_of(face, lower).y;
}

/// The inner edges of both lips, within what a rounding of the time is.
bool lips_meet(const Face& face) {
  const auto upper = test::inner_edge_of(face, "upper"), lower = test::inner_edge_of(face, "lower");
  return std::equal(upper.begin(), upper.end(), lower.begin(), lower.end(),
                    [](double a, double b) { return std::abs(a - b) < 1e-9; });
}

/// The lids of all eyes, within what a rounding is.
bool lids_meet(const Face& face) {
  double apart = 0;
  for (const Eye& eye : face.model->eyes) {
    const Slice &upper = face.model->layout[eye.upper], &lower = face.model->layout[eye.lower];
    for (int i = 0; i < std::min(upper.size, lower.size); ++i)
      apart = std::max(apart, std::abs(face.vector[std::size_t(upper.begin + i)] -
                                       face.vector[std::size_t(lower.begin + i)]));
  }
  return apart < 1e-4;
}

TEST(Takes, ShutLipsAndLidsOfFacesWhenTheActorDoes) {
  const Motion live_link = read_take("live_link.csv");
  const Frames shut = said_shut(live_link), blinks = said_blinks(live_link);
  EXPECT_GE(std::count(shut.begin(), shut.end(), true), 3);
  EXPECT_GE(std::count(blinks.begin(), blinks.end(), true), 2);
  for (const Face& face : actors())
    for (const Take& take : takes()) {
      const BoundMotion bound = bind_motion(take.motion, face);
      Poser poser(face);
      Frames lips, lids;
      double widest = 0;
      for (int row = 0; row < kFrames; ++row) {
        const Face& posed = poser.pose(
            {.time = row * kFrame, .motions = {{.motion = bound.motion}}, .liveliness = 0});
        const double jaw = value(live_link, "arkit.jawOpen", row * kFrame);
        lips.push_back(jaw > 0.1 && lips_meet(posed));
        lids.push_back(lids_meet(posed));
        widest = std::max(widest, gap(posed, "upper_edge.left/spine/0", "lower_edge.left/spine/0"));
      }
      EXPECT_EQ(errors(shut, lips), 0) << face.model->name << " by " << take.name;
      EXPECT_EQ(errors(blinks, lids), 0) << face.model->name << " by " << take.name;
      EXPECT_GT(widest, 0.03) << face.model->name << " by " << take.name << ": between, it is open";
    }
}

TEST(Takes, TurnTheHeadAlikeInEveryDialectThatTellsIt) {
  double farthest = 0;
  const std::vector<Take> all = takes();
  for (const Take& take : all)
    for (int row = 0; row < kFrames && take.name != "ARKit"; ++row) {
      const double yaw = value(take.motion, "yaw", row * kFrame);
      ASSERT_NEAR(yaw, value(all[0].motion, "yaw", row * kFrame), 0.06) << take.name;
      farthest = std::max(farthest, yaw);
    }
  EXPECT_NEAR(farthest, 0.2 * 180 / M_PI, 0.1) << "to the subject's left";
}

}  // namespace
}  // namespace mien
