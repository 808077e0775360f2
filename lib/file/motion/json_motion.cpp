// Motions as JSON: frames of shapes (ARKit, MediaPipe), one in each line or in a list, and what speech programs write
// (Rhubarb's cues, Azure's events and frames).

#include "head_matrix_private.h"
#include "lib/file/json/frame_members.h"
#include "motion_reader_private.h"
#include "speech_builder_private.h"
#include "take_builder_private.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_map>

namespace mien {
namespace {

constexpr double kAzureRate = 60;    ///< [1/s] of its frames
constexpr double kAzureTicks = 1e7;  ///< [1/s] of its events

/// The order of the 55 numbers of Azure's frames.
constexpr std::string_view kAzureNames[] = {
    "eyeBlinkLeft",      "eyeLookDownLeft",    "eyeLookInLeft",
    "eyeLookOutLeft",    "eyeLookUpLeft",      "eyeSquintLeft",
    "eyeWideLeft",       "eyeBlinkRight",      "eyeLookDownRight",
    "eyeLookInRight",    "eyeLookOutRight",    "eyeLookUpRight",
    "eyeSquintRight",    "eyeWideRight",       "jawForward",
    "jawLeft",           "jawRight",           "jawOpen",
    "mouthClose",        "mouthFunnel",        "mouthPucker",
    "mouthLeft",         "mouthRight",         "mouthSmileLeft",
    "mouthSmileRight",   "mouthFrownLeft",     "mouthFrownRight",
    "mouthDimpleLeft",   "mouthDimpleRight",   "mouthStretchLeft",
    "mouthStretchRight", "mouthRollLower",     "mouthRollUpper",
    "mouthShrugLower",   "mouthShrugUpper",    "mouthPressLeft",
    "mouthPressRight",   "mouthLowerDownLeft", "mouthLowerDownRight",
    "mouthUpperUpLeft",  "mouthUpperUpRight",  "browDownLeft",
    "browDownRight",     "browInnerUp",        "browOuterUpLeft",
    "browOuterUpRight",  "cheekPuff",          "cheekSquintLeft",
    "cheekSquintRight",  "noseSneerLeft",      "noseSneerRight",
    "tongueOut",         "headRoll",           "leftEyeRoll",
    "rightEyeRoll"};
static_assert(std::size(kAzureNames) == 55);

FaceLimits json_limits(const MotionLimits& limits) {
  FaceLimits most;
  most.bytes = std::min<std::size_t>(limits.bytes, std::numeric_limits<std::uint32_t>::max());
  most.values = 8'000'000;
  most.magnitude = 1e300;
  return most;
}

class JsonMotionReader final : public MotionReader {
 public:
  explicit JsonMotionReader(const MotionSource& source)
      : source_(source),
        json_(json_limits(source.limits)),
        take_(source.name, source.limits),
        speech_(source.name, source.limits) {}

  /// A first line that is a whole value, with others after it, is one of many; else the file is one value.
  Expected<Done> take(const FileLine& line) override {
    if (lines_) {
      if (without_blanks(line.text).empty()) return Done{};
      return take_text(line.text, line.number);
    }
    if (whole_.empty()) first_line_ = line.number;
    if (!whole_.empty() && !tried_ && !without_blanks(line.text).empty()) {
      tried_ = true;
      lines_ = JsonTree::read(whole_, source_.name, json_, first_line_).has_value();
      if (lines_) {
        if (auto first = take_text(whole_, first_line_); !first) return first;
        return take_text(line.text, line.number);
      }
    }
    if (whole_.size() + line.text.size() >= json_.bytes)
      return Error{source_.name,
                   fmt::format("longer than {} bytes (limit: bytes); a frame in each line is read "
                               "one by one",
                               json_.bytes)};
    whole_ += line.text;
    whole_ += '\n';
    return Done{};
  }

  Expected<Motion> finish(std::vector<Error>& told) override {
    if (!lines_)
      if (auto read = take_text(whole_, first_line_); !read) return read.error();
    if (!ignored_.empty()) {
      std::string text = "names that move no face are left out:";
      for (const std::string& name : ignored_) text += " " + in_quotes(name);
      told.push_back({source_.name, std::move(text)});
    }
    if (frames_ > 0) return take_.finish(told);
    if (sounds_ > 0) return speech_.finish(told);
    return take_.finish(told);
  }

 private:
  Expected<Done> take_text(std::string_view text, std::size_t line) {
    const auto tree = JsonTree::read(text, source_.name, json_, line);
    if (!tree) return tree.error();
    const Reading in(*tree, json_, nullptr);
    try {
      take_value(in, tree->root());
    } catch (const Refusal& refusal) {
      return refusal.error;
    }
    return Done{};
  }

  /// Passes an error on, out of the reading of a value.
  static void must(Expected<Done> done) {
    if (!done) throw Refusal{std::move(done).error()};
  }

