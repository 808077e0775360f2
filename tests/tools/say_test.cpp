// mien say: text becomes a track, a sound and a film; lips close when the sound does.

#include <mien/motion.h>
#include <mien/motion_file.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "lib/rig/pose/curve.h"
#include "lib/rig/speech/coarticulation.h"
#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/read_film.h"
#include "tests/support/process/run_command.h"
#include "tools/mien/film/wave_file.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::read_text;
using test::ScratchFolder;
using Words = std::vector<std::string>;

#ifdef MIEN_SAY_FOLDER
constexpr const char* kSayFolder = MIEN_SAY_FOLDER;
#else
constexpr const char* kSayFolder = nullptr;
#endif

#define NEEDS_MIEN_SAY() \
  if (!kSayFolder) GTEST_SKIP() << "no mien-say here: install the package libespeak-ng-dev"

Ran say(const Words& words, const std::string& path = std::string(kSayFolder) + ":/usr/bin") {
  Words all{"/usr/bin/env", "PATH=" + path, MIEN_COMMAND, "say"};
  all.insert(all.end(), words.begin(), words.end());
  return test::Process(all).wait();
}

struct Heard {
  double begin, end;
  std::string name;
};

/// The sounds of a track, each until the next one.
std::vector<Heard> sounds_of(const std::string& track) {
  std::vector<Heard> sounds;
  std::istringstream lines(track);
  for (std::string line; std::getline(lines, line);) {
    const double begin = std::stod(line);
    if (!sounds.empty()) sounds.back().end = begin;
    sounds.push_back({begin, begin, line.substr(line.find('\t') + 1)});
  }
  return sounds;
}

std::vector<Heard> spoken(const std::string& text, const std::string& voice = "en") {
  const ScratchFolder folder;
  const std::string track = (folder / "a.tsv").string();
  const Ran ran = say({text, "--voice", voice, "-o", track});
  EXPECT_EQ(ran.code, 0) << text << ran.err;
  return ran.code == 0 ? sounds_of(read_text(track)) : std::vector<Heard>{};
}

/// Without its pauses.
std::string names_of(const std::vector<Heard>& sounds) {
  std::string names;
  for (const Heard& sound : sounds)
    if (!sound.name.empty()) names += sound.name + " ";
  return names;
}

bool closes(const std::string& name) {
  return name.starts_with('p') || name.starts_with('b') || name.starts_with('m');
}

/// The weight of PP at a moment.
class LipsMeet {
 public:
  explicit LipsMeet(const Motion& motion) {
    for (const MotionChannel& channel : motion.channels)
      if (channel.name == "viseme.PP") curve_ = &channel.curves.front();
  }
  double at(double time) const { return value_at(*curve_, time); }
  bool within(double from, double to) const {
    for (double t = from; t <= to; t += 0.001)
      if (at(t) >= 1) return true;
    return false;
  }

 private:
  const Curve* curve_ = nullptr;
};

constexpr std::pair<const char*, const char*> kSentences[] = {
    {"en", "Hello, my name is Bobby."},
    {"en", "Peter Piper picked a peck of pickled peppers."},
    {"en", "Maybe Pamela may become a member of the club."},
    {"en", "What a lovely morning for a bumblebee!"},
    {"de", "Papa, Mama und Bob haben viel Spaß beim Baden."},
    {"de", "Am Abend kommt mein Opa mit dem Apfelbaum."},
    {"de", "Bitte nimm die Suppe mit zum Bahnhof."},
    {"fr", "Bonjour maman, un petit pain beau."},
    {"fr", "Mon papa m'a apporté beaucoup de bonbons."},
    {"fr", "La pomme est tombée au bout du chemin."}};

// Ten sentences in three languages: while p, b and m sound the lips meet, from and to a frame of the sound's ends, for 80 ms.
TEST(Say, ClosesTheLipsWhenTheSoundDoes) {
  NEEDS_MIEN_SAY();
  constexpr double kFrame = 1 / 30.0;
  int closures = 0;
  for (const auto& [voice, sentence] : kSentences) {
    const ScratchFolder folder;
    const std::string track = (folder / "a.tsv").string();
    ASSERT_EQ(say({sentence, "--voice", voice, "-o", track}).code, 0);
    std::vector<Error> told;
    const auto motion = read_motion(track, &told);
    ASSERT_TRUE(motion);
    EXPECT_TRUE(told.empty()) << sentence << told.front().what;
    const LipsMeet lips(*motion);
    for (const Heard& sound : sounds_of(read_text(track))) {
      if (!closes(sound.name)) continue;
      ++closures;
      const std::string where = fmt::format("{}: {} at {}", sentence, sound.name, sound.begin);
      EXPECT_TRUE(lips.within(sound.begin - kFrame, sound.begin + kFrame)) << where;
      EXPECT_TRUE(lips.within(sound.end - kFrame, sound.end + kFrame)) << where;
      double shut = 0;
      for (double t = sound.begin - 0.1; t < sound.end + 0.1; t += 0.001)
        if (lips.at(t) >= 1) shut += 0.001;
      EXPECT_GE(shut, kLeastContact - 0.002) << where;
    }
  }
  EXPECT_GE(closures, 50);
}

