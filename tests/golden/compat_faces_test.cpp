// The faces of faces/compat/ stay valid for ever: posed, their numbers are those of compat_points.txt, and their pictures
// are within one level of the exact means in compat_means.txt. These are no bytes that were drawn: the exact truth made
// them, and makes them again when a face is to look better (tools/renew_expected). Points are never renewed.

#include <mien/face_code.h>
#include <mien/face_model.h>
#include <mien/mien.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "lib/base/mixed_bits.h"
#include "sdf/distance/instruction_sets.h"
#include "tests/support/exact/exact_compare.h"
#include "tests/support/faces/faces.h"
#include "tests/support/faces/sample_poses.h"
#include "tests/support/pictures/rendered.h"

namespace mien {
namespace {

constexpr const char* kCompatFaces[] = {"seed0", "male", "toon", "bruno", "clay"};
constexpr View kSmall{.width = 32, .height = 24, .dither = false};
constexpr int kTop = 65535;

std::string file_of(const char* name) {
  return std::string(MIEN_SOURCE_DIR "/tests/golden/") + name;
}

/// "toon rest": what stands after these words.
std::map<std::string, std::string> lines_of(const char* name) {
  std::map<std::string, std::string> lines;
  std::ifstream file(file_of(name));
  for (std::string face, pose, rest; file >> face >> pose && std::getline(file >> std::ws, rest);)
    lines[face + " " + pose] = rest;
  return lines;
}

/// The sum of a face's numbers, each weighed by its name: two such sums tell any two faces apart.
double weighed(const Face& face, std::uint64_t seed) {
  double sum = 0;
  for (const Slice& slice : face.model->layout.slices()) {
    const std::uint64_t name = seed_from_word(slice.name);
    for (int i = 0; i < slice.size; ++i) {
      const std::uint64_t bits = mixed_bits(mixed_bits(name ^ seed) + std::uint64_t(i));
      sum += (double(bits >> 11) * 0x1p-52 - 1) * face.vector[std::size_t(slice.begin + i)];
    }
  }
  return sum;
}

TEST(CompatFaces, PosedHaveTheSamePointsForEver) {
  constexpr double kRounding = 1e-9;  // what sines and orders of sums may be off
  const auto known = lines_of("compat_points.txt");
  std::size_t poses = 0;
  for (const char* name : kCompatFaces) {
    const Face face = test::face_named(name);
    for (const test::NamedPose& pose : test::sample_poses(face)) {
      const Face posed = pose_face(face, pose.pose);
      const double one = weighed(posed, 1), two = weighed(posed, 2);
      const auto line = known.find(fmt::format("{} {}", name, pose.name));
      double first = 0, second = 0;
      if (line != known.end()) std::istringstream(line->second) >> first >> second;
      EXPECT_TRUE(line != known.end() && std::abs(one - first) < kRounding &&
                  std::abs(two - second) < kRounding)
          << fmt::format("{} {} {} {}", name, pose.name, one, two);
      ++poses;
    }
  }
  EXPECT_EQ(poses, known.size());
}

/// The poses whose means are locked; others are judged by the exact truth alone.
Scene scene_of(const Face& face, const std::string& pose) {
  for (const test::NamedPose& one : test::sample_poses(face))
    if (one.name == pose) return scene_from_face(pose_face(face, one.pose));
  throw std::runtime_error("no pose " + pose);
}

/// Red, green and blue of every pixel, four hexadecimal digits each.
std::string exact_means(const Scene& scene) {
  const test::ExactTruth truth(scene, kSmall, test::ExactTruth::kLit);
  std::string means;
  for (int y = 0; y < kSmall.height; ++y)
    for (int x = 0; x < kSmall.width; ++x) {
      const glm::dvec4 levels = truth.levels(x, y, kTop);
      for (int i = 0; i < 3; ++i) means += fmt::format("{:04x}", int(std::lround(levels[i])));
    }
  return means;
}

/// The largest difference of a picture of 8 bits from means, in levels of 255.
double farthest(const Scene& scene, const std::string& means) {
  const Image image = test::rendered(scene, kSmall);
  EXPECT_EQ(means.size(), std::size_t(12 * kSmall.width * kSmall.height));
  double most = 0;
  for (int y = 0; y < kSmall.height; ++y)
    for (int x = 0; x < kSmall.width; ++x) {
      glm::dvec4 exact(255);
      for (int i = 0; i < 3; ++i)
        exact[i] = std::stoi(means.substr(std::size_t(4 * (3 * (y * kSmall.width + x) + i)), 4),
                             nullptr, 16) *
                   255.0 / kTop;
      most = std::max(most, test::apart(test::drawn_levels(image, x, y), exact, 255));
    }
  return most;
}

void renew_means() {
  std::string text;
  for (const auto& [of, means] : lines_of("compat_means.txt")) {
    const std::size_t space = of.find(' ');
    text += fmt::format(
        "{} {}\n", of,
        exact_means(scene_of(test::face_named(of.substr(0, space)), of.substr(space + 1))));
  }
  std::ofstream(file_of("compat_means.txt")) << text;
}

TEST(CompatFaces, AreDrawnWithinALevelOfTheirExactMeans) {
  if (std::getenv("MIEN_RENEW")) renew_means();
  const auto locked = lines_of("compat_means.txt");
  EXPECT_EQ(locked.size(), 14u);
  for (const auto& [of, means] : locked) {
    const std::size_t space = of.find(' ');
    const Scene scene = scene_of(test::face_named(of.substr(0, space)), of.substr(space + 1));
    for (const auto& set : batch::instruction_sets()) {
      batch::use_instruction_set(set.id);
      EXPECT_LE(farthest(scene, means), 1) << of << " by " << set.name;
    }
  }
  batch::use_instruction_set(0);
}

TEST(CompatFaces, DrawnOtherwiseAreSeenToBe) {
  const auto locked = lines_of("compat_means.txt");
  EXPECT_GT(farthest(scene_of(test::face_named("toon"), "rest"), locked.at("toon turn_left")), 20);
  EXPECT_GT(farthest(scene_of(test::face_named("clay"), "rest"), locked.at("clay unwrap_half")), 5);
}

}  // namespace
}  // namespace mien
