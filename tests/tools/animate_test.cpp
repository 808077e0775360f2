// mien animate and mien morph: frames are the same for any number of threads, finished ones
// are kept, films appear whole or not at all.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/end_process.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::read_text;
using test::run_mien;
using test::ScratchFolder;
using Words = std::vector<std::string>;

std::vector<std::string> animate(const ScratchFolder& folder, const std::string& output,
                                 std::vector<std::string> more = {}) {
  std::vector<std::string> words{
      "animate", face_path("seed0"), "--frames", "3-8", "--fps",
      "10",      "--size",           "64x36",    "-o",  (folder / output).string()};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Animate, FramesAreThoseOfRenderForAnyThreads) {
  const ScratchFolder one, many;
  ASSERT_EQ(run_mien(animate(one, "%03d.png", {"--threads", "1"})).out, "6 frames drawn, 0 kept\n");
  ASSERT_EQ(run_mien(animate(many, "%03d.png", {"--threads", "5"})).code, 0);
  EXPECT_EQ(one.names(), (std::vector<std::string>{"003.png", "004.png", "005.png", "006.png",
                                                   "007.png", "008.png"}));
  for (const std::string& name : one.names())
    EXPECT_EQ(read_text(one / name), read_text(many / name)) << name;
  EXPECT_NE(read_text(one / "003.png"), read_text(one / "004.png"));
  for (const int frame : {3, 8}) {
    const std::string drawn = (one / "render.png").string();
    ASSERT_EQ(run_mien({"render", face_path("seed0"), "--time", fmt::format("{}", frame / 10.0),
                        "--size", "64x36", "-o", drawn})
                  .code,
              0);
    EXPECT_EQ(test::read(drawn).channels,
              test::read(one / fmt::format("{:03}.png", frame)).channels)
        << frame;
  }
}

TEST(Animate, KeepsFinishedFramesAndRedoesBrokenAndStaleOnes) {
  const ScratchFolder folder;
  run_mien(animate(folder, "%d.png"));
  const std::string third = read_text(folder / "3.png"), fourth = read_text(folder / "4.png");
  EXPECT_EQ(run_mien(animate(folder, "%d.png")).out, "0 frames drawn, 6 kept\n");
  test::write_text(folder / "3.png", third.substr(0, third.size() - 20));  // cut off
  std::string flipped = fourth;
  flipped[fourth.size() / 2] = char(flipped[fourth.size() / 2] ^ 1);  // a bit changed
  test::write_text(folder / "4.png", flipped);
  test::write_text(folder / "5.png", fourth);  // whole, but another frame
  EXPECT_EQ(run_mien(animate(folder, "%d.png")).out, "3 frames drawn, 3 kept\n");
  EXPECT_EQ(read_text(folder / "3.png"), third);
  EXPECT_EQ(read_text(folder / "4.png"), fourth);
  EXPECT_EQ(run_mien(animate(folder, "%d.png", {"--again"})).out, "6 frames drawn, 0 kept\n");
  EXPECT_EQ(run_mien(animate(folder, "%d.png", {"--set", "dilation=1.1"})).out,
            "6 frames drawn, 0 kept\n");
}

// Resumable: what a killed run finished is kept, what it broke off is not there, its temporaries go.
TEST(Animate, GoesOnAfterBeingKilled) {
  const ScratchFolder folder, whole;
  const auto words = [](const ScratchFolder& to) {
    return Words{"animate", face_path("toon"), "--frames", "0-39",
                 "--size",  "512x288",         "-o",       (to / "%02d.png").string()};
  };
  test::Process process = test::start_mien(words(folder));
  while (folder.names().size() < 4) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  test::end_process(process.id(), SIGKILL);
  EXPECT_EQ(process.wait().signal, SIGKILL);
  const Ran again = run_mien(words(folder));
  EXPECT_EQ(again.code, 0) << again.err;
  int drawn = 0, kept = 0;
  ASSERT_EQ(std::sscanf(again.out.c_str(), "%d frames drawn, %d kept", &drawn, &kept), 2);
  EXPECT_EQ(drawn + kept, 40);
  EXPECT_GE(kept, 2);
  EXPECT_EQ(run_mien(words(whole)).code, 0);
  EXPECT_EQ(folder.names(), whole.names());
  for (const std::string& name : whole.names())
    EXPECT_EQ(read_text(folder / name), read_text(whole / name)) << name;
}

