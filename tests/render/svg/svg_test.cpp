#include <mien/svg.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/pictures/svg_tree.h"

namespace mien {
namespace {

using test::read_svg_tree;
using test::SvgElement;

Scene two_layers() {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  const Area square = build.shape(Path{{{{{{-0.5, -0.5}, {0, -0.5}, {0.5, -0.5}},
                                          {{0.5, -0.5}, {0.5, 0}, {0.5, 0.5}},
                                          {{0.5, 0.5}, {0, 0.5}, {-0.5, 0.5}},
                                          {{-0.5, 0.5}, {-0.5, 0}, {-0.5, -0.5}}}}}});
  build.layer("square", square, {{1, 0, 0, 1}});
  build.layer("cut", build.subtract(square, build.shape(HalfPlane{{1, 0}, 0})), {{0, 0, 0, 0.5}});
  return std::move(build).finish();
}

/// Ids without a prefix, unless the options have one.
std::string text_of(const Scene& scene, SvgOptions options = {}) {
  if (!options.id_prefix) options.id_prefix = "";
  const auto svg = svg_text(scene, options);
  EXPECT_TRUE(svg) << sentence(svg.error());
  return svg ? svg->text : std::string();
}

const SvgElement& only(const SvgElement& in, const std::string& tag) {
  static const SvgElement kNone;
  const SvgElement* found = nullptr;
  for (const SvgElement& child : in.children)
    if (child.tag == tag) {
      EXPECT_FALSE(found) << "two of " << tag;
      found = &child;
    }
  EXPECT_TRUE(found) << "no " << tag;
  return found ? *found : kNone;
}

TEST(Svg, IsAsShortAsThis) {
  EXPECT_EQ(text_of(two_layers(), {.width = 100, .height = 100}),
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\" "
            "viewBox=\"0 0 100 100\" fill-rule=\"evenodd\" clip-rule=\"evenodd\">\n"
            "<rect x=\"-1\" y=\"-1\" width=\"102\" height=\"102\" fill=\"#ffffff\"/>\n"
            "<path id=\"square\" fill=\"#ff0000\" d=\"M25 25l0 50 50 0 0-50z\"/>\n"
            "<path id=\"cut\" fill=\"#000000\" fill-opacity=\".5\" d=\"M75 75l0-50-25 0 0 50z\"/>\n"
            "</svg>\n");
}

TEST(Svg, AnEmptySceneIsABackground) {
  const Scene scene = SceneBuilder({}, {0, 0, 0, 1}).finish();
  EXPECT_EQ(read_svg_tree(text_of(scene)).children.size(), 1u);
  EXPECT_EQ(read_svg_tree(text_of(scene, {.background = Color{0, 0, 0, 0}})).children.size(), 0u);
  EXPECT_EQ(read_svg_tree(text_of(Scene{})).children.size(), 1u);
}

TEST(Svg, SizesOutOfRangeAreRefused) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double side : {nan, inf, -inf, 0.0, -3.0, 2e6}) {
    EXPECT_FALSE(svg_text({}, {.width = side}));
    const auto refused = svg_text({}, {.height = side});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().what.substr(0, 64),
              "a picture's sides are above 0 and at most 1048576 pixels, not 51");
  }
  for (const double tolerance : {nan, inf, 0.0, -1.0, 1e-5, 2.0})
    EXPECT_FALSE(svg_text({}, {.tolerance = tolerance}));
  EXPECT_TRUE(svg_text({}, {.width = 0.5, .height = 1 << 20}));
}

TEST(Svg, NamesAreEscapedAndIdsUnique) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 0});
  const Area disc = build.shape(Disc{{0, 0}, 0.5});
  const std::string odd = "<a&b> \"'\x01\xff\xc3\xa9";
  build.open_group(odd, 0.5);
  for (const char* name : {"eye", "eye", "eye-2", "<&>\"", ""})
    build.layer(name, disc, {{1, 0, 0, 1}});
  build.layer(odd, disc, {{1, 0, 0, 1}});
  build.close_group();
  const SvgElement root = read_svg_tree(text_of(
      std::move(build).finish(), {.title = "<t>", .recipe = "{\"a\": 1} & \r", .id_prefix = "p<"}));
  EXPECT_EQ(only(root, "title").text, "<t>");
  EXPECT_EQ(only(root, "metadata").text, "{\"a\": 1} & \xEF\xBF\xBD");
  const SvgElement& group = only(root, "g");
  EXPECT_EQ(group.get("data-name"), "<a&b> \"'\xEF\xBF\xBD\xEF\xBF\xBD\xc3\xa9");
  std::vector<std::string> ids;
  for (const SvgElement& path : group.children) ids.push_back(path.get("id"));
  EXPECT_EQ(ids, (std::vector<std::string>{"p_eye", "p_eye-2", "p_eye-2-2", "p_____", "p_",
                                           "p__a_b________-2"}));
  EXPECT_EQ(group.children[0].get("data-name", "none"), "none");
}

