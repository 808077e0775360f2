// The clips of a face file: curves in time for controls.

#include "face_draft_private.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace mien {
namespace {

constexpr std::array<std::string_view, 6> kEases{"linear", "step", "smooth",
                                                 "in",     "out",  "overshoot"};  // as enum Ease

/// A whole number from 0 to 2^32 − 1; errors call it `what`.
std::uint32_t read_count(const Reading& in, const JsonNode& node, std::string_view what) {
  const double number = in.number(node);
  if (!(number >= 0 && number <= 4294967295.0 && number == std::floor(number)))
    in.refuse(node,
              fmt::format("a {} is a whole number from 0 to 4294967295, got {}", what, number));
  return std::uint32_t(number);
}

/// "seed": NUMBER; 0 if it is not there.
std::uint32_t optional_seed(const Reading& in, const JsonNode& node) {
  const JsonNode* seed = in.find(node, "seed");
  return seed ? read_count(in, *seed, "seed") : 0;
}

SineCurve read_sine(Reading& in, const JsonNode& node) {
  in.expect_object(node, {"amplitude", "frequency", "phase", "offset", "absolute"});
  SineCurve sine;
  sine.amplitude = in.number(in.need(node, "amplitude"));
  sine.frequency = in.number(in.need(node, "frequency"));
  if (const JsonNode* phase = in.find(node, "phase")) sine.phase = in.number(*phase);
  if (const JsonNode* offset = in.find(node, "offset")) sine.offset = in.number(*offset);
  if (const JsonNode* absolute = in.find(node, "absolute")) sine.absolute = in.boolean(*absolute);
  return sine;
}

/// [time, value] or [time, value, "ease"].
CurveKey read_key(const Reading& in, const JsonNode& node, Ease ease) {
  in.expect(node, JsonKind::array);
  if (node.count != 2 && node.count != 3)
    in.refuse(node, fmt::format("expected [time, value] or [time, value, \"ease\"], got {} values",
                                node.count));
  const JsonNode& time = *in.tree.first(node);
  const JsonNode& value = *in.tree.next(time);
  if (const JsonNode* own = in.tree.next(value)) ease = Ease(in.word(*own, "ease", kEases));
  return {in.number(time), in.number(value), ease};
}

/// A number that must not be negative; 0 if it is not there.
double optional_time(const Reading& in, const JsonNode& node, std::string_view key) {
  const JsonNode* found = in.find(node, key);
  if (!found) return 0;
  const double time = in.number(*found);
  if (!(time >= 0)) in.refuse(*found, fmt::format("a {} must not be negative, got {}", key, time));
  return time;
}

double read_period(const Reading& in, const JsonNode& node) {
  const double period = in.number(node);
  if (!(period > 0)) in.refuse(node, fmt::format("a period must be positive, got {}", period));
  return period;
}

void read_each_key(const Reading& in, const JsonNode& keys, Ease ease, KeyCurve& curve) {
  in.expect(keys, JsonKind::array);
  if (keys.count == 0) in.refuse(keys, "expected at least one key");
  in.for_each(keys, [&](const JsonNode& child, int) {
    const CurveKey key = read_key(in, child, ease);
    if (!curve.keys.empty() && !(key.time > curve.keys.back().time))
      in.refuse(child, "the times of keys must rise");
    if (curve.period > 0 && !(key.time >= 0 && key.time <= curve.period))
      in.refuse(child, fmt::format("the times of keys must lie in the period, from 0 to {}",
                                   curve.period));
    curve.keys.push_back(key);
  });
}

KeyCurve read_keys(Reading& in, const JsonNode& node) {
  in.expect_object(node, {"keys", "period", "ease", "offset", "jitter", "seed"}, "curve");
  KeyCurve curve;
  Ease ease = Ease::linear;
  if (const JsonNode* word = in.find(node, "ease")) ease = Ease(in.word(*word, "ease", kEases));
  if (const JsonNode* period = in.find(node, "period")) curve.period = read_period(in, *period);
  if (const JsonNode* offset = in.find(node, "offset")) curve.offset = in.number(*offset);
  curve.jitter = optional_time(in, node, "jitter");
  curve.seed = optional_seed(in, node);
  read_each_key(in, in.need(node, "keys"), ease, curve);
  if (curve.jitter > 0 && curve.period == 0)
    in.refuse(*in.find(node, "jitter"), "jitter needs a period");
  if (curve.jitter > 0 && curve.keys.back().time + curve.jitter > curve.period)
    in.refuse(*in.find(node, "jitter"),
              fmt::format("the last key and the jitter must end within the period {}, got {} + {}",
                          curve.period, curve.keys.back().time, curve.jitter));
  return curve;
}

WanderCurve read_wander(Reading& in, const JsonNode& node) {
  in.expect_object(node,
                   {"center", "amplitude", "home", "period", "jitter", "move", "offset", "ease",
                    "seed", "stream"},
                   "wander");
  WanderCurve curve;
  if (const JsonNode* center = in.find(node, "center")) curve.center = in.number(*center);
  curve.amplitude = in.number(in.need(node, "amplitude"));
  if (const JsonNode* home = in.find(node, "home")) {
    curve.home = in.number(*home);
    if (!(curve.home >= 0 && curve.home <= 1))
      in.refuse(*home,
                fmt::format("a share of the periods lies between 0 and 1, got {}", curve.home));
  }
  curve.period = read_period(in, in.need(node, "period"));
  curve.jitter = optional_time(in, node, "jitter");
  if (in.find(node, "move")) curve.move = optional_time(in, node, "move");
  if (curve.jitter + curve.move > curve.period)
    in.refuse(node, fmt::format("jitter and move must end within the period {}, got {} + {}",
                                curve.period, curve.jitter, curve.move));
  if (const JsonNode* offset = in.find(node, "offset")) curve.offset = in.number(*offset);
  if (const JsonNode* word = in.find(node, "ease"))
    curve.ease = Ease(in.word(*word, "ease", kEases));
  curve.seed = optional_seed(in, node);
  if (const JsonNode* stream = in.find(node, "stream"))
    curve.stream = read_count(in, *stream, "stream");
  return curve;
}

Curve read_curve(Reading& in, const JsonNode& node) {
  in.expect(node, JsonKind::object);
  if (const JsonNode* sine = in.find(node, "sine")) {
    in.expect_object(node, {"sine"});
    return read_sine(in, *sine);
  }
  if (const JsonNode* wander = in.find(node, "wander")) {
    in.expect_object(node, {"wander"});
    return read_wander(in, *wander);
  }
  if (!in.find(node, "keys")) in.refuse(node, "a curve has \"keys\", \"sine\" or \"wander\"");
  return read_keys(in, node);
}

/// CURVE, or [CURVE, …].
std::vector<Curve> read_curves(Reading& in, const JsonNode& node) {
  std::vector<Curve> curves;
  if (node.kind != JsonKind::array) {
    curves.push_back(read_curve(in, node));
    return curves;
  }
  if (node.count == 0) in.refuse(node, "expected at least one curve");
  in.for_each(node, [&](const JsonNode& curve, int) { curves.push_back(read_curve(in, curve)); });
  return curves;
}

/// What lives in an idle face, and by which control.
struct LivingControl {
  enum class Unit : unsigned char { one, upper_end, eyeball };

