#include <hwy/highway.h>
#include "sdf/distance/instruction_sets.h"

namespace mien::batch {

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const int64_t id : hwy::SupportedAndGeneratedTargets()) {
    const bool fused = id == HWY_AVX2 || id == HWY_AVX3 || id == HWY_AVX3_DL ||
                       (HWY_ARCH_ARM_A64 && id != HWY_SCALAR);  // as in fma-inl.h
    sets.push_back({hwy::TargetName(id), id, fused});
  }
  return sets;
}

void use_instruction_set(long long id) {
#if (HWY_TARGETS & (HWY_TARGETS - 1)) != 0
  hwy::SetSupportedTargetsForTest(id);
#else
  static_cast<void>(id);  // there is one set, and nothing to choose
#endif
}

}  // namespace mien::batch
