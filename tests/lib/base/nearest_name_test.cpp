#include "lib/base/nearest_name.h"

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("brow", "brow", 8), 0);
  EXPECT_EQ(edit_distance("brow", "brows", 8), 1);
  EXPECT_EQ(edit_distance("brow", "bow", 8), 1);
  EXPECT_EQ(edit_distance("brow", "brew", 8), 1);
  EXPECT_EQ(edit_distance("brow", "borw", 8), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting", 8), 3);
  EXPECT_EQ(edit_distance("", "abc", 8), 3);
}

TEST(EditDistance, StopsAboveTheMostAsked) {
  EXPECT_EQ(edit_distance("abcdef", "uvwxyz", 2), 3);
  EXPECT_EQ(edit_distance("a", "abcdefgh", 3), 4);
}

using Names = std::vector<std::string_view>;

/// The kinds of names that people mistype, as mien has them.
const Names kEmotions{"joy",   "left.joy", "right.joy", "sadness", "left.sadness",
                      "anger", "fear",     "disgust",   "surprise"};
const Names kMuscles{"inner-frontalis",
                     "left.inner-frontalis",
                     "outer-frontalis",
                     "corrugator",
                     "procerus",
                     "levator-palpebrae",
                     "levator-labii",
                     "nasalis",
                     "zygomaticus",
                     "left.zygomaticus",
                     "mentalis",
                     "risorius",
                     "orbicularis-oculi",
                     "orbicularis-oris",
                     "jaw"};
const Names kControls{"gaze.x",
                      "gaze.left.x",
                      "gaze.y",
                      "dilation",
                      "iris_size",
                      "lid_slant",
                      "blink",
                      "blink.left",
                      "bias",
                      "yaw",
                      "pitch",
                      "roll",
                      "muscle.jaw",
                      "emotion.joy",
                      "emotion.left.joy",
                      "emotion.sadness",
                      "emotion.anger",
                      "emotion.fear",
                      "emotion.disgust",
                      "emotion.surprise",
                      "viseme.aa",
                      "facs.AU1",
                      "facs.AU12",
                      "facs.left.AU12",
                      "palette/hair",
                      "palette/skin",
                      "head/points/0"};
const Names kOptions{
    "-h",       "--help",    "--style",      "--time",     "--clip",     "--pose",   "--morphs",
    "--basis",  "--weights", "--look-at",    "--blink",    "--unwrap",   "--bias",   "--emotion",
    "--muscle", "--arkit",   "--clamp",      "--set",      "-o",         "--output", "--size",
    "--fit",    "--region",  "--background", "--blend",    "--light",    "--dither", "--depth",
    "--effect", "--threads", "--memory",     "--progress", "--error-map"};
const Names kHeld{"head",  "ears",       "eyes",      "brows",     "nose",    "mouth",     "hair",
                  "beard", "moustache",  "glasses",   "headwear",  "jewel",   "clothes",   "skin",
                  "aid",   "hair_color", "iris",      "lashes",    "age",     "skin.tone", "jaw",
                  "chin",  "eye.tilt",   "brow.tilt", "brow.arch", "make_up", "folds",     "smile"};
const Names kStyles{"flat", "soft", "clay", "ink", "pictogram"};
const Names kArkit{"jawOpen", "eyeBlinkLeft", "mouthSmileLeft", "mouthPucker", "browInnerUp"};
const Names kCommands{"render", "check", "list", "animate", "sheet", "new", "studio", "chernoff"};

struct Meant {
  std::string_view wanted, name;
  const Names& names;
};

