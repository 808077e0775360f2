#pragma once
// The members of a frame of numbers inside a JSON tree, in whatever it is wrapped (frame_file.h).

#include "lib/file/json/reading.h"

#include <string_view>
#include <vector>

namespace mien {

struct FrameMember {
  std::string_view name;
  const JsonNode* value;  ///< of any kind
};

/// What is not a number of the frame, its time or index, is left out. What stands beside it in its wrapper goes to `beside`,
/// or is refused. Throws a Refusal for what is no frame.
std::vector<FrameMember> frame_members(const Reading& in, const JsonNode& node,
                                       std::vector<FrameMember>* beside = nullptr);

}  // namespace mien
