#include <hwy/highway.h>
#include "sdf/distance/instruction_sets.h"

namespace mien::batch {

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const int64_t id : hwy::SupportedAndGeneratedTargets()) {
    const bool fused = id != HWY_SCALAR && id != HWY_SSE4 && id != HWY_SSSE3;
    sets.push_back({hwy::TargetName(id), id, fused});
  }
  return sets;
}

void use_instruction_set(long long id) {
  hwy::SetSupportedTargetsForTest(id);
}

}  // namespace mien::batch
