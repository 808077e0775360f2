// Plans that mean nothing: a sentence with a place, before anything is drawn.

#include <chrono>

#include "tests/tools/mien/batch/batch_fixture.h"

namespace mien {
namespace {

struct WrongPlan {
  std::string jobs, where, sentence;
};

class WrongPlanTest : public BatchTest {
 protected:
  static std::string with(const std::string& each, const std::string& output = "{a}{b}.png") {
    return R"({"run": ["render", "toon"], "each": )" + each + R"(, "output": ")" + output + "\"}";
  }
};

TEST_F(WrongPlanTest, IsRefusedByASentenceWithAPlace) {
  const std::string toon = R"("run": ["render", "toon"])";
  for (
      const WrongPlan& wrong : std::vector<WrongPlan>{
          {"", "/jobs", "expected 1 to 10000 jobs"},
          {"{" + toon + "}", "/jobs/0", R"("output" is missing)"},
          {R"({"run": [], "output": "a.png"})", "/jobs/0/run",
           "expected a command and its arguments, 1 to 1000 words"},
          {R"({"run": ["rendr", "toon"], "output": "a.png"})", "/jobs/0/run/0",
           R"(no command for a plan named "rendr"; did you mean "render"?)"},
          {R"({"run": ["serve"], "output": "a.png"})", "/jobs/0/run/0",
           R"(no command for a plan named "serve")"},
          {R"({"run": ["render", "toon", "-o", "b.png"], "output": "a.png"})", "/jobs/0/run/2",
           R"("-o" is not for a plan: "output" names the file)"},
          {R"({"run": ["render", "toon", "--output=b.png"], "output": "a.png"})", "/jobs/0/run/2",
           R"("--output=b.png" is not for a plan: "output" names the file)"},
          {R"({"run": ["render", "toon", "--error-map", "b.png"], "output": "a.png"})",
           "/jobs/0/run", "an item is one file: --error-map writes another"},
          {R"({"run": ["render", "toon", "--siz", "3"], "output": "a.png"})", "/jobs/0/run",
           R"(no option named "--siz"; did you mean "--size"?)"},
          {"{" + toon + R"(, "output": "a.png", "evry": {}})", "/jobs/0/evry",
           R"(no key named "evry")"},
          {with(R"({"a": [1], "b": {"poeple": 3}})"), "/jobs/0/each/b/poeple",
           R"(named "poeple"; did you mean "people"?)"},
          {with(R"({"a": [1], "b": []})"), "/jobs/0/each/b", "no value is named"},
          {with(R"({"a": [1], "b-": [2]})"), "/jobs/0/each/b-",
           "a name has letters, digits and _ alone"},
          {with(R"({"a": [1], "thousand": [2]})"), "/jobs/0/each/thousand",
           "this name is built in: it counts items by thousands"},
          {with(R"({"a": [1]})"), "/jobs/0/output", R"(no value named "b")"},
          {R"({"run": ["render", "{hwo}"], "each": {"who": {"people": 1}}, "output": "{who}.png"})",
           "/jobs/0/run/1", R"(no value named "hwo"; did you mean "who"?)"},
          {with(R"({"a": {"from": 5, "to": 3}, "b": [1]})"), "/jobs/0/each/a/to",
           "expected a whole number from 5"},
          {with(R"({"a": {"people": 1.5}, "b": [1]})"), "/jobs/0/each/a/people",
           "expected a whole number from 1"},
          {with(R"({"a": {"frames": "0-9"}, "b": [1]})"), "/jobs/0/each/a",
           R"(frames are of "animate", not of "render")"},
          {with(R"({"a": {"regions": [2, 2]}, "b": [1]})"), "/jobs/0/each/b",
           R"("a" has pieces of one file, so it is the last name)"},
          {with(R"({"a": [1], "b": {"regions": [0, 2]}})"), "/jobs/0/each/b/regions",
           "expected columns and rows, 1 to 1000"},
          {R"({"run": ["render", "toon", "--size", "5"], "each": {"a": {"regions": [9, 1]}},
                "output": "{a}.png"})",
           "/jobs/0/run", "5 x 5 pixels cannot be cut into 9 x 1 regions"},
          {R"({"run": ["render", "none.json"], "each": {"a": {"regions": [2, 1]}},
                "output": "{a}.png"})",
           "/jobs/0/run", "none.json: cannot be read: No such file or directory"},
          {"{" + toon + R"(, "each": {"a": [1]}, "output": "{a}.png", "join": "b.png"})",
           "/jobs/0/join", R"(needs pieces: the last name of "each" has "regions")"},
          {"{" + toon +
               R"(, "each": {"a": {"regions": [2, 2]}}, "output": "{a}.png", "join": "{a}.tif"})",
           "/jobs/0/join", "{a} differs from piece to piece"},
          {R"({"run": ["animate", "toon"], "each": {"f": {"frames": "0-9"}}, "output": "f.png"})",
           "/jobs/0/output", "expected {f} once, for the frame's number"},
          {R"({"run": ["stimuli", "a.json"], "output": "a.png"})", "/jobs/0/run",
           "stimuli has no other words"}}) {
    plan(wrong.jobs);
    const Ran ran = batch();
    EXPECT_NE(ran.code, 0) << wrong.jobs;
    EXPECT_TRUE(ran.err.starts_with("mien: " + path("plan.json") + ":")) << ran.err;
    EXPECT_NE(ran.err.find(": " + wrong.where + ": "), std::string::npos) << wrong.where << "\n"
                                                                          << ran.err;
    EXPECT_NE(ran.err.find(wrong.sentence), std::string::npos) << wrong.sentence << "\n" << ran.err;
  }
}

