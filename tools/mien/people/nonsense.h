#pragma once
// The nonsense test: whether a face stays a face in every pose. What is measured are distances on the
// posed outlines, so no picture is needed.
//
//   const NonsenseTest test;
//   for (const NonsenseFault& fault : test.faults(*face_from_code("A97Y1-5M52F-C9"))) …
//
// A check looks at features by their names ("head", "opening.left", "lip_upper", "hair_front"), and only
// where a face has them. Lengths are in units of a head about 1.07 wide.

#include <mien/face.h>
#include "tools/mien/people/nonsense_pose.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

struct RestSight;

/// What a check asks.
struct NonsenseCheck {
  std::string_view name;  ///< "lids_meet"
  std::string_view says;
};

/// All of them, in the order of tables.
std::span<const NonsenseCheck> nonsense_checks();

struct NonsenseFault {
  std::string_view check;
  std::string pose;  ///< as --set takes it, word by word: "emotion.joy=1 yaw=30"; "rest"
  std::string what;  ///< "left", "line on skin"; may be empty
  double measured;
  double
      allowed;  ///< the least of it; of areas and gaps (lids_meet, arm_joined, beard_on_chin): the most
};

/// Knows the six emotions of a plain face, to which `reads` compares. Every function may be called on
/// many threads at once.
class NonsenseTest {
 public:
  NonsenseTest();
  NonsenseTest(NonsenseTest&&) noexcept;
  NonsenseTest& operator=(NonsenseTest&&) noexcept;
  ~NonsenseTest();

  /// Of all poses; in their order. A face takes well under 0.1 s.
  std::vector<NonsenseFault> faults(const Face& face) const;

  /// Of one: `posed` is `face` at that pose, or what somebody made of it.
  std::vector<NonsenseFault> faults(const Face& face, const Face& posed,
                                    const NonsensePose& pose) const;

 private:
  struct Feelings;
  void look(const RestSight& rest, const Face& posed, const NonsensePose& pose,
            std::vector<NonsenseFault>& list) const;
  std::unique_ptr<const Feelings> feelings_;
};

}  // namespace mien
