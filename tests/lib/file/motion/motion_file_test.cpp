#include <mien/motion_file.h>

#include <mien/motion_length.h>
#include "lib/rig/pose/curve.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

struct ReadMotion {
  std::optional<Motion> motion;
  std::string error;
  std::vector<std::string> told;

  /// A channel's value; NaN: there is none.
  double at(std::string_view channel, double time) const {
    for (const MotionChannel& one : motion->channels)
      if (one.name == channel) return value_at(one.curves[0], time);
    return NAN;
  }
  double length() const { return motion_length(*motion); }
};

ReadMotion read(std::string_view text, const MotionLimits& limits = {}) {
  ReadMotion read;
  std::vector<Error> told;
  const auto motion = read_motion_text(text, "f", &told, limits);
  if (motion)
    read.motion = *motion;
  else
    read.error = sentence(motion.error());
  for (const Error& one : told) read.told.push_back(sentence(one));
  return read;
}

TEST(MotionFile, ReadsTakesOfLiveLinkFace) {
  const ReadMotion take = read(
      "Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw\r\n"
      "23:59:59:58.500,61,0.0,0.25,0.1,0,0,0.3\r\n"
      "00:00:00:00.500,61,1.0,0.75,0.2,-0.1,0.05,0.3\r\n"
      "00:00:00:04.500,61,0.5,0.5,0.2,0,0,0.3\r\n");
  ASSERT_TRUE(take.motion) << take.error;
  EXPECT_TRUE(take.told.empty()) << take.told[0];
  EXPECT_TRUE(take.motion->settled);
  EXPECT_NEAR(take.length(), 6 / 60.0, 1e-9) << "60 frames a second, past midnight, a row dropped";
  EXPECT_EQ(take.at("arkit.jawOpen", 0), 0.25);
  EXPECT_NEAR(take.at("arkit.jawOpen", 1 / 60.0), 0.5, 1e-6);
  EXPECT_NEAR(take.at("arkit.eyeBlinkLeft", 4 / 60.0), 0.75, 1e-6) << "bridged";
  EXPECT_EQ(take.at("arkit.eyeBlinkLeft", 9), 0.5) << "held";
  const double degrees = 180 / M_PI;
  EXPECT_NEAR(take.at("yaw", 0), -0.1 * degrees, 1e-5);
  EXPECT_NEAR(take.at("pitch", 2 / 60.0), 0.1 * degrees, 1e-5);
  EXPECT_NEAR(take.at("roll", 2 / 60.0), -0.05 * degrees, 1e-5);
}

TEST(MotionFile, BridgesRowsOfATakeInWhichNoFaceWasSeen) {
  const std::vector<std::string> told{"f: 3 rows in which no face was seen are bridged"};
  const ReadMotion app = read(
      "Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen\n"
      "12:00:00:00.000,0\n12:00:00:02.000,61,0,0.25\n12:00:00:04.000,0\n12:00:00:05.000,0,,\n"
      "12:00:00:06.000,61,1,0.75\n");
  ASSERT_TRUE(app.motion) << app.error;
  EXPECT_EQ(app.told, told);
  EXPECT_NEAR(app.at("arkit.jawOpen", 2 / 60.0), 0.5, 1e-6);
  EXPECT_NEAR(app.length(), 4 / 60.0, 1e-9) << "it begins with the first face";
  const ReadMotion any = read("time,jawOpen,mouthClose\n0,0.25,0\n1,,\n2,,\n3,,\n4,0.75,0\n");
  ASSERT_TRUE(any.motion) << any.error;
  EXPECT_EQ(any.told, told);
  EXPECT_NEAR(any.at("arkit.jawOpen", 2), 0.5, 1e-6);
  EXPECT_EQ(read("Timecode,BlendShapeCount,JawOpen,MouthClose\n12:00:00:02.000,61,0.5\n").error,
            "f:2: 3 cells, the heading has 4");
  EXPECT_EQ(read("time,jawOpen,mouthClose\n0,0.25,\n").error,
            "f:2:8: the number of \"mouthClose\" is missing");
}