TEST_F(WrongPlanTest, IsRefusedForTheNamesOfItsFiles) {
  for (const WrongPlan& wrong : std::vector<WrongPlan>{
           {with(R"({"a": ["x", "y"], "b": ["X"]})", "{a}.png") + "," +
                with(R"({"a": ["Y"], "b": [1]})", "{a}.png"),
            "/jobs/1/output",
            R"("y.png" and "Y.png" differ by case only, and some file systems take them for one)"},
           {with(R"({"a": [1, 2], "b": [1]})", "{b}.png"), "/jobs/0/output",
            R"(two items are called "1.png"; every name of "each" belongs in it)"},
           {with(R"({"a": [1, 11], "b": [1, 11]})"), "/jobs/0/output",
            R"(two items are called "111.png")"},
           {with(R"({"a": [1], "b": [2]})", "/tmp/{a}.png"), "/jobs/0/output",
            R"("/tmp/1.png" must lead into the folder, not begin with a slash)"},
           {with(R"({"a": [".."], "b": [2]})", "{a}/{b}.png"), "/jobs/0/output",
            R"("../2.png" must lead into the folder)"},
           {with(R"({"a": [""], "b": [2]})", "x/{a}"), "/jobs/0/output",
            R"("x/" is no file's name)"},
           {with(R"({"a": [1], "b": [2]})", "manifest-{a}-of-{b}.jsonl"), "/jobs/0/output",
            R"("manifest-1-of-2.jsonl" is what a part's record is called)"}}) {
    plan(wrong.jobs);
    const Ran ran = batch();
    EXPECT_EQ(ran.code, 1) << wrong.jobs;
    EXPECT_NE(ran.err.find(": " + wrong.where + ": " + wrong.sentence), std::string::npos)
        << wrong.sentence << "\n"
        << ran.err;
  }
}

// Ten thousand times ten thousand times ten thousand: counted, not made.
TEST_F(WrongPlanTest, IsRefusedQuicklyForATrillionItems) {
  plan(with(
      R"({"a": {"people": 10000}, "b": {"from": 1, "to": 10000}, "c": {"from": 0, "to": 9999}})",
      "{a}{b}{c}.png"));
  const auto asked = std::chrono::steady_clock::now();
  const Ran ran = batch();
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(5));
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("/jobs/0/each: 10000 × 10000 × 10000 = 1000000000000 items; a plan has "
                         "10000000 at most\n"),
            std::string::npos)
      << ran.err;
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(WrongPlanTest, IsRefusedWhereItIsNoPlan) {
  write_text(folder_ / "plan.json", R"({"format": "mien-stimuli", "format_version": 1})");
  EXPECT_NE(batch().err.find("expected \"mien-batch\", got \"mien-stimuli\""), std::string::npos);
  write_text(folder_ / "plan.json", "{");
  EXPECT_EQ(batch().code, 1);
}

}  // namespace
}  // namespace mien
