#pragma once
// pose_face for animation: it keeps its scratch memory.
//
//   Poser poser(*face);
//   for (…) draw(scene_from_face(poser.pose({.time = t})));

#include <mien/api.h>
#include <mien/pose.h>

#include <memory>
#include <span>

namespace mien {

/// Poses one face repeatedly. The result is that of pose_face, bit for bit, whatever was posed before.
/// After the first poses nothing is allocated.
class MIEN_API Poser {
 public:
  explicit Poser(Face face);
  Poser(Poser&&) noexcept;
  Poser& operator=(Poser&&) noexcept;
  ~Poser();

  /// The reference is valid until the next pose; copy the face to keep it.
  const Face& pose(const Pose& pose);

  /// The pulls of the model's muscles at the last pose.
  std::span<const double> pulls() const;

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace mien