TEST(MotionFile, ReadsTakesOfOpenFace) {
  const ReadMotion take = read(
      "frame, face_id, timestamp, confidence, success, gaze_angle_x, gaze_angle_y, pose_Rx, "
      "pose_Ry, "
      "pose_Rz, AU12_r, AU45_r, AU12_c, AU28_c\n"
      "1, 0, 0.000, 0.98, 1, 0.25, -0.1, 0.1, 0.2, 0.3, 2.50, 0.00, 1.00, 0.00\n"
      "2, 0, 0.033, 0.10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0\n"
      "2, 1, 0.033, 0.10, 1, 0, 0, 0, 0, 0, 5, 5, 0, 0\n"
      "3, 0, 0.066, 0.98, 1, -0.25, 0.1, 0, 0, 0, 5.00, 5.00, 0.00, 1.00\n");
  ASSERT_TRUE(take.motion) << take.error;
  EXPECT_EQ(take.at("facs.AU12", 0), 0.5);
  EXPECT_NEAR(take.at("facs.AU12", 0.033), 0.75, 1e-6) << "bridged";
  EXPECT_EQ(take.at("facs.AU45", 0.066), 1);
  EXPECT_EQ(take.at("facs.AU28", 0.066), 1) << "has no intensity";
  EXPECT_EQ(take.at("facs.AU61", 0), 0.5) << "to the subject's left";
  EXPECT_EQ(take.at("facs.AU62", 0), 0);
  EXPECT_EQ(take.at("facs.AU62", 0.066), 0.5);
  EXPECT_NEAR(take.at("facs.AU63", 0), 0.2, 1e-6) << "up";
  EXPECT_NEAR(take.at("yaw", 0), -0.2 * 180 / M_PI, 1e-5);
  EXPECT_EQ(take.told,
            (std::vector<std::string>{"f: 1 rows of other faces than the first are left out",
                                      "f: 1 rows in which no face was seen are bridged"}));
}

TEST(MotionFile, ReadsTablesOfAnyOtherProgram) {
  const ReadMotion take = read("time (s);jawOpen;eyeBlink_L;mood\n0,5;0,25;0;3\n1,5;0,75;1;3\n");
  ASSERT_TRUE(take.motion) << take.error;
  EXPECT_EQ(take.at("arkit.jawOpen", 1), 0.5);
  EXPECT_EQ(take.at("arkit.eyeBlinkLeft", 1.5), 1);
  EXPECT_EQ(take.length(), 1.5) << "seconds are as they are written";
  EXPECT_EQ(take.told,
            (std::vector<std::string>{"f: a column that moves no face is left out: \"mood\"",
                                      "f: numbers are read with decimal commas"}));
  const ReadMotion weights = read("time,sil,PP,ih,oh,ou\n0,1,0,0,0,0\n1,0,0.5,0.25,0.125,0.1\n");
  ASSERT_TRUE(weights.motion) << weights.error;
  EXPECT_EQ(weights.at("viseme.I", 1), 0.25);
  EXPECT_EQ(weights.at("viseme.O", 1), 0.125);
  const ReadMotion spread = read("timestamp\temotion.joy\tvrm.happy\n5000\t0\t0\n5033\t1\t0.5\n");
  ASSERT_TRUE(spread.motion) << spread.error;
  EXPECT_NEAR(spread.length(), 0.033, 1e-9) << "milliseconds of a clock";
  EXPECT_EQ(spread.at("emotion.joy", 1), 1);
}

