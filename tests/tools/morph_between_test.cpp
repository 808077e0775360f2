// mien morph between: one person becoming another, as a sheet, pictures or a film.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::Ran;
using test::run_mien;
using test::ScratchFolder;

constexpr const char *kOne = "A66CB-AA5S0-14", *kOther = "ANCGD-0PRP4-79~6900~09ZZ";

class MorphBetween : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Ran ran(std::vector<std::string> more) const {
    more.insert(more.begin(), {"morph", "between", kOne, kOther, "--size", "32"});
    return run_mien(more);
  }
  auto drawn(std::vector<std::string> more) const {
    more.insert(more.end(), {"-o", file("a.png")});
    const Ran done = ran(more);
    EXPECT_EQ(done.code, 0) << done.err;
    return test::read(file("a.png"));
  }
  ScratchFolder folder_;
};

TEST_F(MorphBetween, ASheetBeginsWithTheOneAndEndsWithTheOther) {
  const auto sheet = drawn({"--steps", "6", "--columns", "3"});
  EXPECT_EQ(sheet.spec.width, 96);
  EXPECT_EQ(sheet.spec.height, 64);
  EXPECT_EQ(drawn({}).spec.width, 9 * 32);
  for (const auto& [at, person] : {std::pair{"0", kOne}, {"1", kOther}}) {
    const auto end = drawn({"--at", at});
    ASSERT_EQ(run_mien({"render", person, "--size", "32", "-o", file("b.png")}).code, 0);
    const auto alone = test::read(file("b.png"));
    EXPECT_TRUE(std::ranges::equal(end.channels, alone.channels)) << at;
  }
}

TEST_F(MorphBetween, PartsChangeWhereTheyAreTold) {
  const auto early = drawn({"--at", "0.5", "--parts-at", "0.1"});
  EXPECT_FALSE(
      std::ranges::equal(drawn({"--at", "0.5", "--parts-at", "0.9"}).channels, early.channels));
  EXPECT_TRUE(
      std::ranges::equal(drawn({"--at", "0.5", "--parts-at", "0.4"}).channels, early.channels));
}

TEST_F(MorphBetween, PicturesAreNumbered) {
  const Ran done = ran({"--steps", "3", "-o", file("%02d.png")});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(folder_.names().size(), 3u);
  EXPECT_EQ(test::read(file("02.png")).spec.width, 32);
}

TEST_F(MorphBetween, BadUseIsASentence) {
  const auto refused = [&](const std::vector<std::string>& more, int code,
                           const std::string& what) {
    const Ran done = ran(more);
    EXPECT_EQ(done.code, code) << done.err;
    EXPECT_NE(done.err.find(what), std::string::npos) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
  };
  const std::string out = file("x.png");
  refused({"--at", "2", "-o", out}, 2, "--at");
  refused({"--parts-at", "-1", "-o", out}, 2, "--parts-at");
  refused({"--at", "0.5", "--steps", "3", "-o", out}, 2, "--at");
  refused({"--at", "0.5", "-o", file("%d.png")}, 2, "is one picture");
  refused({"--steps", "1", "-o", out}, 2, "--steps");
  refused({"--fps", "30", "-o", out}, 2, "is of films");
  refused({"--style", "inkk", "-o", out}, 2, "did you mean \"ink\"");
  refused({"--step", "3", "-o", out}, 2, "did you mean \"--steps\"");
  const Ran unknown = run_mien({"morph", "between", kOne, "A66CB-AA5S0-13", "-o", out});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_NE(unknown.err.find("a sign is wrong"), std::string::npos) << unknown.err;
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace mien