TEST(NearestName, KnowsWhatPeopleCallThings) {
  for (const auto& [wanted, name, names] :
       std::vector<Meant>{{"happy", "joy", kEmotions},
                          {"happiness", "joy", kEmotions},
                          {"smile", "joy", kEmotions},
                          {"left.smile", "left.joy", kEmotions},
                          {"sad", "sadness", kEmotions},
                          {"angry", "anger", kEmotions},
                          {"scared", "fear", kEmotions},
                          {"surprised", "surprise", kEmotions},
                          {"disgusted", "disgust", kEmotions},
                          {"Happy", "joy", kEmotions},
                          {"happy", "emotion.joy", kControls},
                          {"left.happy", "emotion.left.joy", kControls},
                          {"emotion.left.happy", "emotion.left.joy", kControls},
                          {"turn", "yaw", kControls},
                          {"head_turn", "yaw", kControls},
                          {"head.yaw", "yaw", kControls},
                          {"tilt", "roll", kControls},
                          {"nod", "pitch", kControls},
                          {"wink", "blink.left", kControls},
                          {"pupil", "dilation", kControls},
                          {"smile", "zygomaticus", kMuscles},
                          {"--happy", "--emotion joy", kOptions},
                          {"--yaw", "--set yaw=DEGREES", kOptions},
                          {"--viseme", "--set viseme.NAME=WEIGHT", kOptions},
                          {"--wink", "--set blink.left=1", kOptions},
                          {"--theme", "--style", kOptions},
                          {"--width", "--size", kOptions},
                          {"--bg", "--background", kOptions},
                          {"hat", "headwear", kHeld},
                          {"eyebrows", "brows", kHeld},
                          {"hair_colour", "hair_color", kHeld},
                          {"makeup", "make_up", kHeld},
                          {"icon", "pictogram", kStyles},
                          {"wink", "eyeBlinkLeft", kArkit},
                          {"draw", "render", kCommands},
                          {"gif", "animate", kCommands}})
    EXPECT_EQ(nearest_name(wanted, names), name) << wanted;
}

TEST(NearestName, FindsMistypedNames) {
  for (const auto& [wanted, name, names] :
       std::vector<Meant>{{"joi", "joy", kEmotions},
                          {"anegr", "anger", kEmotions},
                          {"surprize", "surprise", kEmotions},
                          {"disgist", "disgust", kEmotions},
                          {"saddness", "sadness", kEmotions},
                          {"joi", "emotion.joy", kControls},
                          {"disgsut", "emotion.disgust", kControls},
                          {"blnk", "blink", kControls},
                          {"lbink", "blink", kControls},
                          {"dilatoin", "dilation", kControls},
                          {"gaze.z", "gaze.x", kControls},
                          {"gaze.lft.x", "gaze.left.x", kControls},
                          {"irissize", "iris_size", kControls},
                          {"Lid-Slant", "lid_slant", kControls},
                          {"palette.hair", "palette/hair", kControls},
                          {"zygomatic", "zygomaticus", kMuscles},
                          {"zigomaticus", "zygomaticus", kMuscles},
                          {"oris", "orbicularis-oris", kMuscles},
                          {"corugator", "corrugator", kMuscles},
                          {"ment", "mentalis", kMuscles},
                          {"--emotoin", "--emotion", kOptions},
                          {"--outptu", "--output", kOptions},
                          {"--theads", "--threads", kOptions},
                          {"--sise", "--size", kOptions},
                          {"--progess", "--progress", kOptions},
                          {"-size", "--size", kOptions},
                          {"--backgruond", "--background", kOptions},
                          {"mustache", "moustache", kHeld},
                          {"galsses", "glasses", kHeld},
                          {"tone", "skin.tone", kHeld},
                          {"pictogramm", "pictogram", kStyles},
                          {"jaw_open", "jawOpen", kArkit},
                          {"mouthsmileleft", "mouthSmileLeft", kArkit},
                          {"rendr", "render", kCommands},
                          {"chernof", "chernoff", kCommands}})
    EXPECT_EQ(nearest_name(wanted, names), name) << wanted;
}