  std::string_view what, control;
  IdlePart part;
  Unit unit = Unit::one;
  double times = 1;
};

constexpr LivingControl kLiving[] = {
    {"gaze", "gaze.x", IdlePart::gaze_x, LivingControl::Unit::eyeball},
    {"gaze", "gaze.y", IdlePart::gaze_y, LivingControl::Unit::eyeball},
    {"head", "yaw", IdlePart::yaw},
    {"head", "pitch", IdlePart::pitch},
    {"head", "roll", IdlePart::roll},
    {"blinks", "blink.left", IdlePart::blink_left},
    {"blinks", "blink.right", IdlePart::blink_right},
    {"breath", "breath", IdlePart::breath, LivingControl::Unit::upper_end, 0.3},
    {"mouth", "corner.left", IdlePart::corner_left, LivingControl::Unit::upper_end},
    {"mouth", "corner.right", IdlePart::corner_right, LivingControl::Unit::upper_end},
    {"brows", "brow_lift.left", IdlePart::brow_left, LivingControl::Unit::upper_end},
    {"brows", "brow_lift.right", IdlePart::brow_right, LivingControl::Unit::upper_end},
    {"pupils", "dilation", IdlePart::dilation, LivingControl::Unit::one, 0.05}};

constexpr std::array<std::string_view, 7> kLife{"gaze",  "head",  "blinks", "breath",
                                                "mouth", "brows", "pupils"};

double unit_of(const LivingControl& living, Index<Control> control, const FaceDraft& face) {
  const FaceModel& model = face.model;
  if (living.unit == LivingControl::Unit::one) return 1;
  if (living.unit == LivingControl::Unit::upper_end)
    return control.in(model.controls).channels[0].in(model.channels).hi;
  if (model.eyes.empty()) return 0;
  return face.vector[std::size_t(model.layout[model.eyes[0].radius].begin)];
}

/// [WORD, …]: what of the face lives.
std::vector<IdleChannel> read_life(const Reading& in, const JsonNode& node, const FaceDraft& face) {
  std::vector<IdleChannel> channels;
  if (node.count == 0) in.refuse(node, "expected at least one word");
  in.for_each(node, [&](const JsonNode& child, int) {
    const std::string_view what = kLife[in.word(child, "part of idle life", kLife)];
    const std::size_t before = channels.size();
    for (const LivingControl& living : kLiving) {
      if (living.what != what) continue;
      if (const Index<Control> found = face.find_control(living.control))
        channels.push_back({living.part, found, living.times * unit_of(living, found, face)});
    }
    if (channels.size() == before)
      in.refuse(child, fmt::format("this face has no control that \"{}\" moves", what));
  });
  return channels;
}

/// The words of a clip of life. A control may be called so, too: its array holds curves.
const JsonNode* find_life(const Reading& in, const JsonNode& clip) {
  const JsonNode* life = in.find(clip, "life");
  if (!life || life->kind != JsonKind::array) return nullptr;
  return life->count > 0 && in.tree.first(*life)->kind == JsonKind::object ? nullptr : life;
}

/// {CONTROL: CURVE, …}, {"tracks": {CONTROL: CURVE, …}, "additive": true}, or {"life": [WORD, …]}.
Motion read_clip(Reading& in, const JsonNode& node, const FaceDraft& face) {
  in.expect(node, JsonKind::object);
  Motion clip{.name = in.name(node, in.tree.key(node)), .channels = {}};
  if (const JsonNode* life = find_life(in, node)) {
    in.expect_object(node, {"life", "additive"}, "clip");
    if (const JsonNode* additive = in.find(node, "additive")) clip.additive = in.boolean(*additive);
    clip.idle = read_life(in, *life, face);
    return clip;
  }
  const JsonNode* tracks = in.find(node, "tracks");
  if (tracks) {
    in.expect_object(node, {"tracks", "additive"}, "clip");
    in.expect(*tracks, JsonKind::object);
    if (const JsonNode* additive = in.find(node, "additive")) clip.additive = in.boolean(*additive);
  }
  in.for_each(tracks ? *tracks : node, [&](const JsonNode& track, int) {
    const std::string_view name = in.tree.key(track);
    if (name == "comment") return;
    const Index<Control> control = face.control_named(in, track, name);
    clip.channels.push_back({std::string(name), read_curves(in, track), control});
  });
  return clip;
}

}  // namespace

void read_clips(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  in.for_each(node, [&](const JsonNode& clip, int) {
    if (in.tree.key(clip) != "comment") face.model.clips.push_back(read_clip(in, clip, face));
  });
}

}  // namespace mien