  void take_value(const Reading& in, const JsonNode& node) {
    if (node.kind == JsonKind::array) return take_list(in, node);
    in.expect(node, JsonKind::object);
    if (const JsonNode* frames = in.find(node, "frames")) {
      for (const char* key : {"fps", "frameRate", "frame_rate", "rate"})
        if (const JsonNode* rate = in.find(node, key)) fps_ = positive(in, *rate);
      in.expect(*frames, JsonKind::array);
      return in.for_each(*frames, [&](const JsonNode& child, int) { take_one(in, child); });
    }
    take_one(in, node);
  }

  /// Frames or events; or the shapes of one frame, as MediaPipe lists them.
  void take_list(const Reading& in, const JsonNode& list) {
    const JsonNode* first = in.tree.first(list);
    if (first && (in.find(*first, "categoryName") || in.find(*first, "category_name")))
      return take_frame(in, list);
    in.for_each(list, [&](const JsonNode& child, int) { take_one(in, child); });
  }

  void take_one(const Reading& in, const JsonNode& node) {
    if (node.kind == JsonKind::array) return take_frame(in, node);
    in.expect(node, JsonKind::object);
    if (const JsonNode* cues = in.find(node, "mouthCues")) return take_cues(in, *cues);
    if (const JsonNode* shapes = find_of(in, node, {"BlendShapes", "blendShapes"});
        shapes && shapes->kind == JsonKind::array && first_is_list(in, *shapes))
      return take_azure_frames(in, node, *shapes);
    const JsonNode* id = find_of(in, node, {"viseme_id", "visemeId", "VisemeId", "visemeID"});
    if (id) return take_azure_event(in, node, *id);
    take_frame(in, node);
  }

  static const JsonNode* find_of(const Reading& in, const JsonNode& node,
                                 std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys)
      if (const JsonNode* found = in.find(node, key)) return found;
    return nullptr;
  }

  static bool first_is_list(const Reading& in, const JsonNode& list) {
    const JsonNode* first = in.tree.first(list);
    return first && first->kind == JsonKind::array;
  }

  static double positive(const Reading& in, const JsonNode& node) {
    const double number = in.number(node);
    if (!(number > 0 && number <= 1e6))
      in.refuse(node, fmt::format("a rate of frames is above 0, got {}", number));
    return number;
  }

  /// {"mouthCues": [{"start": 0, "end": 0.3, "value": "X"}, …]}
  void take_cues(const Reading& in, const JsonNode& cues) {
    in.expect(cues, JsonKind::array);
    speech_.alphabet = PhoneAlphabet::rhubarb;
    in.for_each(cues, [&](const JsonNode& cue, int) {
      in.expect(cue, JsonKind::object);
      const double begin = in.number(in.need(cue, "start"));
      std::optional<double> end;
      if (const JsonNode* node = in.find(cue, "end")) end = in.number(*node);
      const std::string_view value = in.string(in.need(cue, "value"));
      must(speech_.add(begin, end, value, place(in, cue)));
      ++sounds_;
    });
  }

  /// {"audio_offset": 500000, "viseme_id": 19, "animation": "…"}; the animation is a text with frames.
  void take_azure_event(const Reading& in, const JsonNode& node, const JsonNode& id) {
    const JsonNode* frames = find_of(in, node, {"animation", "Animation"});
    if (frames && frames->kind == JsonKind::string && !in.string(*frames).empty()) {
      const JsonTree inner = must_tree(in, *frames);
      const Reading inside(inner, json_, nullptr);
      return take_value(inside, inner.root());
    }
    const JsonNode* offset =
        find_of(in, node, {"audio_offset", "audioOffset", "AudioOffset", "offset", "Offset"});
    if (!offset) offset = &in.need(node, "audio_offset");
    const double number = in.number(id);
    const auto meaning = azure_viseme(number);
    if (!meaning) in.refuse(id, fmt::format("ids of visemes go from 0 to 21, got {}", number));
    must(speech_.add(in.number(*offset) / kAzureTicks, {}, *meaning, place(in, node)));
    ++sounds_;
  }

  JsonTree must_tree(const Reading& in, const JsonNode& text) const {
    auto tree = JsonTree::read(in.string(text), source_.name, json_);
    if (!tree) in.refuse(text, "holds no JSON: " + tree.error().what);
    return *std::move(tree);
  }

  /// {"FrameIndex": 0, "BlendShapes": [[55 numbers], …]}
  void take_azure_frames(const Reading& in, const JsonNode& node, const JsonNode& shapes) {
    double frame = azure_frame_;
    if (const JsonNode* index = find_of(in, node, {"FrameIndex", "frameIndex", "frame_index"}))
      frame = in.number(*index);
    in.for_each(shapes, [&](const JsonNode& row, int) {
      in.expect(row, JsonKind::array);
      if (row.count != int(std::size(kAzureNames)))
        in.refuse(row,
                  fmt::format("expected {} numbers, got {}", std::size(kAzureNames), row.count));
      must(take_.begin_row(frame / kAzureRate, place(in, row)));
      in.for_each(row, [&](const JsonNode& value, int i) {
        set(kAzureNames[std::size_t(i)], in.number(value));
      });
      ++frame, ++frames_;
    });
    azure_frame_ = frame;
  }