bool is_plain_vowel(std::string name) {
  for (const std::string mark : {"ˈ", "ˌ"})
    if (name.starts_with(mark)) name.erase(0, mark.size());
  return !name.empty() && std::strchr("aeiou", name[0]);
}

TEST(Say, MarksWhatIsStressed) {
  NEEDS_MIEN_SAY();
  const std::string english = names_of(spoken("Hello, my name is Bobby."));
  EXPECT_NE(english.find("l ˈəʊ "), std::string::npos) << english;
  EXPECT_NE(english.find("b ˈɒ b i "), std::string::npos) << english;
  for (const auto& [voice, sentence] : kSentences) {
    const auto sounds = spoken(sentence, voice);
    const auto marked = std::count_if(sounds.begin(), sounds.end(), [](const Heard& sound) {
      return sound.name.starts_with("ˈ");
    });
    EXPECT_GE(marked, 1) << sentence;
    EXPECT_LE(3 * marked, std::ptrdiff_t(sounds.size())) << sentence;
  }
}

// The track is of this sound: where it has a pause there are no samples but zeros, and they end together.
TEST(Say, TrackAndSoundAreOfOneTime) {
  NEEDS_MIEN_SAY();
  const ScratchFolder folder;
  const std::string track = (folder / "a.tsv").string(), wave = (folder / "a.wav").string();
  for (const auto& [voice, sentence] : kSentences) {
    ASSERT_EQ(say({sentence, "--voice", voice, "-o", track, "--sound", wave}).code, 0);
    const auto sounds = sounds_of(read_text(track));
    EXPECT_NEAR(command::wave_seconds(wave)->value(), sounds.back().begin, 0.001) << sentence;
    const std::string bytes = read_text(wave);
    std::uint32_t rate = 0;
    std::memcpy(&rate, &bytes[24], 4);
    const auto loudest = [&](double from, double to) {
      int most = 0;
      for (auto i = std::size_t(from * rate); i < std::size_t(to * rate); ++i) {
        std::int16_t sample = 0;
        if (44 + 2 * i + 2 <= bytes.size()) std::memcpy(&sample, &bytes[44 + 2 * i], 2);
        most = std::max(most, std::abs(int(sample)));
      }
      return most;
    };
    for (std::size_t i = 1; i + 1 < sounds.size(); ++i) {
      if (sounds[i].name.empty() && sounds[i].end - sounds[i].begin > 0.08) {
        EXPECT_LT(loudest(sounds[i].begin + 0.03, sounds[i].end - 0.03), 100) << sentence << i;
      }
      if (is_plain_vowel(sounds[i].name)) {
        EXPECT_GT(loudest(sounds[i].begin, sounds[i].end), 1000) << sentence << i;
      }
    }
  }
}

TEST(Say, TakesMarksLiterally) {
  NEEDS_MIEN_SAY();
  EXPECT_EQ(names_of(spoken("<speak>hi</speak>")), names_of(spoken("speak hi slash speak")));
  EXPECT_EQ(names_of(spoken("<break/> now")), names_of(spoken("break slash now")));
  EXPECT_EQ(names_of(spoken("good\x01"
                            "9p\x1b morning")),
            names_of(spoken("good 9p  morning")));
  EXPECT_NE(names_of(spoken("[[h@l'oU]]")), names_of(spoken("hello"))) << "letters, no sounds";
}

