// mien set: face files with other numbers.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::Ran;
using test::run_mien;

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class SetTest : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  const std::string toon_ = test::face_path("toon");
  test::ScratchFolder folder_;
};

TEST_F(SetTest, WritesTheFileWithOtherNumbers) {
  const Ran ran = run_mien(
      {"set", toon_, "palette/skin=#102030", "mouth/spine/1/y=-0.5", "-o", file("a.face.json")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  const std::string before = text_of(toon_), after = text_of(file("a.face.json"));
  EXPECT_NE(after.find("#102030"), std::string::npos);
  EXPECT_LT(std::max(before.size(), after.size()) - std::min(before.size(), after.size()), 20u);
  const Ran listed = run_mien({"list", file("a.face.json")});
  EXPECT_NE(listed.out.find(",-0.5\n"), std::string::npos);
}

TEST_F(SetTest, WithNothingNewIsTheSameFile) {
  const Ran ran = run_mien({"set", toon_, "mouth/spine/1/y=-0.5", "-o", file("a.face.json")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const Ran again = run_mien({"set", file("a.face.json"), "mouth/spine/1/y=-0.5", "-o", "-"});
  EXPECT_EQ(again.out, text_of(file("a.face.json")));
}

// A file may take its own place; what is refused leaves it as it was.
TEST_F(SetTest, WritesAllOrNothing) {
  const std::string own = file("own.face.json");
  std::ofstream(own) << text_of(toon_);
  const Ran ran = run_mien({"set", own, "gaze.x=0.01", "palette/skin=#102030", "-o", own});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("own.face.json: cannot hold gaze.x: "), std::string::npos) << ran.err;
  EXPECT_EQ(text_of(own), text_of(toon_));
  EXPECT_EQ(run_mien({"set", own, "palette/skin=#102030", "-o", own}).code, 0);
  EXPECT_NE(text_of(own), text_of(toon_));
}

TEST_F(SetTest, RefusesInOneSentence) {
  const Ran unknown = run_mien({"set", toon_, "palette/skim=#102030", "-o", file("a")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("did you mean \"palette/skin\"?"), std::string::npos) << unknown.err;
  EXPECT_EQ(run_mien({"set", toon_, "-o", file("a")}).code, 2);
  EXPECT_EQ(run_mien({"set", toon_, "palette/skin=#102030"}).code, 2);
  EXPECT_NE(
      run_mien({"set", "AM9XB-0E85E-9Y", "a=1", "-o", file("a")}).err.find("a code is no file"),
      std::string::npos);
  EXPECT_EQ(run_mien({"set", "no.face.json", "a=1", "-o", file("a")}).code, 1);
}

}  // namespace
}  // namespace mien
