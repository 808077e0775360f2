#pragma once
// pose_face with its scratch kept, for animation.
//
//   Poser poser(*face);
//   for (…) draw(scene_from_face(poser.pose({.time = t})));

#include <mien/lib/base/api.h>
#include <mien/lib/rig/muscle_pose.h>
#include <mien/lib/rig/pose.h>

#include <optional>
#include <span>
#include <vector>

namespace mien {

/// Poses one face again and again. What it gives is what pose_face gives, bit for bit, whatever was
/// posed before; after the first poses nothing is allocated.
class MIEN_API Poser {
 public:
  explicit Poser(Face face);

  /// Valid until the next pose, or copied.
  const Face& pose(const Pose& pose);

  /// The pulls of the model's muscles at the last pose.
  std::span<const double> pulls() const { return muscles_.pulls(); }

 private:
  void drive_channels(bool poses);

  Face rest_, posed_;
  std::vector<double> values_, scratch_;
  MusclePoser muscles_;
  std::optional<UnwrapChart> chart_;  ///< made when first needed
};

}  // namespace mien
