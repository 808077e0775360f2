// Poses.

#include <mien/face_code.h>
#include <mien/face_model.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "lib/rig/pose/expression_setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

using namespace mien::c;

extern "C" {

mien_status mien_pose_new(const mien_face* face, mien_pose** out, mien_error** error) {
  return pass("mien_pose_new", error, [&] {
    mien_pose*& made = place(out);
    made = new mien_pose(need(face, "face").face);
  });
}

void mien_pose_free(mien_pose* pose) {
  delete pose;
}

mien_status mien_pose_clear(mien_pose* pose, mien_error** error) {
  return pass("mien_pose_clear", error, [&] { need(pose, "pose").pose = {}; });
}

mien_status mien_pose_time(mien_pose* pose, double seconds, mien_error** error) {
  return pass("mien_pose_time", error,
              [&] { need(pose, "pose").pose.time = need_finite(seconds, "seconds"); });
}

mien_status mien_pose_set(mien_pose* pose, const char* text, size_t length, mien_error** error) {
  return pass("mien_pose_set", error, [&] {
    const mien::Face& face = need(pose, "pose").face;
    pose->hold(must(mien::read_setting(face, text_of(text, length, "text")), MIEN_REFUSED));
  });
}

mien_status mien_pose_set_at(mien_pose* pose, int32_t index, const double* values, int32_t count,
                             mien_error** error) {
  return pass("mien_pose_set_at", error, [&] {
    const mien::FaceModel& model = *need(pose, "pose").face.model;
    const std::size_t controls = model.controls.size(), slices = model.layout.slices().size();
    const auto at = std::size_t(index_of(index, controls + slices, "index"));
    const bool control = at < controls;
    const mien::Slice* slice = control ? nullptr : &model.layout[int(at - controls)];
    need_count(count, control ? 1 : std::size_t(slice->size), "count");
    const double* const first = &need(values, "values");
    const auto& channels = model.channels;
    const double largest = model.layout.largest;
    double lo = -largest, hi = largest;
    if (control) {
      const mien::Channel& channel = model.controls[at].channels[0].in(channels);
      lo = channel.lo, hi = channel.hi;
    } else if (const mien::SliceRange range = slice->range(); range.rule == mien::Rule::clamp) {
      lo = range.lo, hi = std::min(range.hi, largest);
    }
    for (const double value : std::vector(first, first + count))
      if (!(value >= lo && value <= hi))
        refuse(std::string(control ? model.controls[at].name : slice->name),
               fmt::format("goes from {} to {}, got {}", lo, hi, value));
    pose->hold({control, control ? int(at) : slice->begin, {first, first + count}});
  });
}

mien_status mien_pose_express(mien_pose* pose, const char* set, size_t set_length, const char* text,
                              size_t length, int32_t clamp, mien_error** error) {
  return pass("mien_pose_express", error, [&] {
    const mien::Face& face = need(pose, "pose").face;
    pose->hold(must(
        mien::read_expression(face, text_of(set, set_length, "set"), text_of(text, length, "text"),
                              clamp ? mien::OutOfRange::clamp : mien::OutOfRange::refuse),
        MIEN_REFUSED));
  });
}

mien_status mien_pose_clip(mien_pose* pose, const char* text, size_t length, mien_error** error) {
  return pass("mien_pose_clip", error, [&] {
    const mien::Face& face = need(pose, "pose").face;
    pose->pose.motions.push_back(
        must(mien::read_clip_layer(face, text_of(text, length, "text")), MIEN_REFUSED));
  });
}

mien_status mien_pose_seed(mien_pose* pose, const char* word, size_t length, mien_error** error) {
  return pass("mien_pose_seed", error, [&] {
    std::optional<std::uint64_t>& seed = need(pose, "pose").pose.seed;
    const std::string_view text = text_of(word, length, "word");
    if (text.empty()) refuse("seed", "an empty word is no seed");
    seed = mien::seed_from_word(text);
  });
}

mien_status mien_pose_liveliness(mien_pose* pose, double liveliness, mien_error** error) {
  return pass("mien_pose_liveliness", error, [&] {
    double& held = need(pose, "pose").pose.liveliness;
    if (!(liveliness >= 0 && liveliness <= mien::kMostLively))
      refuse("liveliness", fmt::format("goes from 0 to {}, got {}", mien::kMostLively, liveliness));
    held = liveliness;
  });
}

mien_status mien_pose_gestures(mien_pose* pose, double gestures, mien_error** error) {
  return pass("mien_pose_gestures", error, [&] {
    double& held = need(pose, "pose").pose.gestures;
    if (!(gestures >= 0 && gestures <= mien::kMostGestures))
      refuse("gestures", fmt::format("go from 0 to {}, got {}", mien::kMostGestures, gestures));
    held = gestures;
  });
}

mien_status mien_pose_look_at(mien_pose* pose, double x, double y, double z, mien_error** error) {
  return pass("mien_pose_look_at", error, [&] {
    const std::string point = fmt::format("{},{},{}", x, y, z);
    pose->pose.look_at = must(mien::read_look_at(need(pose, "pose").face, point), MIEN_REFUSED);
  });
}

mien_status mien_pose_unwrap(mien_pose* pose, double share, int32_t mode, mien_error** error) {
  return pass("mien_pose_unwrap", error, [&] {
    mien::Pose& changed = need(pose, "pose").pose;
    if (!(share >= 0 && share <= 1)) refuse("share", "expected a number from 0 to 1");
    if (mode < MIEN_UNWRAP_LINEAR || mode > MIEN_UNWRAP_SINE)
      misuse("mode", "is none of the MIEN_UNWRAP_ modes");
    changed.unwrap = share;
    changed.unwrap_mode = mien::UnwrapMode(mode);
  });
}

mien_status mien_pose_vector(mien_pose* pose, double* values, int32_t count, mien_error** error) {
  return pass("mien_pose_vector", error, [&] {
    need_count(count, need(pose, "pose").face.vector.size(), "count");
    const auto& vector = pose->posed().vector;
    if (count > 0) std::copy(vector.begin(), vector.end(), &need(values, "values"));
  });
}
}
