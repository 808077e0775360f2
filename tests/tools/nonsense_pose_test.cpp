#include "tools/mien/people/nonsense_pose.h"
#include <mien/composed_face.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

std::vector<std::string> words_of(const std::string& name) {
  std::istringstream text(name);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

TEST(NonsensePose, HasAllThatTheTestAsksFor) {
  const Face face = *face_from_recipe({});
  const std::vector<NonsensePose> poses = nonsense_poses(face);
  EXPECT_EQ(poses[0].name, "rest");
  std::set<std::string> names;
  for (const NonsensePose& pose : poses) names.insert(pose.name);
  EXPECT_EQ(names.size(), poses.size()) << "none twice";
  for (const char* name :
       {"emotion.joy=0.5", "emotion.anger=1 blink=0.5", "emotion.joy=1 emotion.fear=1 blink=1",
        "arkit.jawOpen=1", "viseme.aa=1 yaw=-30", "corner=-1", "corner=1 blink=1",
        "breath=0.03 yaw=30", "yaw=30 pitch=-25", "blink=1"})
    EXPECT_TRUE(names.contains(name)) << name;
  const auto with = [&](std::string_view begin) {
    return std::ranges::count_if(names, [&](const std::string& name) {
      return name.starts_with(begin) && name.find(' ') == std::string::npos;
    });
  };
  EXPECT_EQ(with("emotion."), 12);
  EXPECT_EQ(with("arkit."), 52);
  EXPECT_EQ(with("viseme."), 15);
}

TEST(NonsensePose, IsWhatItsNameSaysToTheCommand) {
  const Face face = *face_from_recipe({});
  const std::vector<NonsensePose> poses = nonsense_poses(face);
  for (std::size_t i = 1; i < poses.size(); i += 41)
    EXPECT_EQ(pose_face(face, poses[i].pose).vector,
              test::face_at(face, words_of(poses[i].name)).vector)
        << poses[i].name;
}

TEST(NonsensePose, LeavesOutWhatAFaceCannotDo) {
  const Face face = test::sample_face("seed0");
  for (const NonsensePose& pose : nonsense_poses(face))
    for (const std::string& word : words_of(pose.name))
      EXPECT_TRUE(word == "rest" || read_setting(face, word)) << pose.name;
}

}  // namespace
}  // namespace mien
