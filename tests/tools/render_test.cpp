// Faces to pictures, as people ask for them.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <mien/face_file.h>
#include <mien/face_model.h>

#include <nlohmann/json.hpp>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;

struct Picture {
  int width = 0, height = 0, channels = 0;
  OIIO::ImageSpec spec;
  std::vector<std::uint16_t> levels;

  std::uint16_t at(int x, int y, int c) const {
    return levels[std::size_t((y * width + x) * channels + c)];
  }
};

Picture read(const std::filesystem::path& path) {
  auto in = OIIO::ImageInput::open(path.string());
  if (!in) {
    ADD_FAILURE() << path << ": " << OIIO::geterror();
    return {};
  }
  Picture picture{in->spec().width, in->spec().height, in->spec().nchannels, in->spec(), {}};
  picture.levels.resize(std::size_t(picture.width) * std::size_t(picture.height) *
                        std::size_t(picture.channels));
  EXPECT_TRUE(
      in->read_image(0, 0, 0, picture.channels, OIIO::TypeDesc::UINT16, picture.levels.data()));
  return picture;
}

/// Renders to a file of that name, and expects no word.
Picture render(const ScratchFolder& folder, const std::string& name, const std::string& face,
               const std::vector<std::string>& options) {
  std::vector<std::string> words{"render", face_path(face), "-o", (folder / name).string()};
  words.insert(words.end(), options.begin(), options.end());
  const Ran ran = run_mien(words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out, "");
  return read(folder / name);
}

TEST(Render, EverySampleFaceInItsOwnAspect) {
  const ScratchFolder folder;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(MIEN_SOURCE_DIR) + "/faces")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".face.json")) continue;
    const Picture picture =
        render(folder, name + ".png", "faces/" + name.substr(0, name.find('.')), {"--size", "120"});
    const auto face = read_face(entry.path());
    ASSERT_TRUE(face) << name;
    const glm::dvec2 box = face->model->canvas.box.size(), sides{picture.width, picture.height};
    EXPECT_EQ(std::max(picture.width, picture.height), 120) << name;
    EXPECT_NEAR(sides.x / sides.y, box.x / box.y, 1.0 / 60) << name;
    EXPECT_NE(std::count(picture.levels.begin(), picture.levels.end(), picture.levels[0]),
              long(picture.levels.size()))
        << name << " is one colour";
  }
}

TEST(Render, TheDefaultSizeHasALongerSideOf1024) {
  const ScratchFolder folder;
  const Picture picture = render(folder, "a.png", "male", {});
  EXPECT_EQ(picture.width, 1024);
  EXPECT_EQ(picture.height, 1024);
}

TEST(Render, EveryFormatAndDepth) {
  const ScratchFolder folder;
  const struct {
    const char *name, *depth, *stored;
  } cases[] = {{"a.png", "8", "uint8"},     {"b.png", "16", "uint16"},   {"a.tif", "8", "uint8"},
               {"b.tif", "16", "uint16"},   {"c.tif", "float", "float"}, {"a.exr", "half", "half"},
               {"b.exr", "float", "float"}, {"a.jpg", "8", "uint8"}};
  for (const auto& c : cases) {
    const Picture picture =
        render(folder, c.name, "seed0", {"--size", "64x36", "--depth", c.depth});
    EXPECT_STREQ(picture.spec.format.c_str(), c.stored) << c.name;
    EXPECT_EQ(picture.channels, 3) << c.name;
  }
  EXPECT_STREQ(render(folder, "d.exr", "seed0", {"--size", "64x36"}).spec.format.c_str(), "half");
}

TEST(Render, TransparentHasAlphaAndNoJpeg) {
  const ScratchFolder folder;
  const Picture picture =
      render(folder, "a.png", "seed0", {"--size", "64x36", "--background", "transparent"});
  EXPECT_EQ(picture.channels, 4);
  const Ran ran = run_mien({"render", face_path("seed0"), "-o", (folder / "a.jpg").string(),
                            "--size", "64x36", "--background", "transparent"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err, "mien: " + (folder / "a.jpg").string() +
                         ": JPEG cannot hold transparency; give the picture an opaque background "
                         "or another format\n");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
}

TEST(Render, BackgroundBeyondTheCanvas) {
  const ScratchFolder folder;
  const Picture wide =
      render(folder, "a.png", "male", {"--size", "90x30", "--background", "ff8000"});
  EXPECT_EQ(wide.at(0, 15, 0), 65535);
  EXPECT_EQ(wide.at(0, 15, 1), 128 * 257);
  EXPECT_EQ(wide.at(0, 15, 2), 0);
}

TEST(Render, ARegionIsACutOfTheWhole) {
  const ScratchFolder folder;
  const Picture whole = render(folder, "a.png", "toon", {"--size", "160x90"});
  const Picture part =
      render(folder, "b.png", "toon", {"--size", "160x90", "--region", "37,21,64,40"});
  ASSERT_EQ(part.width, 64);
  ASSERT_EQ(part.height, 40);
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(part.at(x, y, c), whole.at(x + 37, y + 21, c)) << x << " " << y;
    }
  }
}

TEST(Render, ThreadsChangeNoByte) {
  const ScratchFolder folder;
  for (const char* threads : {"1", "2", "7"}) {
    render(folder, std::string(threads) + ".png", "toon", {"--size", "96", "--threads", threads});
  }
  EXPECT_TRUE(test::read_text(folder / "1.png") == test::read_text(folder / "2.png"));
  EXPECT_TRUE(test::read_text(folder / "1.png") == test::read_text(folder / "7.png"));
}

