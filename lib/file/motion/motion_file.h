#pragma once
// Reads takes of actors and tracks of speech, whatever program wrote them; docs/motion.md lists the forms.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/motion.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace mien {

/// Limits of what a file may ask for. Exceeding one is an error that names it.
struct MotionLimits {
  std::size_t rows = 10'000'000;      ///< of a table, frames or phones
  std::size_t numbers = 500'000'000;  ///< kept of a table: rows times the columns that move a face
  std::size_t bytes = 256u << 20;     ///< of files that are not read row by row, and of one line
};

/// Reads a motion by its content, not by its name: CSV of Live Link Face, OpenFace or with a column of times; JSON, or JSON
/// line by line, of MediaPipe, ARKit or Azure; tracks of Rhubarb, Praat, espeak and others. Tables are read row by row.
/// Names become those of controls, "arkit.jawOpen", "facs.AU12", "viseme.aa", "yaw". Times of day and of clocks begin at 0.
/// Values out of range are clamped and counted. The error's `where` is "FILE:LINE:COLUMN". What is odd but harmless is
/// added to `told` if given, each kind once.
MIEN_API Expected<Motion> read_motion(const std::filesystem::path& path,
                                      std::vector<Error>* told = nullptr,
                                      const MotionLimits& limits = {});

/// The same from memory; `name` stands for the file's name in errors.
MIEN_API Expected<Motion> read_motion_text(std::string_view text, std::string_view name = "motion",
                                           std::vector<Error>* told = nullptr,
                                           const MotionLimits& limits = {});

}  // namespace mien
