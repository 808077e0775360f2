// Takes and speech on the command line: frames follow them, films have sound, and what is wrong is said.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::run_mien;
using test::ScratchFolder;
using test::write_text;

const char* const kTake = "time,jawOpen,eyeBlinkLeft,tongueOut\n0,0,0,0\n0.5,1,1,0\n1,1.5,0,0\n";
const char* const kTrack = "0\tsil\n0.2\tm\n0.4\tɑː\n0.8\t\n";

/// A tone of 440 Hz, 16 bits.
std::string tone(int rate, double seconds) {
  const auto number = [](std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += char(value >> 8 * i & 0xff);
    return text;
  };
  std::string samples;
  for (int i = 0; i < int(seconds * rate); ++i)
    samples += number(
        std::uint32_t(int(8000 * std::sin(2 * std::numbers::pi * 440 * i / rate))) & 0xffff, 2);
  const auto size = std::uint32_t(samples.size());
  return "RIFF" + number(36 + size, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) + number(1, 2) +
         number(std::uint32_t(rate), 4) + number(std::uint32_t(2 * rate), 4) + number(2, 2) +
         number(16, 2) + "data" + number(size, 4) + samples;
}

/// What ffprobe says of a stream of a film.
std::string probed(const std::string& film, const std::string& stream, const std::string& what) {
  const std::string call = fmt::format(
      "ffprobe -v error -select_streams {} -count_packets -show_entries stream={} -of csv=p=0 {}",
      stream, what, film);
  std::array<char, 256> said{};
  std::FILE* const pipe = ::popen(call.c_str(), "r");
  const std::size_t got = std::fread(said.data(), 1, said.size() - 1, pipe);
  ::pclose(pipe);
  return std::string(said.data(), got);
}

TEST(MotionCommand, DrawsTheFramesOfATake) {
  const ScratchFolder folder;
  write_text(folder / "take.csv", kTake);
  const std::string take = (folder / "take.csv").string(), frames = (folder / "%d.png").string();
  const auto ran = run_mien({"animate", face_path("bruno"), "--motion", take, "--fps", "4",
                             "--size", "64", "-o", frames});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "4 frames drawn, 0 kept\n") << "as long as the take";
  EXPECT_NE(ran.err.find("1 of 9 values lay out of range and were clamped"), std::string::npos)
      << ran.err;
  const std::string still = (folder / "still.png").string();
  ASSERT_EQ(run_mien({"render", face_path("bruno"), "--set", "arkit.jawOpen=1", "--set",
                      "arkit.eyeBlinkLeft=1", "--size", "64", "-o", still})
                .code,
            0);
  EXPECT_EQ(test::read(still).channels, test::read(folder / "2.png").channels);
  EXPECT_NE(test::read(still).channels, test::read(folder / "0.png").channels);
}

TEST(MotionCommand, TakesATakeForAFrameToo) {
  const ScratchFolder folder;
  write_text(folder / "take.csv", kTake);
  const std::string take = (folder / "take.csv").string(), one = (folder / "1.png").string(),
                    other = (folder / "2.png").string();
  ASSERT_EQ(run_mien({"render", face_path("bruno"), "--arkit", take, "--time", "0.5", "--size",
                      "48", "-o", one})
                .code,
            0);
  ASSERT_EQ(run_mien({"render", face_path("bruno"), "--motion", take, "--time", "0.5", "--size",
                      "48", "-o", other})
                .code,
            0);
  EXPECT_EQ(test::read(one).channels, test::read(other).channels);
}

TEST(MotionCommand, TellsOnceWhatAFaceDoesNotFollow) {
  const ScratchFolder folder;
  write_text(folder / "take.csv", kTake);
  const auto ran =
      run_mien({"animate", face_path("seed0"), "--motion", (folder / "take.csv").string(), "--fps",
                "4", "--size", "32", "-o", (folder / "%d.png").string()});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string said = "this face does not follow arkit.jawOpen, arkit.eyeBlinkLeft";
  const std::size_t first = ran.err.find(said);
  ASSERT_NE(first, std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find(said, first + 1), std::string::npos) << ran.err;
}

