// The faces of faces/compat/ stay valid for ever and draw the same bytes. Other hashes mean that a picture
// of an old file has changed: that is a fault, unless the picture before was wrong.

#include <mien/mien.h>
#include "sdf/distance/instruction_sets.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>

#include "tests/support/effort.h"
#include "tests/support/faces.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_poses.h"

namespace mien {
namespace {

constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325u, kFnvPrime = 0x100000001b3u;

/// With fused multiply-adds and without: light may differ by one level.
struct Hashes {
  std::uint64_t fused, unfused;
};
const std::map<std::string, Hashes> kDrawn{{"seed0", {0xf64163737606b70e, 0xf64163737606b70e}},
                                           {"male", {0xdc1e3e03482b5525, 0xdc1e3e03482b5525}},
                                           {"toon", {0xa38951eeade1d253, 0xa38951eeade1d253}},
                                           {"bruno", {0x1caaeb5e34153019, 0x1caaeb5e34153019}},
                                           {"clay", {0xc1236ca34012f180, 0x120d6b301bf54353}}};

/// FNV-1a of the face's pixels in all of its sample poses.
std::uint64_t hash_of_pictures(const std::string& name) {
  const Face face = test::face_named(name);
  std::uint64_t hash = kFnvStart;
  for (const test::NamedPose& pose : test::sample_poses(face)) {
    const Image image =
        test::rendered(scene_from_face(pose_face(face, pose.pose)), {.width = 160, .height = 120});
    for (const std::byte byte : image.bytes)
      hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * kFnvPrime;
  }
  return hash;
}

TEST(CompatFaces, DrawTheSameBytesForEver) {
  if (test::kSanitized) GTEST_SKIP() << "the plain build has drawn them";
  for (const auto& set : batch::instruction_sets()) {
    SCOPED_TRACE(set.name);
    batch::use_instruction_set(set.id);
    for (const auto& [name, hashes] : kDrawn) {
      const std::uint64_t hash = hash_of_pictures(name);
      EXPECT_EQ(hash, set.fused ? hashes.fused : hashes.unfused)
          << name << " 0x" << std::hex << hash;
    }
  }
  batch::use_instruction_set(0);
}

}  // namespace
}  // namespace mien
