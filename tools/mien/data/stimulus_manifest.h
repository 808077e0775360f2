#pragma once
// What was shown: every picture of an experiment with all its numbers, enough to draw it again.

#include "tools/mien/data/stimulus.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mien::command {

/// A picture that was written.
struct ShownStimulus {
  Stimulus stimulus;
  double displacement =
      0;               ///< of the pose from the same face at rest [face units], root mean square
  std::string sha256;  ///< of the file
};

struct StimulusManifest {
  int size = 0;  ///< [px] the longer side
  std::vector<ShownStimulus> shown;
};

/// As JSON, a line for each picture; numbers read back as they were.
std::string manifest_text(const StimulusManifest& manifest);

/// Whether a file says that it is a manifest; a file that cannot be read is none.
bool is_stimulus_manifest(const std::filesystem::path& path);

/// Reads manifest_text. Errors have their place.
Expected<StimulusManifest> read_stimulus_manifest(const std::filesystem::path& path);

}  // namespace mien::command
