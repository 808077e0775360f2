// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/arrange/reach_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "sdf/arrange/reach.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void Meeting(const Reaches& of, float low, float high, std::uint8_t* to) {
  const hn::CappedTag<float, 8> f;
  constexpr size_t kBits = 8;
  const auto lo = hn::Set(f, low), hi = hn::Set(f, high);
  for (size_t k = 0; k < of.count; k += kBits) {
    size_t bits = 0;
    for (size_t lane = 0; lane < kBits; lane += hn::Lanes(f)) {
      const auto meets = hn::And(hn::Le(hn::LoadU(f, of.low + k + lane), hi),
                                 hn::Ge(hn::LoadU(f, of.high + k + lane), lo));
      std::array<std::uint8_t, 8> part;
      hn::StoreMaskBits(f, meets, part.data());
      bits |= size_t(part[0]) << lane;
    }
    to[k / kBits] = std::uint8_t(bits);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(Meeting);
}  // namespace batch

void meeting(const Reaches& of, float low, float high, std::uint8_t* to) {
  MIEN_DISPATCH(Meeting)(of, low, high, to);
}

}  // namespace mien
#endif