/// So pictures can stand in one page: others have other ids, the same have the same.
TEST(Svg, IdsAreOfThePicture) {
  const auto ids = [](const SvgOptions& options, double radius) {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 0});
    build.layer("eye", build.shape(Disc{{0, 0}, radius}), {{1, 0, 0, 1}});
    const auto svg = svg_text(std::move(build).finish(), options);
    EXPECT_TRUE(svg);
    return svg ? only(read_svg_tree(svg->text), "path").get("id") : std::string();
  };
  const std::string id = ids({}, 0.5);
  EXPECT_TRUE(id.starts_with("m") && id.ends_with("-eye")) << id;
  EXPECT_EQ(ids({}, 0.5), id);
  EXPECT_NE(ids({}, 0.6), id);
  EXPECT_NE(ids({.width = 300}, 0.5), id);
  EXPECT_EQ(ids({.id_prefix = "a-"}, 0.5), "a-eye");
  EXPECT_EQ(ids({.id_prefix = ""}, 0.5), "eye");
}

TEST(Svg, WhatSeveralLayersAreClippedByIsAClipPath) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 0});
  const Area opening = build.shape(Disc{{0, 0}, 0.5}), all = build.everywhere();
  const Area iris = build.shape(Disc{{0.2, 0}, 0.4}), far = build.shape(Disc{{0.9, 0.9}, 0.2});
  build.layer("iris", build.intersect(iris, opening), {{1, 0, 0, 1}});
  build.layer("glint", build.intersect(far, opening), {{1, 0, 0, 1}});
  build.layer("one", build.intersect(iris, all), {{1, 0, 0, 1}});
  build.layer("two", build.intersect(far, all), {{1, 0, 0, 1}});
  build.layer("alone", build.intersect(iris, far), {{1, 0, 0, 1}});
  const SvgElement root = read_svg_tree(text_of(std::move(build).finish()));
  EXPECT_EQ(only(root, "defs").children.size(), 1u) << "a clip that is everywhere is none";
  EXPECT_EQ(only(only(root, "defs"), "clipPath").get("id"), "iris.clip");
  std::map<std::string, std::string> clips;
  for (const SvgElement& child : root.children)
    if (child.tag == "path") clips[child.get("id")] = child.get("clip-path");
  EXPECT_EQ(
      clips,
      (std::map<std::string, std::string>{
          {"iris", "url(#iris.clip)"}, {"glint", "url(#iris.clip)"}, {"one", ""}, {"two", ""}}))
      << "what is empty is not there";
}

TEST(Svg, WhatIsLeftOutIsSaid) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 0});
  const Area disc = build.shape(Disc{{0, 0}, 0.5});
  Relief relief{.area = disc, .profile = Profile::bevel, .width = 0.1, .height = 0.1};
  build.layer("raised", disc, {.color = {1, 0, 0, 1}, .relief = shared(relief)});
  relief.height = 0;
  build.layer("level", disc, {.color = {1, 0, 0, 1}, .relief = shared(relief)});
  relief.domes.push_back({{0, 0}, {0.1, 0.1}, {1, 0}, 0.2});
  build.layer("domed", disc, {.color = {1, 0, 0, 1}, .relief = shared(relief)});
  const auto svg = svg_text(std::move(build).finish());
  ASSERT_TRUE(svg);
  EXPECT_EQ(svg->simplified,
            (std::vector<std::string>{
                "layer \"raised\": its relief is left out, for SVG knows no such light",
                "layer \"domed\": its relief is left out, for SVG knows no such light"}));
}

TEST(Svg, GroupsThatMixAreIsolated) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 0});
  const Area disc = build.shape(Disc{{0, 0}, 0.5});
  build.open_group("outer", 1);
  build.open_group("inner", 0.25, {}, MixMode::multiply);
  build.layer("disc", disc, {{1, 0, 0, 1}});
  build.close_group();
  build.close_group();
  const SvgElement root = read_svg_tree(text_of(std::move(build).finish()));
  EXPECT_EQ(root.get("style"), "isolation:isolate");
  EXPECT_EQ(only(root, "g").get("style"), "isolation:isolate");
  EXPECT_EQ(only(only(root, "g"), "g").get("style"), "mix-blend-mode:multiply");
  EXPECT_EQ(only(only(root, "g"), "g").get("opacity"), ".25");
}

}  // namespace
}  // namespace mien
