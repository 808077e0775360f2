#pragma once
// A motion and the face that follows it.
//
//   const BoundMotion bound = bind_motion(*read_motion("take.csv"), face);
//   for (…) draw(scene_from_face(poser.pose({.time = t, .motions = {{.motion = bound.motion}}})));

#include <mien/api.h>
#include <mien/face.h>
#include <mien/motion.h>
#include <mien/pose.h>

#include <memory>
#include <string>
#include <vector>

namespace mien {

struct BoundMotion {
  /// With the channels that the face has. The motion belongs to faces of this model.
  std::shared_ptr<const Motion> motion;
  /// The names of channels that go away from 0 and move nothing here: the face has no such control, or it has one and
  /// shows nothing by it. In the motion's order.
  std::vector<std::string> unfollowed;
};

/// Finds each channel's control by its name. Total: a motion of which the face has nothing keeps it at rest.
MIEN_API BoundMotion bind_motion(Motion motion, const Face& face);

/// What a bound motion holds at a moment [s], as settings: they beat clips, and need no time. A frame of a camera is a motion
/// of one row:
///
///   pose.settings = settings_at(*bind_motion(*read_motion_text(frame), face).motion, 0);
MIEN_API std::vector<Setting> settings_at(const Motion& bound, double time);

}  // namespace mien
