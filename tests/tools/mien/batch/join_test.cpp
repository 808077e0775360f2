// Pieces become the file that one run would have written, or a sentence tells why not.

#include <sys/stat.h>

#include "tests/tools/mien/batch/batch_fixture.h"

namespace mien {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class JoinTest : public BatchTest {
 protected:
  /// Draws a job in two parts and joins it; gives what was joined.
  std::string joined(const std::string& job, const std::string& name) {
    fs::remove_all(folder_ / "out");
    plan(job);
    for (const char* part : {"1/2", "2/2"}) {
      const Ran ran = batch("out", part);
      EXPECT_EQ(ran.code, 0) << ran.err;
    }
    const Ran ran = join();
    EXPECT_EQ(ran.code, 0) << ran.err;
    return read_text(path("out/" + name));
  }
  std::string rendered(Words words, const std::string& name) const {
    words.insert(words.end(), {"-o", path(name)});
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return read_text(path(name));
  }
  static std::string job(const Words& run, const std::string& rest) {
    std::string text;
    for (const std::string& word : run) text += (text.empty() ? "\"" : ", \"") + word + "\"";
    return R"({"run": [)" + text + "], " + rest + "}";
  }
  /// Two parts of four people that are done.
  void two_parts() {
    plan(people(4));
    ASSERT_EQ(batch("out", "1/2").code, 0);
    ASSERT_EQ(batch("out", "2/2").code, 0);
  }
  void change(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = read_text(file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_text(file, text.replace(at, from.size(), to));
  }
  std::string refusal() const {
    const Ran ran = join();
    EXPECT_EQ(ran.code, 1);
    const std::string start = "mien: " + path("out");
    EXPECT_TRUE(ran.err.starts_with(start)) << ran.err;
    return ran.err.substr(std::min(start.size(), ran.err.size()));
  }
};

TEST_F(JoinTest, RegionsAreTheBytesOfTheWholePicture) {
  struct Case {
    Words options;
    std::string regions, piece, whole;
  };
  for (const Case& one :
       {Case{{"--size", "700"}, "[3, 2]", "tif", "a.tif"},
        Case{{"--size", "700"}, "[2, 3]", "png", "a.png"},
        Case{{"--size", "1500x900"}, "[2, 2]", "tif", "a.png"},
        Case{{"--size", "333", "--background", "transparent"}, "[4, 4]", "png", "a.tif"},
        Case{{"--size", "300", "--depth", "16", "--dpi", "300"}, "[2, 1]", "tif", "a.tif"},
        Case{{"--size", "300", "--depth", "float", "--background", "transparent"},
             "[1, 3]",
             "tif",
             "a.tif"},
        Case{{"--size", "400", "--effect", "mosaic:20"}, "[2, 2]", "png", "a.png"}}) {
    Words run{"render", test::face_path("toon"), "--time", "0.4"};
    run.insert(run.end(), one.options.begin(), one.options.end());
    const std::string got = joined(
        job(run, R"("each": {"at": {"regions": )" + one.regions + R"(}}, "output": "a/{at}.)" +
                     one.piece + R"(", "join": ")" + one.whole + "\""),
        one.whole);
    EXPECT_TRUE(got == rendered(run, one.whole)) << one.regions << " of " << one.options[1];
  }
}

// Cuts at tiles do not depend on where the strips are that are read.
TEST_F(JoinTest, LargeRegionsBeginAtTiles) {
  const Words run{"render", test::face_path("toon"), "--size", "2500x1800"};
  const std::string got = joined(
      job(run, R"("each": {"at": {"regions": [3, 3]}}, "output": "{at}.tif", "join": "a.tif")"),
      "a.tif");
  EXPECT_TRUE(got == rendered(run, "a.tif"));
}

TEST_F(JoinTest, FramesAreTheBytesOfTheWholeFilm) {
  Words run{"animate", test::face_path("toon"), "--size", "48", "--fps", "12"};
  for (const char* film : {"a.apng", "a.gif", "a.webp"}) {
    const std::string got = joined(
        job(run,
            R"("each": {"frame": {"frames": "3-90"}}, "output": "f/50% {frame}.png", "join": ")" +
                std::string(film) + "\""),
        film);
    Words whole = run;
    whole.insert(whole.end(), {"--frames", "3-90"});
    EXPECT_TRUE(got == rendered(whole, film)) << film;
    EXPECT_EQ(files().size(), 89u);
  }
}

TEST_F(JoinTest, SeveralPicturesOfOneJob) {
  plan(job({"render", "toon", "--size", "90", "--emotion", "{feeling}"},
           R"("each": {"feeling": ["joy", "fear"], "at": {"regions": [2, 2]}},
              "output": "{feeling}/{at}.png", "join": "{feeling}.png")"));
  ASSERT_EQ(batch().code, 0);
  EXPECT_EQ(join().out, "8 items, all whole; 2 joined\n");
  for (const char* feeling : {"joy", "fear"})
    EXPECT_TRUE(read_text(path("out/" + std::string(feeling) + ".png")) ==
                rendered({"render", "toon", "--size", "90", "--emotion", feeling}, "a.png"));
}

TEST_F(JoinTest, AnExperimentIsTheFolderThatStimuliMakes) {
  write_text(folder_ / "trial.json",
             R"({"format": "mien-stimuli", "format_version": 1, "size": 32,
                 "factors": [{"people": 2}, {"emotion": "joy", "steps": 3}]})");
  joined(R"({"run": ["stimuli"], "each": {"picture": {"stimuli": "trial.json"}},
             "output": "trial/{picture}", "join": "trial/manifest.json"})",
         "trial/manifest.json");
  ASSERT_EQ(run_mien({"stimuli", path("trial.json"), "-o", path("whole")}).code, 0);
  EXPECT_EQ(files("out/trial"), files("whole"));
}