TEST(MotionCommand, MakesFilmsWhoseSoundEndsWithThePictures) {
  if (!std::filesystem::exists("/usr/bin/ffmpeg")) GTEST_SKIP() << "no ffmpeg here";
  const ScratchFolder folder;
  write_text(folder / "track.tsv", kTrack);
  const std::string track = (folder / "track.tsv").string();
  // Shorter than the track, longer, and of an odd rate.
  for (const auto& [seconds, rate] : {std::pair{0.5, 22050}, {2.0, 44100}, {1.25, 11127}}) {
    write_text(folder / "voice.wav", tone(rate, seconds));
    const std::string film = (folder / "talk.mp4").string();
    const auto ran = run_mien({"animate", face_path("bruno"), "--speech", track, "--sound",
                               (folder / "voice.wav").string(), "--size", "64", "-o", film});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const double pictures = std::stod(probed(film, "v:0", "duration")),
                 sound = std::stod(probed(film, "a:0", "duration"));
    EXPECT_NEAR(pictures, sound, 1 / 30.0) << seconds;
    EXPECT_GE(pictures, std::max(seconds, 0.8) - 1e-6);
    EXPECT_EQ(std::lround(pictures * 30), std::stol(probed(film, "v:0", "nb_read_packets")));
  }
}

TEST(MotionCommand, TagsTheColoursOfFilms) {
  if (!std::filesystem::exists("/usr/bin/ffmpeg")) GTEST_SKIP() << "no ffmpeg here";
  const ScratchFolder folder;
  for (const char* name : {"a.mp4", "a.webm"}) {
    const std::string film = (folder / name).string();
    ASSERT_EQ(
        run_mien({"animate", face_path("bruno"), "--frames", "0-1", "--size", "64", "-o", film})
            .code,
        0);
    EXPECT_EQ(probed(film, "v:0", "color_range,color_space,color_transfer,color_primaries"),
              "tv,bt709,bt709,bt709\n")
        << name;
  }
}

TEST(MotionCommand, SaysWhatIsWrong) {
  const ScratchFolder folder;
  write_text(folder / "take.csv", "time,jawOpen\n0,0\n1,nan\n");
  write_text(folder / "track.tsv", kTrack);
  write_text(folder / "broken.wav", "RIFF1234");
  const std::string take = (folder / "take.csv").string(), track = (folder / "track.tsv").string();
  const auto said = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"animate", face_path("bruno"), "--size", "32"});
    const auto ran = run_mien(words);
    EXPECT_NE(ran.code, 0);
    return ran.err;
  };
  const auto holds = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string gif = (folder / "a.gif").string(), png = (folder / "%d.png").string(),
                    mp4 = (folder / "a.mp4").string();
  EXPECT_TRUE(holds(said({"--motion", take, "-o", png}),
                    "take.csv:3:3: expected a finite number for \"jawOpen\", got \"nan\""));
  EXPECT_TRUE(
      holds(said({"--speech", track, "--sound", (folder / "broken.wav").string(), "-o", mp4}),
            "begins like a WAV and is none"));
  EXPECT_TRUE(holds(said({"--speech", track, "--sound", take, "-o", png}),
                    "numbered pictures hold no sound"));
  EXPECT_TRUE(holds(said({"--speech", track, "--sound", take, "-o", gif}),
                    "holds no sound: take .mp4 or .webm"));
  EXPECT_TRUE(holds(said({"-o", png}), "--frames is needed"));
  const auto still =
      run_mien({"render", face_path("bruno"), "--motion", take, "-o", (folder / "a.png").string()});
  EXPECT_TRUE(holds(still.err, "a motion runs at a moment: say --time")) << still.err;
}

}  // namespace
}  // namespace mien