  void take_frame(const Reading& in, const JsonNode& node) {
    const double time = time_of(in, node);
    ++frames_;
    if (is_without_face(in, node)) return take_.skip_row();
    must(take_.begin_row(time, place(in, node)));
    std::vector<FrameMember> beside;
    for (const auto& [name, value] : frame_members(in, node, &beside))
      if (!is_time_key(name)) set(name, in.number(*value));
    for (const auto& [name, value] : beside)
      if (value->kind == JsonKind::number && !is_time_key(name)) set(name, in.number(*value));
    if (const JsonNode* matrices =
            find_of(in, node, {"facialTransformationMatrixes", "facial_transformation_matrixes"}))
      take_matrix(in, *matrices);
  }

  static bool is_time_key(std::string_view key) {
    constexpr std::string_view kKeys[] = {"time",         "timestamp", "timestampMs",
                                          "timestamp_ms", "t",         "timecode"};
    return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
  }

  double time_of(const Reading& in, const JsonNode& node) {
    if (const JsonNode* time = find_of(in, node, {"time", "t"})) return in.number(*time);
    if (const JsonNode* time = find_of(in, node, {"timestampMs", "timestamp_ms"})) {
      take_.clock = TakeClock::milliseconds;
      return in.number(*time);
    }
    if (const JsonNode* time = in.find(node, "timestamp")) {
      take_.clock = TakeClock::ticking;
      return in.number(*time);
    }
    if (fps_ > 0) return double(frames_) / fps_;
    if (frames_ > 0)
      in.refuse(node,
                "the frame has no time: expected \"time\", \"timestamp\" or "
                "\"timestamp_ms\", or \"fps\" beside \"frames\"");
    return 0;
  }

  static bool is_without_face(const Reading& in, const JsonNode& node) {
    if (node.kind != JsonKind::object) return false;
    for (const char* key : {"isTracked", "is_tracked", "success"})
      if (const JsonNode* seen = in.find(node, key))
        if ((seen->kind == JsonKind::boolean || seen->kind == JsonKind::number) &&
            !truth(in, *seen))
          return true;
    const JsonNode* faces = find_of(in, node, {"faceBlendshapes", "face_blendshapes"});
    return faces && faces->kind == JsonKind::array && faces->count == 0;
  }

  static bool truth(const Reading& in, const JsonNode& node) {
    return node.kind == JsonKind::boolean ? in.boolean(node) : in.number(node) != 0;
  }

  void take_matrix(const Reading& in, const JsonNode& matrices) {
    const auto turn = head_turn_of(in, matrices);
    if (!turn) return;
    const std::pair<const char*, double> angles[] = {
        {"yaw", turn->yaw}, {"pitch", turn->pitch}, {"roll", turn->roll}};
    for (const auto& [channel, degrees] : angles) {
      const TakeTarget target{channel, TakeUnit::degrees, 1, false, true};
      take_.set(take_.column(target), degrees, target);
    }
  }

  using Targets = std::vector<std::pair<std::size_t, TakeTarget>>;

  const Targets& targets(std::string_view name) {
    const auto [found, fresh] = targets_.try_emplace(std::string(name));
    if (!fresh) return found->second;
    for (const TakeTarget& target : take_targets(name))
      found->second.emplace_back(take_.column(target), target);
    constexpr std::size_t kMostNamed = 5;
    if (found->second.empty() && !is_beside_the_face(name) && ignored_.size() < kMostNamed)
      ignored_.push_back(std::string(name));
    return found->second;
  }

  void set(std::string_view name, double value) {
    for (const auto& [column, target] : targets(name)) take_.set(column, value, target);
  }

  /// Places are searched in the text: only errors ask for them.
  static Place place(const Reading& in, const JsonNode& node) {
    return [&] { return in.tree.where(node); };
  }

  MotionSource source_;
  FaceLimits json_;
  TakeBuilder take_;
  SpeechBuilder speech_;
  std::string whole_;
  std::size_t first_line_ = 1;
  bool tried_ = false, lines_ = false;
  double fps_ = 0, azure_frame_ = 0;
  std::size_t frames_ = 0, sounds_ = 0;
  std::unordered_map<std::string, Targets> targets_;
  std::vector<std::string> ignored_;
};

}  // namespace

std::unique_ptr<MotionReader> json_motion_reader(const MotionSource& source) {
  return std::make_unique<JsonMotionReader>(source);
}

}  // namespace mien
