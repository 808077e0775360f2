// FreeType's distance fields are asked what they can answer, and counted in their own steps.

#include "tools/accuracy/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace mien::accuracy {
namespace {

class Fields : public testing::Test {
 protected:
  void SetUp() override {
    try {
      field_ = std::make_unique<FreetypeField>();
    } catch (const std::runtime_error& problem) {
      GTEST_SKIP() << problem.what();
    }
  }
  FieldTally judged(const std::string& family, FieldSetting setting) {
    const auto all = field_families();
    const auto found = std::ranges::find(all, family, &Family::name);
    return judge_field(*field_, setting, *found, 30, 5);
  }
  std::unique_ptr<FreetypeField> field_;
};

TEST_F(Fields, AnswerInTheMiddleOfAStep) {
  const FieldSetting setting{32, 8};
  const QuadBezier line{{0, 0}, {0.5, 0}, {1, 0}};
  for (const double up : {-0.1, 0.03, 0.2}) {  // both sides alike: there and back has no inside
    const auto found = field_->distance({line, {0.5, up}}, setting);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 32 * std::abs(up), 0.75 * setting.step()) << up;
    const double steps = *found / setting.step();
    EXPECT_EQ(steps - std::floor(steps), 0.5);
  }
  const CubicBezier arch{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const auto found = field_->distance({arch, {0.5, 0.85}}, setting);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 32 * 0.1, 2 * setting.step());
}

TEST_F(Fields, SayNothingBeyondTheirReach) {
  const QuadBezier line{{0, 0}, {0.5, 0}, {1, 0}};
  EXPECT_FALSE(field_->distance({line, {0.5, 0.26}}, {32, 8}));
  EXPECT_FALSE(field_->distance({line, {0.5, 1e6}}, {32, 8}));
  EXPECT_FALSE(FreetypeField::can_draw({QuadBezier{{1, 1}, {1, 1}, {1, 1}}, {0, 0}}));
  EXPECT_FALSE(FreetypeField::can_draw({Ellipse{{0, 0}, {1, 1}}, {0, 0}}));
}

TEST_F(Fields, AreJudgedInTheirSteps) {
  const FieldTally near = judged("near curve", {32, 8});
  EXPECT_EQ(near.cases, 30u);
  EXPECT_GT(near.within, 25u);
  EXPECT_EQ(near.silent, 0u);
  EXPECT_GE(near.worst, 0.45);
  EXPECT_LT(near.worst, 2);
  EXPECT_LT(near.mean, near.worst);
  EXPECT_EQ(judged("far", {32, 8}).within, 0u);
  EXPECT_EQ(judged("all equal", {32, 8}).within, 0u);
  const FieldTally cubic = judged("cubic, rim", {128, 2});
  EXPECT_EQ(cubic.within, 30u);
  EXPECT_LT(cubic.worst, 10);
}

TEST_F(Fields, AreATableAndNumbers) {
  const FieldTally tally = judged("cubic, tie", {32, 8});
  EXPECT_NE(field_table({tally}).find("cubic, tie"), std::string::npos);
  const std::string rows = field_csv({tally});
  EXPECT_EQ(
      rows.find("family,size,spread,cases,within,silent,worst,mean,ns\n\"cubic, tie\",32,8,30,"),
      0u);
}

}  // namespace
}  // namespace mien::accuracy
