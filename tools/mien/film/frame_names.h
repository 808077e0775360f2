#pragma once
// Names of frames: "frames/%05d.png".

#include <mien/expected.h>

#include <optional>
#include <string>

namespace mien::command {

/// A name with one place for the frame's number.
struct FrameNames {
  std::string before, after;
  int digits = 1;  ///< at least so many, filled up with zeros

  std::string of(long frame) const;
};

/// Reads "%d" or "%05d"; "%%" is a percent sign. Nothing if there is no such place; an error if there
/// is more than one, or another kind.
Expected<std::optional<FrameNames>> read_frame_names(const std::string& pattern);

}  // namespace mien::command