TEST(Say, SpeaksLongTexts) {
  NEEDS_MIEN_SAY();
  std::string text;
  while (text.size() < 10'000) text += "My mother made a cup of tea. ";
  const auto sounds = spoken(text);
  EXPECT_GT(sounds.size(), 6000u);
  EXPECT_TRUE(std::is_sorted(sounds.begin(), sounds.end(),
                             [](const Heard& a, const Heard& b) { return a.begin < b.begin; }));
  EXPECT_GT(sounds.back().begin, 300);
}

TEST(Say, ReadsStandardInput) {
  NEEDS_MIEN_SAY();
  const ScratchFolder folder;
  EXPECT_EQ(say({"-", "-o", (folder / "a.tsv").string()}).err,
            "mien: text: has nothing in it that is spoken\n");  // it is empty here
}

TEST(Say, SaysWhatIsWrong) {
  NEEDS_MIEN_SAY();
  const ScratchFolder folder;
  const std::string track = (folder / "a.tsv").string();
  const std::tuple<Words, int, const char*> wrongs[] = {
      {{"...", "-o", track}, 1, "text: has nothing in it that is spoken"},
      {{" \x01\x1b ", "-o", track}, 1, "text: has nothing in it that is spoken"},
      {{"a\xff", "-o", track}, 1, "text: is not UTF-8"},
      {{"", "-o", track}, 2, "TEXT: is empty"},
      {{"hi", "-o", track, "--voice", "germn"},
       2,
       "--voice: no voice named \"germn\"; did you mean \"German\"?"},
      {{"hi", "-o", track, "--voice", "en-xy"}, 2, "did you mean \"en\"?"},
      {{"hi", "-o", track, "--voice", "de+f39"}, 2, "no variant named \"f39\""},
      {{"hi", "-o", track, "--rate", "9"}, 2, "--rate 9: expected a whole number from 80 to 450"},
      {{"hi", "-o", track, "--pitch", "x"}, 2, "--pitch x: expected a whole number from 0 to 100"},
      {{"hi", "-o", (folder / "a.wav").string()}, 2, "the sound is for --sound"},
      {{"hi", "-o", (folder / "a.xyz").string()}, 2, "expected a film"},
      {{"hi"}, 2, "-o FILE or --sound FILE is needed"},
      {{"hi", "-o", track, "--sound", track}, 2, "would overwrite a file of this command"},
      {{"hi", "-o", (folder / "a.gif").string(), "--face", "nobody"},
       1,
       "nobody: there is no such file"}};
  for (const auto& [words, code, what] : wrongs) {
    const Ran ran = say(words);
    EXPECT_EQ(ran.code, code) << what;
    EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(folder.names().empty()) << what;
  }
}

TEST(Say, MakesFilmsOfSampleFaces) {
  NEEDS_MIEN_SAY();
  const ScratchFolder folder;
  const std::string gif = (folder / "a.gif").string();
  ASSERT_EQ(say({"Bobby", "--face", "bruno", "--size", "48", "-o", gif}).code, 0);
  const double spoken_for = spoken("Bobby").back().begin;
  EXPECT_GE(test::read_film(gif).seconds(), spoken_for);
  if (!std::filesystem::exists("/usr/bin/ffmpeg")) GTEST_SKIP() << "no ffmpeg here";
  const std::string film = (folder / "a.mp4").string();
  const Ran ran = say({"Bobby", "--size", "48", "-o", film});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string asked =
      "/usr/bin/ffprobe -v error -show_entries stream=codec_type -of csv=p=0 ";
  const Ran probed = test::Process({"/bin/sh", "-c", asked + film}).wait();
  EXPECT_EQ(probed.out, "video\naudio\n");
  EXPECT_EQ(folder.names().size(), 2u) << "no temporaries";
}

TEST(Say, ListsVoices) {
  NEEDS_MIEN_SAY();
  const Ran ran = say({"--voices"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("de\tGerman\n"), std::string::npos) << ran.out;
}

TEST(Say, WithoutItsProgramNamesPackageAndOption) {
  const ScratchFolder folder;
  std::filesystem::copy(MIEN_COMMAND, folder / "mien");
  const Ran ran = test::Process({"/usr/bin/env", "PATH=/nowhere", (folder / "mien").string(), "say",
                                 "hi", "-o", (folder / "a.tsv").string()})
                      .wait();
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err,
            "mien: say: text is spoken by the program mien-say, which is not here: install the "
            "package mien-say, or build mien with -DMIEN_BUILD_SAY=ON\n");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(SampleFaces, AreKnownByName) {
  const ScratchFolder folder;
  const std::string by_name = (folder / "a.png").string(), by_file = (folder / "b.png").string();
  ASSERT_EQ(test::run_mien({"render", "toon", "--size", "48", "-o", by_name}).code, 0);
  ASSERT_EQ(test::run_mien({"render", face_path("faces/toon"), "--size", "48", "-o", by_file}).code,
            0);
  EXPECT_EQ(test::read(by_name).channels, test::read(by_file).channels);
}

}  // namespace
}  // namespace mien
