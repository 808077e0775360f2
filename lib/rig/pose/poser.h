#pragma once
// pose_face with its scratch kept, for animation.
//
//   Poser poser(*face);
//   for (…) draw(scene_from_face(poser.pose({.time = t})));

#include <mien/api.h>
#include <mien/pose.h>

#include <memory>
#include <span>

namespace mien {

/// Poses one face again and again. What it gives is what pose_face gives, bit for bit, whatever was
/// posed before; after the first poses nothing is allocated.
class MIEN_API Poser {
 public:
  explicit Poser(Face face);
  Poser(Poser&&) noexcept;
  Poser& operator=(Poser&&) noexcept;
  ~Poser();

  /// Valid until the next pose, or copied.
  const Face& pose(const Pose& pose);

  /// The pulls of the model's muscles at the last pose.
  std::span<const double> pulls() const;

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace mien
