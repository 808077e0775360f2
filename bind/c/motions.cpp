// Motions: takes of actors and tracks of speech, and faces that follow them.

#include <mien/bound_motion.h>
#include <mien/motion_file.h>
#include <mien/motion_length.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "lib/rig/pose/curve.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

using namespace mien::c;

namespace {

/// A motion with what its reader told.
mien_motion* new_motion(mien::Expected<mien::Motion> read, std::vector<mien::Error> told) {
  auto made = std::make_unique<mien_motion>();
  made->motion = std::make_shared<const mien::Motion>(must(std::move(read), MIEN_UNREADABLE));
  for (const mien::Error& one : told) made->told.push_back(mien::sentence(one));
  return made.release();
}

/// What a frame holds a face at.
std::vector<mien::Setting> frame_of(const mien_pose& pose, const char* frame, size_t length) {
  auto motion =
      must(mien::read_motion_text(text_of(frame, length, "frame"), "frame"), MIEN_REFUSED);
  return mien::settings_at(*mien::bind_motion(std::move(motion), pose.face).motion, 0);
}

double need_at_least(double number, double least, std::string_view argument) {
  if (need_finite(number, argument) >= least) return number;
  refuse(std::string(argument), fmt::format("expected {} or above, got {}", least, number));
}

}  // namespace

extern "C" {

mien_status mien_motion_read(const char* path, size_t path_length, mien_motion** out,
                             mien_error** error) {
  return pass("mien_motion_read", error, [&] {
    mien_motion*& made = place(out);
    std::vector<mien::Error> told;
    auto read = mien::read_motion(path_of(path, path_length), &told);
    made = new_motion(std::move(read), std::move(told));
  });
}

mien_status mien_motion_read_text(const char* text, size_t length, const char* name,
                                  size_t name_length, mien_motion** out, mien_error** error) {
  return pass("mien_motion_read_text", error, [&] {
    mien_motion*& made = place(out);
    std::vector<mien::Error> told;
    const auto whole = text_of(text, length, "text");
    auto read = mien::read_motion_text(whole, name_of(name, name_length, "motion"), &told);
    made = new_motion(std::move(read), std::move(told));
  });
}

void mien_motion_free(mien_motion* motion) {
  delete motion;
}

double mien_motion_length(const mien_motion* motion) {
  return motion ? mien::motion_length(*motion->motion) : 0;
}

int32_t mien_motion_channel_count(const mien_motion* motion) {
  return motion ? int32_t(motion->motion->channels.size()) : 0;
}

const char* mien_motion_channel_name(const mien_motion* motion, int32_t index) {
  if (index < 0 || index >= mien_motion_channel_count(motion)) return "";
  return motion->motion->channels[std::size_t(index)].name.c_str();
}

double mien_motion_value(const mien_motion* motion, int32_t index, double seconds) {
  if (index < 0 || index >= mien_motion_channel_count(motion)) return 0;
  return mien::value_at(motion->motion->channels[std::size_t(index)].curves[0], seconds);
}

mien_status mien_motion_told(const mien_motion* motion, mien_texts** out, mien_error** error) {
  return pass("mien_motion_told", error, [&] {
    mien_texts*& made = place(out);
    made = new_texts(need(motion, "motion").told);
  });
}

mien_status mien_motion_unfollowed(const mien_motion* motion, const mien_face* face,
                                   mien_texts** out, mien_error** error) {
  return pass("mien_motion_unfollowed", error, [&] {
    mien_texts*& made = place(out);
    const mien::Motion& of = *need(motion, "motion").motion;
    made = new_texts(mien::bind_motion(of, need(face, "face").face).unfollowed);
  });
}

mien_status mien_pose_motion(mien_pose* pose, const mien_motion* motion, double weight,
                             double begin, mien_error** error) {
  return pass("mien_pose_motion", error, [&] {
    mien_pose& changed = need(pose, "pose");
    const mien_motion& of = need(motion, "motion");
    changed.pose.motions.push_back({.motion = of.bound_to(changed.face),
                                    .weight = need_finite(weight, "weight"),
                                    .begin = need_finite(begin, "begin")});
  });
}

mien_status mien_pose_follow(mien_pose* pose, const char* frame, size_t length,
                             mien_error** error) {
  return pass("mien_pose_follow", error, [&] {
    mien_pose& changed = need(pose, "pose");
    for (mien::Setting& setting : frame_of(changed, frame, length))
      changed.hold(std::move(setting));
  });
}

mien_status mien_steadier_new(double cutoff, double beta, mien_steadier** out, mien_error** error) {
  return pass("mien_steadier_new", error, [&] {
    mien_steadier*& made = place(out);
    const mien::Steadiness wished{.cutoff = need_at_least(cutoff, 1e-6, "cutoff"),
                                  .beta = need_at_least(beta, 0, "beta")};
    made = new mien_steadier{mien::SteadyFrames(wished)};
  });
}

void mien_steadier_free(mien_steadier* steadier) {
  delete steadier;
}

mien_status mien_pose_follow_steadily(mien_pose* pose, mien_steadier* steadier, double seconds,
                                      const char* frame, size_t length, mien_error** error) {
  return pass("mien_pose_follow_steadily", error, [&] {
    mien_pose& changed = need(pose, "pose");
    mien_steadier& filter = need(steadier, "steadier");
    const double moment = need_finite(seconds, "seconds");
    auto settings = frame_of(changed, frame, length);
    for (mien::Setting& setting : filter.frames.steadied(changed.face, std::move(settings), moment))
      changed.hold(std::move(setting));
  });
}
}
