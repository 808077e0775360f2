#pragma once
// Whether a frame of an earlier run is complete, and is the one that would be drawn now.

#include <filesystem>
#include <string_view>

namespace mien::command {

/// A PNG whose every chunk is there with its right checksum, and whose description is `recipe`.
bool is_finished_frame(const std::filesystem::path& path, std::string_view recipe);

}  // namespace mien::command
