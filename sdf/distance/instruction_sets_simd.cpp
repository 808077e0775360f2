#include <hwy/highway.h>
#include "sdf/distance/instruction_sets.h"

namespace mien::batch {
namespace {

/// Nothing is looked up where one set is compiled in: there Highway is headers alone.
constexpr bool kOneSet = (HWY_TARGETS & (HWY_TARGETS - 1)) == 0;

InstructionSet instruction_set(int64_t id) {
  const bool fused = id == HWY_AVX2 || id == HWY_AVX3 || id == HWY_AVX3_DL ||
                     (HWY_ARCH_ARM_A64 && id != HWY_SCALAR);  // as in fma-inl.h
  return {hwy::TargetName(id), id, fused};
}

}  // namespace

std::vector<InstructionSet> instruction_sets() {
  if constexpr (kOneSet) return {instruction_set(HWY_TARGETS)};
  std::vector<InstructionSet> sets;
  for (const int64_t id : hwy::SupportedAndGeneratedTargets()) sets.push_back(instruction_set(id));
  return sets;
}

void use_instruction_set(long long id) {
  if constexpr (!kOneSet) hwy::SetSupportedTargetsForTest(id);
}

}  // namespace mien::batch
