#pragma once
// What all readers of motions have in common: they are given a file line by line, and give a motion in the end.

#include <mien/motion_file.h>
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A place in a file, counted from 1.
struct FileLine {
  std::string_view text;  ///< without its end
  std::size_t number = 1;
};

/// What a reader knows about its file.
struct MotionSource {
  std::string name;  ///< one line, for messages
  MotionLimits limits;

  std::string at(std::size_t line) const { return fmt::format("{}:{}", name, line); }
  /// The place of a part of a line; columns count characters.
  std::string at(const FileLine& line, std::string_view part) const {
    std::size_t column = 1;
    for (const char* c = line.text.data(); c < part.data(); ++c)
      column += (static_cast<unsigned char>(*c) & 0xC0) != 0x80;
    return fmt::format("{}:{}:{}", name, line.number, column);
  }
};

class MotionReader {
 public:
  virtual ~MotionReader() = default;
  virtual Expected<Done> take(const FileLine& line) = 0;
  /// After the last line. What was odd goes to `told`.
  virtual Expected<Motion> finish(std::vector<Error>& told) = 0;
};

/// A number and nothing else, finite; blanks around it do not count.
std::optional<double> number_in(std::string_view text);
std::string_view without_blanks(std::string_view text);

/// The readers, each for the first line that it is given, which is not blank.
std::unique_ptr<MotionReader> csv_take_reader(const MotionSource& source);
std::unique_ptr<MotionReader> json_motion_reader(const MotionSource& source);
std::unique_ptr<MotionReader> rhubarb_xml_reader(const MotionSource& source);
std::unique_ptr<MotionReader> text_grid_reader(const MotionSource& source);
std::unique_ptr<MotionReader> marks_reader(const MotionSource& source);
std::unique_ptr<MotionReader> pho_reader(const MotionSource& source);

/// Whether a line is a heading of which one column holds times.
bool is_take_heading(std::string_view line);
/// Whether a line begins with a moment and goes on with a name.
bool is_mark(std::string_view line);
/// Whether a line is a phone with its length in milliseconds, or a comment of such files.
bool is_pho(std::string_view line);

}  // namespace mien