TEST(MotionFile, ReadsPercentWhereAllIsPercent) {
  const ReadMotion percent = read("time,jawOpen,mouthPucker,HeadYaw\n0,40,3,0.5\n1,80.5,0.5,0.1\n");
  ASSERT_TRUE(percent.motion) << percent.error;
  EXPECT_NEAR(percent.at("arkit.jawOpen", 1), 0.805, 1e-6);
  EXPECT_NEAR(percent.at("yaw", 0), -0.5 * 180 / M_PI, 1e-4) << "angles are no shares";
  EXPECT_EQ(percent.told,
            std::vector<std::string>{"f: shares are read as 0 to 100: the largest is 80.5"});
}

/// Names of channels may be anything; what is told of them stays one line.
TEST(MotionFile, TellsOfNamesInOneLine) {
  const ReadMotion take = read(
      "time,muscle.a\x10"
      "b\n0,3\n1,0\n");
  ASSERT_TRUE(take.motion) << take.error;
  ASSERT_EQ(take.told.size(), 1u);
  EXPECT_NE(take.told[0].find("muscle.a\\x10b = 3"), std::string::npos) << take.told[0];
}

TEST(MotionFile, ClampsAndCounts) {
  const ReadMotion take = read("time,jawOpen,mouthPucker\n0,1.27,0.5\n1,-0.1,1e30\n2,0.5,0.5\n");
  ASSERT_TRUE(take.motion) << take.error;
  EXPECT_EQ(take.at("arkit.jawOpen", 0), 1);
  EXPECT_EQ(take.at("arkit.jawOpen", 1), 0);
  ASSERT_EQ(take.told.size(), 1u);
  EXPECT_EQ(
      take.told[0],
      "f: 3 of 6 values lay out of range and were clamped, the farthest arkit.mouthPucker = 1e+30 "
      "at 1.000 s, which goes from 0 to 1");
}

TEST(MotionFile, ReadsFramesLineByLineAndInLists) {
  const std::string media[] = {
      R"({"timestamp_ms": 1000, "faceBlendshapes": [{"categories": [{"categoryName": "_neutral", "score": 0.9},
         {"categoryName": "jawOpen", "score": 0.25}]}], "facialTransformationMatrixes": [{"rows": 4, "columns": 4,
         "data": [0.8660254, 0, -0.5, 0, 0, 1, 0, 0, 0.5, 0, 0.8660254, 0, 1, 2, -40, 1]}]})",
      R"({"timestamp_ms": 1033, "faceBlendshapes": []})",
      R"({"timestamp_ms": 1066, "faceBlendshapes": [{"categories": [{"categoryName": "jawOpen", "score": 0.75}]}]})"};
  std::string one_line_each, list = "[";
  for (std::string frame : media) {
    list += (list.size() > 1 ? "," : "") + frame;
    std::erase(frame, '\n');
    one_line_each += frame + "\n";
  }
  list += "]";
  for (const std::string& text : {one_line_each, list}) {
    const ReadMotion take = read(text);
    ASSERT_TRUE(take.motion) << take.error;
    EXPECT_EQ(take.at("arkit.jawOpen", 0), 0.25);
    EXPECT_NEAR(take.at("arkit.jawOpen", 0.033), 0.5, 1e-6);
    EXPECT_NEAR(take.at("yaw", 0), 30, 1e-3) << "to the right of the picture";
    EXPECT_EQ(take.told,
              std::vector<std::string>{"f: 1 rows in which no face was seen are bridged"});
  }
  const ReadMotion arkit = read(
      "{\"timestamp\": 7.5, \"blendShapes\": {\"JawOpen\": 0.25}, \"headYaw\": 0.1}\n"
      "{\"timestamp\": 8, \"blendShapes\": {\"JawOpen\": 0.75, \"tongueOut\": 1}, \"headYaw\": "
      "0.2}\n");
  ASSERT_TRUE(arkit.motion) << arkit.error;
  EXPECT_EQ(arkit.at("arkit.jawOpen", 0.25), 0.5);
  EXPECT_EQ(arkit.at("arkit.tongueOut", 0), 0) << "new in a later row";
  EXPECT_EQ(arkit.at("arkit.tongueOut", 0.5), 1);
  EXPECT_NEAR(arkit.at("yaw", 0), -0.1 * 180 / M_PI, 1e-5);
  const ReadMotion film = read(R"({"fps": 4, "frames": [{"jawOpen": 0}, {"jawOpen": 1}]})");
  ASSERT_TRUE(film.motion) << film.error;
  EXPECT_EQ(film.at("arkit.jawOpen", 0.125), 0.5);
}