// Ctrl-C: pictures are whole or not there, a film is not there; nothing else is left.
TEST(Animate, InterruptedLeavesNothingHalfWritten) {
  for (const char* output : {"%02d.png", "a.apng", "a.webp", "a.gif", "a.mp4"}) {
    if (output == std::string("a.mp4") && !std::filesystem::exists("/usr/bin/ffmpeg")) continue;
    const ScratchFolder folder;
    const Words words{"animate", face_path("toon"), "--frames", "0-99999",
                      "--size",  "512x288",         "-o",       (folder / output).string()};
    test::Process process = test::start_mien(words);
    test::wait_until_handled(process.id(), SIGINT);
    while (folder.names().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    test::end_process(process.id(), SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.signal, SIGINT) << ran.out;
    EXPECT_EQ(ran.err, "mien: interrupted\n");
    for (const std::string& name : folder.names()) {
      EXPECT_TRUE(name.ends_with(".png") && name[0] != '.') << name;
      const std::string bytes = read_text(folder / name);
      EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND") << name;
    }
  }
}

TEST(Animate, WithoutFfmpegNamesThePackageAndLeavesNothing) {
  const ScratchFolder folder;
  std::vector<std::string> words{"/usr/bin/env", "PATH=" + folder.path().string(), MIEN_COMMAND};
  const auto more = animate(folder, "a.mp4");
  words.insert(words.end(), more.begin(), more.end());
  const Ran ran = test::Process(words).wait();
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("install the package ffmpeg"), std::string::npos) << ran.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(Animate, FilmsOfEveryKindAppearWhole) {
  if (!std::filesystem::exists("/usr/bin/ffmpeg")) GTEST_SKIP() << "no ffmpeg here";
  const ScratchFolder folder;
  const std::pair<const char*, std::string> kinds[] = {{"a.mp4", "ftyp"},
                                                       {"a.webm", "\x1A\x45\xDF\xA3"},
                                                       {"a.webp", "WEBPVP8X"},
                                                       {"a.apng", "acTL"},
                                                       {"a.gif", "GIF89a"}};
  for (const auto& [name, mark] : kinds) {
    const Ran ran = run_mien(animate(folder, name));
    EXPECT_EQ(ran.code, 0) << name << ran.err;
    EXPECT_NE(ran.out.find("6 frames in "), std::string::npos) << ran.out;
    EXPECT_LT(read_text(folder / name).find(mark), 128u) << name << " is of another kind";
  }
  EXPECT_EQ(folder.names().size(), 5u);  // no temporaries
  EXPECT_EQ(run_mien(animate(folder, "b.webm", {"--background", "transparent"})).code, 0);
}

TEST(Animate, WrongUseIsOneLineAndLeavesNothing) {
  const ScratchFolder folder;
  const std::pair<std::vector<std::string>, const char*> wrongs[] = {
      {animate(folder, "a.tif"), "expected numbered pictures like frames/%05d.png, or a film"},
      {animate(folder, "%d-%d.png"), "expected one place for the frame's number"},
      {animate(folder, "%s.png"), "expected one place for the frame's number"},
      {animate(folder, "%d.xyz"), "unknown extension .xyz"},
      {animate(folder, "a.mp4", {"--background", "transparent"}), "mp4 holds no transparency"},
      {animate(folder, "a.mp4", {"--size", "63x36"}), "--size may be given only once"},
      {animate(folder, "%d.png", {"--time", "1"}), "--time is for one picture"},
      {animate(folder, "%d.png", {"--effect", "mosaic:65"}), "needs as many pixels, not 64"},
      {animate(folder, "%d.png", {"--effect", "mosaic:0"}), "expected 1 to 65536 tiles across"}};
  for (const auto& [words, what] : wrongs) {
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 2) << what;
    EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

// Items G1, G2, G5: through the command.
TEST(Morph, MadeFromTwoFacesIsTheSecondAtOne) {
  const ScratchFolder folder;
  std::string other = read_text(face_path("seed0"));
  const std::size_t at = other.find("[0.26, 0.50]");
  ASSERT_NE(at, std::string::npos);
  other.replace(at, 12, "[0.21, 0.44]");
  test::write_text(folder / "low.face.json", other);
  ASSERT_EQ(run_mien({"morph", "make", face_path("seed0"), (folder / "low.face.json").string(),
                      "-o", (folder / "m.json").string()})
                .code,
            0);
  const auto scene = [&](const std::string& face, std::vector<std::string> more) {
    more.insert(more.begin(), {"scene", face});
    return run_mien(more).out;
  };
  const std::string morphs = (folder / "m.json").string(), rest = face_path("seed0");
  EXPECT_EQ(scene(rest, {"--morphs", morphs, "--morph", "low"}),
            scene((folder / "low.face.json").string(), {}));
  EXPECT_EQ(scene(rest, {"--morphs", morphs, "--morph", "low=0"}), scene(rest, {}));
  EXPECT_EQ(
      run_mien({"morph", "make", rest, face_path("male"), "-o", (folder / "x").string()}).code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "x"));
}

// Item P7: a face drawn through a basis of all its clip's directions is the face of the clip, with the
// light on its shut lids, whose relief follows the decoded shape.
TEST(Basis, DrawsAsTheClipDoes) {
  const ScratchFolder folder;
  const std::string basis = (folder / "b").string();
  ASSERT_EQ(run_mien({"pca", "fit", face_path("toon"), "--frames", "22-34", "--fps", "30",
                      "--max-error", "1e-9", "-o", basis})
                .code,
            0);
  const auto picture = [&](std::vector<std::string> more) {
    const std::string out = (folder / "a.png").string();
    more.insert(more.begin(), {"render", face_path("toon"), "--size", "160", "-o", out, "--time",
                               "0.93333333333333", "--region", "0,0,160,90"});
    EXPECT_EQ(run_mien(more).code, 0);
    return test::read(out).channels;
  };
  // The basis has the shape to 1e-9: a value between two levels may fall to either side.
  const auto apart = [](const std::vector<float>& a, const std::vector<float>& b) {
    EXPECT_EQ(a.size(), b.size());
    double most = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      most = std::max(most, 255.0 * std::abs(double(a[i]) - double(b[i])));
    return most;
  };
  EXPECT_LT(apart(picture({"--basis", basis}), picture({})), 1.01);
  const std::vector<std::string> lamp{"--light", "0.8,0.3,0.5"};
  EXPECT_LT(apart(picture({"--basis", basis, lamp[0], lamp[1]}), picture(lamp)), 1.01);
  EXPECT_GT(apart(picture(lamp), picture({})), 2.0);
  EXPECT_GT(apart(picture({"--basis", basis, "--weights", "0.4"}), picture({})), 2.0);
  EXPECT_EQ(
      run_mien({"render", face_path("seed0"), "--basis", basis, "-o", (folder / "c.png").string()})
          .code,
      1);
  EXPECT_FALSE(std::filesystem::exists(folder / "c.png"));
}

}  // namespace
}  // namespace mien
