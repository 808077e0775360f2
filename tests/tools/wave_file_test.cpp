#include "tools/mien/film/wave_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/process/scratch_folder.h"

namespace mien::command {
namespace {

std::string number(std::uint32_t value, int bytes = 4) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += char(value >> 8 * i & 0xff);
  return text;
}

std::string wave(int rate, int samples, std::uint32_t promised) {
  const std::string format = number(1, 2) + number(1, 2) + number(std::uint32_t(rate)) +
                             number(std::uint32_t(2 * rate)) + number(2, 2) + number(16, 2);
  return "RIFF" + number(0) + "WAVE" + "fmt " + number(16) + format + "LIST" + number(3) + "abc" +
         '\0' + "data" + number(promised) + std::string(std::size_t(2 * samples), '\0');
}

TEST(WaveFile, SaysHowLongItIs) {
  const test::ScratchFolder folder;
  const std::string path = (folder / "a.wav").string();
  const auto seconds = [&](const std::string& bytes) {
    test::write_text(path, bytes);
    return wave_seconds(path);
  };
  const auto said = [&](const std::string& bytes) { return seconds(bytes).error().what; };
  EXPECT_EQ(**seconds(wave(22050, 22050, 44100)), 1);
  EXPECT_NEAR(**seconds(wave(11127, 5000, 10000)), 5000 / 11127.0, 1e-12) << "an odd rate";
  EXPECT_EQ(**seconds(wave(8000, 4000, 0xffffffff)), 0.5) << "a header that promises more";
  EXPECT_FALSE(seconds("OggS....")->has_value()) << "another kind";
  EXPECT_EQ(said(""), "is empty");
  EXPECT_EQ(said("RIFF1234"), "begins like a WAV and is none");
  EXPECT_EQ(said(wave(8000, 10, 20).substr(0, 40)), "a WAV without sound");
  EXPECT_EQ(said(wave(8000, 10, 20).substr(0, 25)), "its format is cut off");
  EXPECT_EQ(said(wave(0, 10, 20)), "a WAV without a format before its sound");
  EXPECT_EQ(wave_seconds(folder.path().string()).error().what, "is a directory");
  EXPECT_FALSE(wave_seconds("/no/such/file.wav"));
}

}  // namespace
}  // namespace mien::command
