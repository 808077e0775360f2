#pragma once
// A stimulus as a file.

#include "tools/mien/data/stimulus_manifest.h"

#include <mien/expected.h>

#include <filesystem>

namespace mien::command {

/// Draws it into that file, `size` pixels on the longer side. Errors have their address.
Expected<ShownStimulus> show_stimulus(const Stimulus& stimulus, int size,
                                      const std::filesystem::path& path);

/// What a manifest says of a file that is there already and has that SHA-256.
Expected<ShownStimulus> shown_before(const Stimulus& stimulus, const std::string& sha256);

}  // namespace mien::command