TEST(MotionFile, ReadsWhatAzureGives) {
  std::string row = "[";
  for (int i = 0; i < 55; ++i) row += (i > 0 ? "," : "") + std::string(i == 17 ? "0.5" : "0");
  row += "]";
  const std::string frames = "{\"FrameIndex\": 30, \"BlendShapes\": [" + row + "," + row + "]}";
  const ReadMotion shapes = read("[" + frames + "]");
  ASSERT_TRUE(shapes.motion) << shapes.error;
  EXPECT_EQ(shapes.at("arkit.jawOpen", 0.5), 0.5);
  EXPECT_NEAR(shapes.length(), 31 / 60.0, 1e-9);
  const ReadMotion events = read(
      "{\"audio_offset\": 500000, \"viseme_id\": 0}\n{\"audio_offset\": 1000000, \"viseme_id\": "
      "21}\n"
      "{\"audio_offset\": 2000000, \"viseme_id\": 2}\n{\"audio_offset\": 4000000, \"viseme_id\": "
      "0}\n");
  ASSERT_TRUE(events.motion) << events.error;
  EXPECT_EQ(events.at("viseme.PP", 0.15), 1);
  EXPECT_GT(events.at("viseme.aa", 0.3), 0.7);
}

constexpr const char* kLongGrid = R"(File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0
xmax = 1
tiers? <exists>
size = 2
item []:
    item [1]:
        class = "IntervalTier"
        name = "words"
        xmin = 0
        xmax = 1
        intervals: size = 1
        intervals [1]:
            xmin = 0
            xmax = 1
            text = "say ""ma"""
    item [2]:
        class = "IntervalTier"
        name = "phones"
        xmin = 0
        xmax = 1
        intervals: size = 3
        intervals [1]:
            xmin = 0
            xmax = 0.2
            text = ""
        intervals [2]:
            xmin = 0.2
            xmax = 0.4
            text = "M"
        intervals [3]:
            xmin = 0.4
            xmax = 1
            text = "AA1"
)";

TEST(MotionFile, ReadsTracksOfSpeech) {
  const std::string short_grid =
      "File type = "
      "\"ooTextFile\"\n\"TextGrid\"\n0\n1\n<exists>\n1\n\"IntervalTier\"\n\"phones\"\n0\n1\n3\n"
      "0\n0.2\n\"\"\n0.2\n0.4\n\"M\"\n0.4\n1\n\"AA1\"\n";
  std::string utf16 = "\xFF\xFE";
  for (const char* c = kLongGrid; *c; ++c) utf16 += std::string{*c, '\0'};
  const std::pair<const char*, std::string> tracks[] = {
      {"a long TextGrid", kLongGrid},
      {"in UTF-16", utf16},
      {"a short one", short_grid},
      {"marks", "0\tsil\n0.2\tm\n0.4\tɑː\n1\t\n"},
      {"visemes", "0 sil\n0.2 PP\n0.4 aa\n1.0 sil\n"},
      {"Rhubarb's TSV", "0.00\tX\n0.20\tA\n0.40\tD\n1.00\tX\n"},
      {"Rhubarb's JSON",
       R"({"metadata": {"soundFile": "a.wav", "duration": 1}, "mouthCues": [
          {"start": 0, "end": 0.2, "value": "X"}, {"start": 0.2, "end": 0.4, "value": "A"},
          {"start": 0.4, "end": 1, "value": "D"}]})"},
      {"Rhubarb's XML",
       "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<rhubarbResult>\n <mouthCues>\n"
       "  <mouthCue start=\"0.00\" end=\"0.20\">X</mouthCue>\n  <mouthCue start=\"0.20\" "
       "end=\"0.40\">A</mouthCue>"
       "<mouthCue start=\"0.40\" end=\"1.00\">D</mouthCue>\n </mouthCues>\n</rhubarbResult>\n"},
      {"a .pho", "; espeak\n_ 200\nm 200 0 110 99 120\nA: 600\n_ 100\n"}};
  for (const auto& [what, text] : tracks) {
    const ReadMotion track = read(text);
    ASSERT_TRUE(track.motion) << what << ": " << track.error;
    EXPECT_TRUE(track.told.empty()) << what << ": " << track.told[0];
    ASSERT_EQ(track.motion->channels.size(), 15u) << what;
    for (double t = 0.2301; t < 0.37; t += 0.001)
      ASSERT_EQ(track.at("viseme.PP", t), 1) << what << t;
    EXPECT_GT(track.at("viseme.aa", 0.7), 0.9) << what;
    EXPECT_EQ(track.at("viseme.aa", -3), 0) << what << ": before all, the face rests";
  }
}

