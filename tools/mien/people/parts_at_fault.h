#pragma once
// Which parts people with a fault share.

#include <mien/recipe.h>

#include <string>
#include <vector>

namespace mien::command {

/// A part that faulty people have more often than others have it.
struct PartAtFault {
  std::string family, part;
  int faulty, all;  ///< people who have it
};

/// Three at most, the surest first. Each explains people whom those before it did not explain; of what
/// one person alone has, nothing can be said.
std::vector<PartAtFault> parts_at_fault(const std::vector<const Recipe*>& people,
                                        const std::vector<char>& faulty);

}  // namespace mien::command
