#pragma once
// Lets muscles act on a face vector: channels give pulls, pulls give a shape, and the shape is added to
// whatever else poses the face.
//
// Without a clip that drives muscles, the face is in the equilibrium of its pulls. While one runs, it has
// been in motion (motion.h) since time 0. Under a motion that is settled, such as a take of an actor, muscles are in
// equilibrium at every moment: the actor's had their law already.

#include <mien/pose.h>
#include "lib/rig/muscle/motion.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace mien {

/// The values of all channels of a face at a pose.
using ChannelsAt =
    std::function<void(const Face& rest, const Pose& pose, std::vector<double>& values)>;

/// For each channel, whether a setting or a running motion holds it.
void held_channels(const FaceModel& model, const Pose& pose, std::vector<char>& held);

/// Whether motions that run at this pose drive muscles or expressions, and none of these is settled.
bool muscles_in_motion(const FaceModel& model, const Pose& pose);

/// Adds what the muscles of a shape do to a vector: each point moves by as much as it has moved from
/// rest.
void lay_on(const FaceModel& model, const FaceVector& rest, const MuscleShape& shape,
            FaceVector& vector);

/// Lets the muscles act, pose after pose. It remembers what it has computed, which changes how long a pose
/// takes, but not the result.
class MusclePoser {
 public:
  MusclePoser() = default;
  MusclePoser(const MusclePoser&) {}  // a copy starts without memory
  MusclePoser& operator=(const MusclePoser&) { return *this; }

  /// `values` are those that `channels_at` gives for `pose`.
  void act(const Face& rest, const Pose& pose, std::span<const double> values,
           const ChannelsAt& channels_at, FaceVector& vector);

  /// The pulls of the last pose: one for each muscle.
  std::span<const double> pulls() const { return pulls_; }

 private:
  void begin_motion(const Face& rest, const Pose& pose, const ChannelsAt& channels_at);

  std::vector<char> held_;
  std::vector<double> pulls_, still_pulls_;  ///< now; those of shape_
  MuscleShape shape_, moving_;
  MusclePointLaw scratch_;
  Face rest_;     ///< of shape_
  struct Course;  ///< of pulls in time
  std::shared_ptr<Course> course_;
};

}  // namespace mien
