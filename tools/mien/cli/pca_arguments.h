#pragma once
// What people typed after `mien pca`.

#include <optional>
#include <string>
#include <vector>

namespace mien::command {

struct PcaArguments {
  enum class Verb { fit, info, encode, decode, compare, sheet } verb = Verb::fit;
  std::string basis, input, output;
  std::optional<std::string> weights, components, variance, max_error, size, frames, fps, frame,
      face, mesh, plot, spread;
  std::vector<std::string> settings;
};

}  // namespace mien::command