TEST(NearestName, SaysNothingRatherThanAWrongName) {
  for (const auto& [wanted, names] : std::vector<std::pair<std::string_view, const Names&>>{
           // What people call something that this list does not have.
           {"yaw", kMuscles},
           {"yaw", kHeld},
           {"style", kControls},
           {"viseme", kEmotions},
           {"wink", kMuscles},
           {"sad", kMuscles},
           // Two names have it.
           {"frontalis", kMuscles},
           {"tilt", kHeld},
           // Another number is another name.
           {"AU13", kControls},
           {"facs.AU2", kControls},
           {"head/points/1", kControls},
           // What is right in front of a name does not make it near.
           {"emotion.banana", kControls},
           {"emotion.left.banana", kControls},
           {"muscle.left.frontalis", kControls}})
    EXPECT_EQ(nearest_name(wanted, names), "") << wanted;
  for (const std::string_view word :
       {"elephant", "paper",  "mouse",   "river",   "window", "guitar", "planet", "castle",
        "winter",   "doctor", "bicycle", "kitchen", "garden", "silver", "letter", "engine",
        "monkey",   "bridge", "dragon",  "rocket",  "pencil", "cotton", "music",  "forest",
        "bread",    "cloud",  "money",   "train",   "plant",  "house",  "water",  "horse",
        "chair",    "phone",  "clock",   "tiger",   "apple",  "sugar",  "ocean",  "sport",
        "april",    "lemon",  "north",   "piano",   "queen",  "robot",  "salad",  "truck",
        "uncle",    "wheel",  "yacht",   "zebra",   "agent",  "camera", "donkey", "factory",
        "hammer",   "island", "market",  "needle",  "tunnel", "valley", "q"})
    for (const Names* names :
         {&kEmotions, &kMuscles, &kControls, &kOptions, &kHeld, &kStyles, &kArkit, &kCommands})
      EXPECT_EQ(nearest_name(word, *names), "") << word;
}

TEST(NearestName, KnownWordsMayBeMistypedInListsOfOthers) {
  EXPECT_EQ(nearest_name("size", {"who", "sise"}), "sise");
  EXPECT_EQ(nearest_name("happy", {"hapy"}), "hapy");
}

TEST(NearestName, TakesAnyText) {
  EXPECT_EQ(nearest_name("", {"gaze.x"}), "");
  EXPECT_EQ(nearest_name("-", {"gaze.x", "-"}), "");
  EXPECT_EQ(nearest_name("...", {"gaze.x"}), "");
  EXPECT_EQ(nearest_name("/", {"", "gaze.x"}), "");
  EXPECT_EQ(nearest_name("happy", {}), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'x'), {"gaze.x"}), "");
}

TEST(UnknownName, IsASentence) {
  EXPECT_EQ(unknown_name("control", "blnk", {"blink"}),
            "no control named \"blnk\"; did you mean \"blink\"?");
  EXPECT_EQ(unknown_name("control", "what", {"blink"}), "no control named \"what\"");
}

TEST(UnknownName, ListsAFewWhereNothingIsNear) {
  EXPECT_EQ(unknown_name("style", "cartoon", {"ink", "peep", "soft"}),
            "no style named \"cartoon\"; there are \"ink\", \"peep\" and \"soft\"");
  EXPECT_EQ(unknown_name("style", "cartoon", {"a\nb", "c"}),
            "no style named \"cartoon\"; there are \"a\\x0Ab\" and \"c\"");
  // The most that are listed, and one more; and the longest sentence.
  std::vector<std::string_view> many(12, "ink");
  EXPECT_NE(unknown_name("style", "cartoon", many).find("; there are"), std::string::npos);
  many.push_back("ink");
  EXPECT_EQ(unknown_name("style", "cartoon", many), "no style named \"cartoon\"");
  const std::string longer(60, 'x');
  EXPECT_NE(unknown_name("style", "cartoon", {longer, longer}).find(longer), std::string::npos);
  EXPECT_EQ(unknown_name("style", "cartoon", {longer, longer, longer}),
            "no style named \"cartoon\"");
}

}  // namespace
}  // namespace mien
