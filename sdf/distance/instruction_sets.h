#pragma once
// Which instruction sets the batch functions were compiled for, and choosing one: for tests,
// benches and the laboratory. Programs that just want distances get the best one by themselves.

#include <string>
#include <vector>

namespace mien::batch {

struct InstructionSet {
  std::string name;  ///< Highway's: "AVX3" is AVX-512
  long long id;
  bool fused;  ///< has fused multiply-add: all of these give the same float bits
};

/// Those compiled in that this machine has, best first.
std::vector<InstructionSet> instruction_sets();

/// Makes every batch function of the process use this set; id 0: the best. It is mien's only process-wide switch,
/// and neither installed nor exported. Not thread-safe.
void use_instruction_set(long long id);

}  // namespace mien::batch