TEST_F(JoinTest, TellsWhatIsMissing) {
  plan(people(4));
  ASSERT_EQ(batch("out", "2/2").code, 0);
  EXPECT_TRUE(refusal().starts_with(": 2 of 4 items are missing; the first is \"crowd/"));
  EXPECT_TRUE(refusal().ends_with(", of part 1/2\n")) << refusal();
}

TEST_F(JoinTest, TellsWhichFileIsNotTheOneThatWasRecorded) {
  two_parts();
  const std::string first = files().begin()->first, last = files().rbegin()->first;
  const std::string bytes = read_text(path("out/" + first));
  write_text(path("out/" + first), bytes.substr(0, bytes.size() - 1));
  EXPECT_EQ(refusal(), "/" + first + ": is not the file that was recorded\n");
  fs::remove(path("out/" + first));
  EXPECT_EQ(refusal(), "/" + first + ": cannot be read: No such file or directory\n");
  fs::remove(path("out/" + last));
  EXPECT_NE(refusal().find(", and 1 more are wrong\n"), std::string::npos);
}

TEST_F(JoinTest, RefusesPartsThatDoNotBelongTogether) {
  two_parts();
  const std::string first = manifest("1-of-2"), kept = read_text(first);
  const std::string start = "/manifest-1-of-2.jsonl: ";
  change(first, R"("instructions": ")", R"("instructions": "un)");
  EXPECT_NE(refusal().find("multiply-adds, and other parts with"), std::string::npos) << refusal();
  write_text(first, kept);
  change(first, R"("mien": ")", R"("mien": "9)");
  EXPECT_TRUE(refusal().starts_with(start + "was drawn by mien 9")) << refusal();
  write_text(first, kept);
  change(first, R"("plan": ")", R"("plan": "0)");
  EXPECT_TRUE(refusal().starts_with(start + "is a part of another plan")) << refusal();
  write_text(first, kept);
  change(first, R"("items": 2)", R"("items": 3)");
  EXPECT_TRUE(refusal().starts_with(start + "is no part of this plan")) << refusal();
  write_text(first, kept.substr(0, kept.size() - 1));
  EXPECT_EQ(refusal(), start + "is no whole manifest: its last line has no end\n");
  write_text(first, kept + "{}\n");
  EXPECT_EQ(refusal(), "/manifest-1-of-2.jsonl:4:1: \"item\" is missing\n");
}

TEST_F(JoinTest, RefusesPartsThatOverlapOrRepeat) {
  two_parts();
  const std::string first = manifest("1-of-2"), kept = read_text(first);
  const std::string other = read_text(manifest("2-of-2"));
  const std::size_t header = kept.find('\n') + 1;
  const std::string one = kept.substr(header, kept.find('\n', header) + 1 - header);
  write_text(first, kept + one);
  EXPECT_TRUE(refusal().ends_with(" stands there twice\n")) << refusal();
  write_text(first, kept + other.substr(other.find('\n') + 1));
  EXPECT_TRUE(refusal().ends_with(" belongs to another part than 1 of 2\n")) << refusal();
  write_text(first, kept);
  change(first, "crowd/", "crowds/");
  EXPECT_TRUE(refusal().ends_with(" is no item of the plan\n")) << refusal();
  write_text(first, kept);
  ASSERT_EQ(batch("out").code, 0);
  EXPECT_EQ(join().code, 0) << "splits that agree";
  change(first, R"("sha256": ")", R"("sha256": "0)");
  EXPECT_TRUE(refusal().ends_with(" is recorded otherwise in manifest-1-of-1.jsonl\n"))
      << refusal();
}

// Pieces that were drawn of a face file before it was changed are not this plan's.
TEST_F(JoinTest, AFileThatThePlanNamesBelongsToIt) {
  ASSERT_EQ(run_mien({"new", "--seed", "ada", "-o", path("ada.face.json")}).code, 0);
  plan(job({"render", "ada.face.json", "--size", "24", "--blink", "{n}"},
           R"("each": {"n": [0, 1]}, "output": "{n}.png")"));
  ASSERT_EQ(batch().code, 0);
  ASSERT_EQ(join().code, 0);
  ASSERT_EQ(run_mien({"new", "--seed", "bob", "-o", path("ada.face.json")}).code, 0);
  EXPECT_TRUE(refusal().starts_with("/manifest-1-of-1.jsonl: is a part of another plan"));
  EXPECT_EQ(batch().out, "2 items: 2 drawn, 0 there already\n");
  EXPECT_EQ(join().code, 0);
}

TEST_F(JoinTest, ReadsFromAFolderOfItsOwnName) {
  plan(people(2));
  ASSERT_EQ(batch().code, 0);
  EXPECT_EQ(join("elsewhere").code, 1);
  EXPECT_EQ(run_mien({"join", path("none.json"), path("out")}).err,
            "mien: " + path("none.json") + ": cannot be read: No such file or directory\n");
}

}  // namespace
}  // namespace mien
