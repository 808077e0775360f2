#include "lib/base/synonyms.h"

#include <array>

namespace mien {
namespace {

/// Words in one line, with spaces between, and their meanings, as many as there are.
struct Synonyms {
  std::string_view words;
  std::array<std::string_view, 6> means;
};

constexpr Synonyms kSynonyms[] = {
    // Feelings.
    {"happy happiness laugh laughing glad cheerful joyful joy",
     {"joy", "--emotion joy", "happy", "smile"}},
    {"smile smiling smiley grin",
     {"joy", "--emotion joy", "happy", "smile", "--hold smile=NUMBER", "zygomaticus"}},
    {"sad unhappy sorrow sorrowful cry crying grief gloomy sadness",
     {"sadness", "--emotion sadness", "sad"}},
    {"angry mad furious rage anger", {"anger", "--emotion anger", "angry"}},
    {"scared afraid frightened fearful terrified terror fright fear", {"fear", "--emotion fear"}},
    {"surprised shocked astonished astonishment amazed surprise",
     {"surprise", "--emotion surprise", "surprised"}},
    {"disgusted revolted disgust", {"disgust", "--emotion disgust"}},
    {"expression expressions feeling feelings mood emotions emotion",
     {"emotion", "emotions", "--emotion", "--emotions"}},
    // The head, the eyes, the mouth.
    {"yaw turn headturn headyaw yawangle azimuth",
     {"yaw", "head.yaw", "--yaw", "--set yaw=DEGREES", "set: yaw"}},
    {"pitch nod headnod headpitch",
     {"pitch", "head.pitch", "--pitch", "--set pitch=DEGREES", "set: pitch"}},
    {"roll tilt lean headtilt headroll", {"roll", "head.roll", "--set roll=DEGREES", "set: roll"}},
    {"wink winking",
     {"blink.left", "blinkLeft", "eyeBlinkLeft", "AU46", "--set blink.left=1", "set: blink.left"}},
    {"blink blinking closeeyes eyesclosed closedeyes", {"blink", "--blink", "AU45", "set: blink"}},
    {"gaze look lookat eyedirection", {"gaze.x", "lookAt", "look_at", "--look-at"}},
    {"pupil pupils pupilsize", {"dilation", "--set dilation=RATIO"}},
    {"openmouth mouthopen jawopen jaw", {"jaw", "jawOpen", "AU26", "--muscle jaw"}},
    {"kiss pucker", {"mouthPucker", "AU18", "orbicularis-oris"}},
    // Sets of names.
    {"viseme visemes phoneme phonemes lipsync mouthshape",
     {"viseme", "visemes", "--set viseme.NAME=WEIGHT"}},
    {"facs au actionunit actionunits", {"facs", "--set facs.NAME=WEIGHT"}},
    {"vrm", {"--set vrm.NAME=WEIGHT"}},
    {"blendshape blendshapes shapekeys arkitframe", {"arkit", "--arkit"}},
    {"muscles", {"muscle", "--muscle"}},
    // Parts and numbers of people.
    {"hair hairstyle haircut", {"hair", "--hold hair=NAME"}},
    {"haircolor", {"hair_color", "--hold hair_color=NAME"}},
    {"hat hats headgear helmet headwear", {"headwear", "--hold headwear=NAME"}},
    {"eyebrow eyebrows brow", {"brows", "--hold brows=NAME"}},
    {"eyelash eyelashes", {"lashes", "--hold lashes=NAME"}},
    {"eyecolor eyecolors", {"iris", "--hold iris=NAME"}},
    {"spectacles specs eyeglasses sunglasses glasses", {"glasses", "--hold glasses=NAME"}},
    {"mustache moustache", {"moustache", "--hold moustache=NAME"}},
    {"facialhair whiskers beard", {"beard", "--hold beard=NAME"}},
    {"earring earrings jewelry jewellery piercing", {"jewel", "--hold jewel=NAME"}},
    {"shirt clothing outfit dress clothes", {"clothes", "--hold clothes=NAME"}},
    {"skincolor complexion skintone", {"skin.tone", "--hold skin.tone=NUMBER"}},
    {"wrinkle wrinkles", {"folds", "--hold folds=NUMBER"}},
    {"lipstick cosmetics makeup", {"make_up", "--hold make_up=NUMBER"}},
    {"age old young", {"age", "--hold age=YEARS"}},
    // Styles.
    {"sketch lineart linework drawing outlined", {"ink", "peep"}},
    {"brush doodle monochrome blackandwhite notion", {"peep", "ink"}},
    {"icon icons symbol emoji", {"pictogram"}},
    {"memoji plastic toy lit glossy clay", {"vinyl"}},
    {"style facestyle theme paintstyle drawstyle artstyle", {"style", "--style", "face-style"}},
    // Options.
    {"width height resolution dimensions size px", {"--size", "size"}},
    {"bg backgroundcolor", {"--background", "background"}},
    {"out outfile outputfile save", {"--output"}},
    {"jobs cores workers parallel", {"--threads", "threads"}},
    {"bits bitdepth dtype", {"--depth", "depth"}},
    {"seconds moment", {"--time", "time"}},
    {"framerate", {"--fps", "fps"}},
    {"crop", {"--region", "region"}},
    {"word username", {"--seed", "seed"}},
    {"cols", {"--columns", "columns"}},
    {"margin padding spacing", {"--gap", "gap"}},
    {"ram mem", {"--memory"}},
    {"quiet silent", {"--progress none"}},
    {"morphtarget morphtargets", {"--pose", "poses"}},
    // Commands.
    {"draw paint convert", {"render"}},
    {"create make generate random", {"new"}},
    {"speak talk tts speech espeak", {"say"}},
    {"film video movie gif mp4", {"animate"}},
    {"info names show inspect", {"list"}},
    {"validate lint verify", {"check"}},
    {"grid crowd contactsheet", {"sheet"}},
    {"edit editor gui", {"studio"}},
    {"http server api", {"serve"}},
    {"table csv", {"chernoff"}},
    {"experiment", {"stimuli"}},
};

bool lists_word(std::string_view words, std::string_view wanted) {
  while (!words.empty()) {
    const std::size_t space = words.find(' ');
    if (words.substr(0, space) == wanted) return true;
    words.remove_prefix(space == std::string_view::npos ? words.size() : space + 1);
  }
  return false;
}

}  // namespace

std::span<const std::string_view> meanings(std::string_view word) {
  for (const Synonyms& line : kSynonyms) {
    if (!lists_word(line.words, word)) continue;
    std::size_t count = 0;
    while (count < line.means.size() && !line.means[count].empty()) ++count;
    return {line.means.data(), count};
  }
  return {};
}

}  // namespace mien