TEST(MotionFile, TellsOnceOfSoundsThatItDoesNotKnow) {
  const ReadMotion track = read("0\tm\n0.1\t☃\n0.2\tm\n0.3\t☃\n0.4\ta\n");
  ASSERT_TRUE(track.motion) << track.error;
  EXPECT_EQ(track.told, std::vector<std::string>{"f: no sound is called \"☃\": it is shown as kk"});
}

TEST(MotionFile, SaysWhatIsWrongAndWhere) {
  const auto said = [](std::string_view text) { return read(text).error; };
  EXPECT_EQ(said(""), "f: is empty");
  EXPECT_EQ(said("hello\n"),
            "f:1: is no take or track of speech that is known: a table with a column of "
            "times, JSON, a TextGrid, cues of Rhubarb, or a moment and a sound in each line");
  EXPECT_EQ(
      said("jawOpen,mouthPucker\n0.1,0.2\n"),
      "f:1: no column holds times: expected one called \"Timecode\", \"timestamp\" or \"time\"");
  EXPECT_EQ(said("time,jawOpne\n0,0\n"),
            "f:1: no channel of a face named \"jawOpne\"; did you mean \"jawOpen\"?");
  EXPECT_EQ(said("time,jawOpen\n0,0.1\n1\n"), "f:3: 1 cells, the heading has 2");
  EXPECT_EQ(said("time,jawOpen\n0,0.1\n1,nan\n"),
            "f:3:3: expected a finite number for \"jawOpen\", got \"nan\"");
  EXPECT_EQ(said("time,jawOpen\n0,0.1\n1,\n"), "f:3:3: the number of \"jawOpen\" is missing");
  EXPECT_EQ(said("time,jawOpen\n1,0.1\n2,0.1\n1.5,0\n"), "f:4:1: time goes back, from 2 to 1.5");
  EXPECT_EQ(said("Timecode,JawOpen\n13:00:00:99.1,0\n"),
            "f:2:1: expected a time code like 13:29:07:45.453, got \"13:00:00:99.1\"");
  EXPECT_EQ(said("time,jawOpen\n"), "f: has no rows");
  EXPECT_EQ(said("time,jawOpen,jawOpen\n0,0,0\n"), "f:1:14: two columns are called \"jawOpen\"");
  EXPECT_EQ(said("{\"time\": 0, \"jawOpen\": 1}\n{\"time\": 1, \"jawOpen\": }\n").substr(0, 6),
            "f:2:24");
  EXPECT_EQ(said("{\"time\": 0, \"jawOpen\": 1}\n{\"jawOpen\": 1}\n"),
            "f:2:1: the frame has no time: expected \"time\", \"timestamp\" or \"timestamp_ms\", "
            "or \"fps\" beside \"frames\"");
  EXPECT_EQ(said("{\"mouthCues\": [{\"start\": 1, \"value\": \"A\"},\n{\"start\": 0.5, \"value\": "
                 "\"B\"}]}"),
            "f:2:1: /mouthCues/1: time goes back, from 1 to 0.5");
  EXPECT_EQ(said("0.5\tp\nx\tb\n"), "f:2:1: expected SECONDS and the name of a sound, got \"x\"");
  EXPECT_EQ(said("a 100\nb -3\n"), "f:2:3: expected the milliseconds that \"b\" lasts, got \"-3\"");
  EXPECT_EQ(said("<rhubarbResult>\n<mouthCue start=\"a\" end=\"1\">X</mouthCue>"),
            "f:2:18: expected the seconds of start, got \"a\"");
  EXPECT_EQ(said("<rhubarbResult>\n<mouthCue start=\"0\" end=\"1\">X</mouthCue>\n"),
            "f:2: the file ends before </rhubarbResult>");
  EXPECT_EQ(said("\"ooTextFile\"\n\"TextGrid\"\n0\n1\n<exists>"
                 "\n1\n\"IntervalTier\"\n\"phones\"\n0\n1\n2\n0\n0.5\n\"m\"\n"),
            "f: the file ends within a TextGrid");
  EXPECT_EQ(said("\"ooTextFile\"\n\"TextGrid\"\n0\n\"one\"\n"),
            "f:4:1: expected its last moment, got \"one\"");
  EXPECT_FALSE(read_motion("/no/such/file"));
  EXPECT_EQ(sentence(read_motion("/").error()), "/: is a directory");
}

