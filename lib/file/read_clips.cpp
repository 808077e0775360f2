// The clips of a face file: curves in time for controls.

#include <mien/lib/base/nearest_name.h>
#include "face_draft_private.h"

#include <fmt/format.h>

#include <array>

namespace mien {
namespace {

constexpr std::array<std::string_view, 5> kEases{"linear", "step", "smooth", "in",
                                                 "out"};  // as enum Ease

int control_named(const Reading& in, const JsonNode& node, std::string_view name,
                  const FaceDraft& face) {
  const auto found = face.control_by_name.find(std::string{name});
  if (found != face.control_by_name.end()) return found->second;
  std::vector<std::string_view> known;
  for (const Control& control : face.model.controls) known.push_back(control.name);
  in.refuse(node, unknown_name("control", name, known));
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

KeyCurve read_keys(Reading& in, const JsonNode& node) {
  in.expect_object(node, {"keys", "period", "ease"});
  KeyCurve curve;
  Ease ease = Ease::linear;
  if (const JsonNode* word = in.find(node, "ease")) ease = Ease(in.word(*word, "ease", kEases));
  if (const JsonNode* period = in.find(node, "period")) {
    curve.period = in.number(*period);
    if (!(curve.period > 0))
      in.refuse(*period, fmt::format("a period must be positive, got {}", curve.period));
  }
  const JsonNode& keys = in.need(node, "keys");
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
  return curve;
}

Curve read_curve(Reading& in, const JsonNode& node) {
  in.expect(node, JsonKind::object);
  const JsonNode* sine = in.find(node, "sine");
  if (!sine) {
    if (!in.find(node, "keys")) in.refuse(node, "a curve has either \"keys\" or \"sine\"");
    return read_keys(in, node);
  }
  in.expect_object(node, {"sine"});
  return read_sine(in, *sine);
}

}  // namespace

void read_clips(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  in.for_each(node, [&](const JsonNode& clip_node, int) {
    in.expect(clip_node, JsonKind::object);
    Clip clip{in.name(clip_node, in.tree.key(clip_node)), {}};
    in.for_each(clip_node, [&](const JsonNode& track, int) {
      const std::string_view name = in.tree.key(track);
      if (name == "comment") return;
      clip.tracks.push_back({control_named(in, track, name, face), read_curve(in, track)});
    });
    face.model.clips.push_back(std::move(clip));
  });
}

}  // namespace mien
