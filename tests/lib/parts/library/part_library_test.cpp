#include "lib/parts/library/part_library.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

using test::SmallLibrary;
using test::with;

TEST(PartLibrary, ReadsFamiliesPartsAndNumbers) {
  const auto library = SmallLibrary{}.read();
  ASSERT_TRUE(library) << library.error().where << library.error().what;
  const Family* nose = (*library)->find_family("nose");
  ASSERT_TRUE(nose);
  EXPECT_TRUE(nose->optional);
  ASSERT_EQ(nose->parts.size(), 2u);
  EXPECT_EQ(nose->find("long")->number, 2);
  EXPECT_FALSE(nose->find("hook"));
  const LibraryNumber* length = (*library)->find_number("nose.length");
  ASSERT_TRUE(length);
  EXPECT_EQ(length->rest, 0.5);
  EXPECT_EQ((*library)->styles(), (std::vector<std::string>{"soft", "ink"}));
}

std::string refusal(const SmallLibrary& library) {
  const auto read = library.read();
  return read ? "read" : read.error().where + ": " + read.error().what;
}

TEST(PartLibrary, SaysWhatIsWrongAndWhere) {
  const SmallLibrary good;
  SmallLibrary bad = good;
  bad.noses = with(good.noses, "\"family\": \"nose\"", "\"family\": \"nsoe\"");
  EXPECT_NE(refusal(bad).find("did you mean \"nose\""), std::string::npos) << refusal(bad);
  EXPECT_NE(refusal(bad).find("noses.json:2:16: /parts/0/family"), std::string::npos)
      << refusal(bad);
  bad = good, bad.noses = with(good.noses, "\"number\": 2", "\"number\": 1");
  EXPECT_NE(refusal(bad).find("permanent number"), std::string::npos) << refusal(bad);
  bad = good, bad.noses = with(good.noses, "\"number\": 20", "\"number\": 10");
  EXPECT_NE(refusal(bad).find("permanent number"), std::string::npos) << refusal(bad);
  bad = good, bad.noses = with(good.noses, "\"number\": 2,", "\"number\": 1024,");
  EXPECT_NE(refusal(bad).find("0 to 1023"), std::string::npos) << refusal(bad);
  bad = good, bad.topology = with(good.topology, "\"rest\": 1,", "\"rest\": 3,");
  EXPECT_NE(refusal(bad).find("within its range"), std::string::npos) << refusal(bad);
  bad = good, bad.topology = with(good.topology, "mien-topology", "mien-part");
  EXPECT_NE(refusal(bad), "read");
}

TEST(PartLibrary, WhatStandsForAPartWithAnExpressionIsThereAndShowsNone) {
  const SmallLibrary good;
  const auto neutral = [&](const std::string& name) {
    SmallLibrary library = good;
    library.noses =
        with(good.noses, "\"number\": 2,", "\"number\": 2, \"neutral\": \"" + name + "\",");
    return refusal(library);
  };
  EXPECT_EQ(neutral("snub"), "read");
  EXPECT_NE(neutral("snubb").find("did you mean \"snub\""), std::string::npos) << neutral("snubb");
  EXPECT_NE(neutral("long"), "read") << "it would stand for itself";
}

TEST(PartLibrary, ReadsArchetypesOrSaysWhatIsWrongWithThem) {
  const auto archetypes = [](const std::string& text) {
    SmallLibrary small;
    small.topology =
        with(small.topology, "\"skin_tones\"", "\"archetypes\": {" + text + "}, \"skin_tones\"");
    return small;
  };
  const std::string wide =
      R"("wide": {"number": 1, "tickets": {"any": 8}, "numbers": {"size": 1.5}})";
  const auto library = archetypes(wide).read();
  ASSERT_TRUE(library) << sentence(library.error());
  ASSERT_EQ((*library)->archetypes().size(), 1u);
  EXPECT_TRUE((*library)->archetypes()[0].drawn);
  EXPECT_EQ((*library)->archetypes()[0].offsets, (std::vector<double>{0, 0.5, 0, 0}));
  for (const auto& [from, to, said] : std::vector<std::array<std::string, 3>>{
           {"\"size\": 1.5", "\"sise\": 1.5", "did you mean \"size\""},
           {"\"size\": 1.5", "\"size\": 2.5", "size goes from 0 to 2"},
           {"\"tickets\"", "\"tokens\"", "tickets"},
           {"\"number\": 1", "\"number\": 1.5", "permanent number"},
           {"{\"any\": 8}", "8", "object"}}) {
    const std::string wrong = refusal(archetypes(with(wide, from, to)));
    EXPECT_NE(wrong.find(said), std::string::npos) << wrong;
  }
  const std::string twice = refusal(archetypes(wide + ", " + with(wide, "wide", "broad")));
  EXPECT_NE(twice.find("\"wide\" has the same permanent number"), std::string::npos) << twice;
}

TEST(PartLibrary, HasOneTopology) {
  const SmallLibrary small;
  const auto two =
      PartLibrary::read({{"topology.json", small.topology}, {"more.json", small.topology}});
  ASSERT_FALSE(two);
  EXPECT_NE(two.error().what.find("one topology"), std::string::npos);
}

/// Which nose a recipe takes that names none.
std::string usual_nose(const SmallLibrary& library) {
  const auto read = library.read();
  return read ? (*read)->find_family("nose")->usual : sentence(read.error());
}

TEST(PartLibrary, TheUsualPartDoesNotDependOnTheOrderOfFiles) {
  const SmallLibrary good;
  EXPECT_EQ(usual_nose(good), "snub");
  SmallLibrary other = good;
  other.noses =
      with(with(good.noses, "\"number\": 1", "\"number\": 3"), "\"number\": 2,", "\"number\": 1,");
  EXPECT_EQ(usual_nose(other), "long");
  other = good;
  other.topology =
      with(good.topology, "\"optional\": true", "\"optional\": true, \"usual\": \"long\"");
  EXPECT_EQ(usual_nose(other), "long");
  other.topology = with(other.topology, "\"usual\": \"long\"", "\"usual\": \"lung\"");
  EXPECT_NE(usual_nose(other).find("did you mean \"long\""), std::string::npos)
      << usual_nose(other);
}

TEST(PartLibrary, TheShippedOneIsWhole) {
  const PartLibrary& library = PartLibrary::shipped();
  EXPECT_GE(library.families().size(), 20u);
  for (const Family& family : library.families())
    EXPECT_TRUE(family.optional || !family.parts.empty()) << family.name;
  for (const auto& [family, plain] : {std::pair{"head", "oval"},
                                      {"brows", "soft"},
                                      {"hair", "crop"},
                                      {"headwear", "none"},
                                      {"clothes", "crew"}})
    EXPECT_EQ(library.find_family(family)->usual, plain);
}

}  // namespace
}  // namespace mien