/// A million rows go through block by block: what is kept is their numbers.
TEST(MotionFile, ReadsTablesAsTheyCome) {
  const test::ScratchFolder folder;
  std::string text = "time,jawOpen\n";
  for (int i = 0; i < 100'000; ++i)
    text += fmt::format("{:.3f},{:.3f}\n", i / 60.0, (i % 100) / 100.0);
  test::write_text(folder / "long.csv", text);
  const auto motion = read_motion(folder / "long.csv");
  ASSERT_TRUE(motion) << sentence(motion.error());
  EXPECT_NEAR(motion_length(*motion), 99'999 / 60.0, 1e-3);
  EXPECT_EQ(read(text, {.rows = 1000}).error, "f:1002:1: more than 1000 rows (limit: rows)");
  EXPECT_EQ(read(text, {.numbers = 500}).error, "f:502:1: more than 500 numbers (limit: numbers)");
  EXPECT_EQ(read("time,jawOpen,mouthPucker and a long line", {.bytes = 10}).error,
            "f:1: a line longer than 10 bytes (limit: bytes)");
}

TEST(MotionFile, SaysWhichOfManyLinesIsBroken) {
  std::string text;
  for (int i = 1; i <= 100'000; ++i)
    text += i == 70'000
                ? "{\"timestamp\": 1, \"jawOpen\": 0.5,\n"
                : fmt::format("{{\"timestamp\": {:.3f}, \"jawOpen\": 0.{}}}\n", i / 60.0, i % 10);
  EXPECT_TRUE(read(text).error.starts_with("f:70000:33: malformed JSON")) << read(text).error;
}

TEST(MotionFile, ReadsSoundsOfAnyLength) {
  const ReadMotion hour = read("a 3600000\nm 0\na 0\nm 0\na 1000\n");
  ASSERT_TRUE(hour.motion) << hour.error;
  EXPECT_GT(hour.at("viseme.aa", 1800), 0.99);
  for (const double time : {3599.97, 3600.0, 3600.03}) EXPECT_EQ(hour.at("viseme.PP", time), 1);
  EXPECT_GT(hour.at("viseme.aa", 3600.6), 0.9);
  const ReadMotion over = read(
      R"({"mouthCues": [{"start": 0, "end": 3600, "value": "D"}, {"start": 1, "end": 1, "value": "A"},
                        {"start": 1, "end": 5, "value": "B"}]})");
  ASSERT_TRUE(over.motion) << over.error;
  EXPECT_EQ(over.at("viseme.PP", 1), 1);
  EXPECT_LT(over.at("viseme.aa", 3), 0.01) << "a sound ends where the next begins";
  EXPECT_EQ(read("a 1e15\n").error, "f:1:1: 1000000000000 is no moment of speech");
}

/// Ten megabytes: work grows with a grid's intervals, not with their square.
TEST(MotionFile, ReadsLongGrids) {
  constexpr int kSounds = 100'000;
  std::string text = fmt::format(
      "\"ooTextFile\"\n\"TextGrid\"\nxmin = 0\nxmax = {0}\ntiers? <exists>\nsize = 1\n"
      "class = \"IntervalTier\"\nname = \"phones\"\nxmin = 0\nxmax = {0}\nintervals: size = {1}\n",
      kSounds / 10, kSounds);
  for (int i = 0; i < kSounds; ++i)
    text += fmt::format(
        "        intervals [{}]:\n            xmin = {:.1f}\n            xmax = {:.1f}\n"
        "            text = \"{}\"\n",
        i + 1, i / 10.0, (i + 1) / 10.0, i % 2 ? "AA1" : "M");
  const ReadMotion grid = read(text);
  ASSERT_TRUE(grid.motion) << grid.error;
  EXPECT_EQ(grid.at("viseme.PP", 9000.05), 1);
  EXPECT_LT(grid.at("viseme.PP", 9000.15), 0.5);
}

TEST(MotionFile, SurvivesDamage) {
  std::string text = kLongGrid;
  for (std::size_t length = 0; length < text.size(); length += 3) {
    const auto motion = read_motion_text(text.substr(0, length));
    EXPECT_TRUE(motion || !motion.error().what.empty());
  }
}

std::vector<double> accents(std::string_view text) {
  std::vector<double> times;
  const ReadMotion track = read(text);
  for (const SpokenAccent& accent : track.motion->spoken.accents)
    times.push_back(accent.rising ? -accent.time : accent.time);
  return times;
}

TEST(MotionFile, FindsTheStressesOfTracks) {
  using Times = std::vector<double>;
  EXPECT_EQ(accents("0\tAH0\n1\tAH1\n2\tAH2\n3\tsil\n"), (Times{1.4, 2.4}));
  EXPECT_EQ(accents("0\tˈb\n1\ta\n2\tə\n3\tˈn\n4\t\n5\ta\n6\t\n"), Times{1.4})
      << "a mark before a consonant is the vowel's, but past no pause";
  EXPECT_EQ(accents("0\ta\n1\tm\n2\t\n"), Times{}) << "tells of none";
  EXPECT_EQ(accents("0\tA\n1\tD\n2\tX\n"), Times{}) << "Rhubarb has none";
}

TEST(MotionFile, HearsThePitchOfPhoFiles) {
  const auto heard = accents(
      "_ 200\na 1000 0 100 50 102 100 100\nm 1000 0 100\na 1000 0 100 100 125\nn 1000 20 101\n"
      "a 1000 0 130 80 120\n_ 100\n");
  ASSERT_EQ(heard.size(), 2u) << "one is neither";
  EXPECT_NEAR(heard[0], -2.6, 1e-9) << "it goes up";
  EXPECT_NEAR(heard[1], 4.6, 1e-9) << "it is high";
  EXPECT_TRUE(accents("a 1000 x y\na 1000 0 -5 1\n").empty());
}

TEST(MotionFile, TellsWhenLipsTouch) {
  const auto contacts = read("0\ta\n1\tm\n2\tf\n3\ta\n4\t\n").motion->spoken.contacts;
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_NEAR(contacts[0].begin, 1.15, 1e-9);
  EXPECT_NEAR(contacts[1].end, 2.85, 1e-9);
}

}  // namespace
}  // namespace mien
