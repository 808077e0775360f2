#pragma once
// How long a sound is.

#include <mien/expected.h>

#include <optional>
#include <string>

namespace mien::command {

/// [s] Of a WAV file, by its header and by how much of it is there. None: a file of another kind. Errors: it cannot be read;
/// a WAV without its format or sound.
Expected<std::optional<double>> wave_seconds(const std::string& path);

}  // namespace mien::command