TEST(Render, PoseOptionsChangeThePictureAndSetBeatsTime) {
  const ScratchFolder folder;
  const auto bytes = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"--size", "96"};
    all.insert(all.end(), options.begin(), options.end());
    return render(folder, "a.png", "toon", all).levels;
  };
  const auto rest = bytes({});
  EXPECT_NE(bytes({"--set", "blink=1"}), rest);
  EXPECT_NE(bytes({"--set", "gaze.x=0.05", "--set", "dilation=1.4"}), rest);
  EXPECT_EQ(bytes({"--set", "blink=1", "--set", "blink=0"}), rest) << "the later one beats";
  EXPECT_EQ(bytes({"--time", "3", "--set", "blink=1", "--set", "gaze.x=0", "--set", "gaze.y=0",
                   "--set", "dilation=1"}),
            bytes({"--set", "blink=1"}));
}

TEST(Render, StandardOutputIsTheSamePng) {
  const ScratchFolder folder;
  const Ran ran =
      run_mien({"render", face_path("seed0"), "-o", "-", "--size", "80", "--stats=json"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(ran.out.substr(ran.out.size() - 8, 4), "IEND");
  EXPECT_EQ(nlohmann::json::parse(ran.err)["width"], 80) << "stats go to standard error then";
  render(folder, "a.png", "seed0", {"--size", "80"});
  EXPECT_TRUE(ran.out == test::read_text(folder / "a.png"));
}

TEST(Render, StatsAreJson) {
  const ScratchFolder folder;
  const Ran ran = run_mien({"render", face_path("seed0"), "-o", (folder / "a.png").string(),
                            "--size", "80x45", "--stats=json"});
  const auto stats = nlohmann::json::parse(ran.out);
  EXPECT_EQ(stats["width"], 80);
  EXPECT_EQ(stats["height"], 45);
  EXPECT_EQ(stats["pixels"], 80 * 45);
  for (const char* name :
       {"fill_pixels", "varied_pixels", "edge_pixels", "resolved_pixels", "pieces", "crossings",
        "regions", "doubts", "roots", "distances", "steps", "memory"}) {
    EXPECT_TRUE(stats[name].is_number_integer()) << name;
  }
  for (const char* name :
       {"read", "scene", "picture", "draw", "encode", "roots", "distances", "write"}) {
    EXPECT_GE(stats["seconds"][name].get<double>(), 0) << name;
  }
}

TEST(Render, StatsTellTheShareOfRootsAndDistances) {
  const ScratchFolder folder;
  const auto stats_of = [&](const char* face) {
    const Ran ran = run_mien({"render", face_path(face), "-o", (folder / "a.png").string(),
                              "--size", "96", "--threads", "1", "--stats=json"});
    return nlohmann::json::parse(ran.out);
  };
  const auto flat = stats_of("male"), lit = stats_of("clay");
  EXPECT_EQ(flat["distances"], 0);
  EXPECT_EQ(flat["seconds"]["distances"], 0);
  EXPECT_GT(lit["distances"].get<long long>(), 96 * 96 / 4) << "of 2 by 2 pixels at least";
  for (const auto& stats : {flat, lit}) {
    EXPECT_GT(stats["solving_share"].get<double>(), 0);
    EXPECT_LE(stats["solving_share"].get<double>(), 1);
  }
}

TEST(Render, TheRecipeIsInTheMetadata) {
  const ScratchFolder folder;
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg"}) {
    const Picture picture =
        render(folder, name, "seed0",
               {"--size", "64x36", "--time", "1.5", "--set", "blink=0.25", "--blend", "srgb"});
    const auto recipe =
        nlohmann::json::parse(picture.spec.get_string_attribute("ImageDescription"));
    EXPECT_EQ(recipe["face"], "seed0.face.json") << name;
    EXPECT_EQ(recipe["size"], "64x36");
    EXPECT_EQ(recipe["time"], "1.5");
    EXPECT_EQ(recipe["blend"], "srgb");
    EXPECT_EQ(recipe["set"], nlohmann::json::array({"blink=0.25"}));
    EXPECT_TRUE(recipe["mien"].is_string());
  }
}

TEST(Render, FollowsALinkAndClearsLeftovers) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("real.png", folder / "link.png");
  test::write_text(folder / ".mien-00112233aabbccdd.part", "of a killed run");
  render(folder, "link.png", "seed0", {"--size", "32"});
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"link.png", "real.png"}));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
}

TEST(Scene, IsPosedAndPrinted) {
  const Ran rest = run_mien({"scene", face_path("toon")}),
            closed = run_mien({"scene", face_path("toon"), "--set", "blink=1"});
  EXPECT_EQ(rest.code, 0);
  EXPECT_EQ(rest.out.find("canvas "), 0u);
  EXPECT_NE(rest.out, closed.out);
}

TEST(List, NamesWhatSetTakes) {
  const Ran ran = run_mien({"list", face_path("toon")});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out.find("NAME "), 0u);
  EXPECT_NE(ran.out.find("\nclip idle (runs with --time)"), std::string::npos);
  EXPECT_NE(ran.out.find("\npose brow.sad "), std::string::npos);
  // Every name in the first column is taken, at the value in the last.
  std::vector<std::string> words{"scene", face_path("toon")};
  std::size_t at = ran.out.find('\n') + 1;
  int names = 0;
  for (std::size_t end; (end = ran.out.find('\n', at)) != std::string::npos; at = end + 1) {
    const std::string line = ran.out.substr(at, end - at);
    if (line.starts_with("clip ") || line.starts_with("pose ")) continue;
    words.insert(words.end(), {"--set", line.substr(0, line.find(' ')) + "=" +
                                            line.substr(line.rfind(' ') + 1)});
    ++names;
  }
  EXPECT_GT(names, 20);
  const Ran set = run_mien(words);
  EXPECT_EQ(set.code, 0) << set.err;
}

}  // namespace
}  // namespace mien
