#pragma once
// A take as it is read, row by row: moments, and a number for each channel.

#include <mien/expected.h>
#include <mien/motion.h>
#include <mien/motion_file.h>
#include "lib/file/motion/take_names.h"
#include "place_private.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// In what times are written.
enum class TakeClock : unsigned char {
  seconds,  ///< as they are
  ticking,  ///< of a clock, from the first row on: seconds, or where steps are long, milli-, micro- or nanoseconds
  milliseconds
};

class TakeBuilder {
 public:
  /// `name` is that of the file, for messages.
  TakeBuilder(std::string name, const MotionLimits& limits);

  TakeClock clock = TakeClock::seconds;

  /// The column of a channel: 0, 1, …; one that is new in a later row was 0 until then.
  std::size_t column(const TakeTarget& target);
  std::size_t columns() const { return targets_.size(); }

  /// Begins a row, in which all channels are 0. Where its time is not after that of the row before, the error says so, and
  /// `where` is its place; a row of the same time replaces the one before.
  Expected<Done> begin_row(double time, const Place& where);
  /// A finite number, as it is written, for a column of the row that was begun last. `target` is how it is written there.
  void set(std::size_t column, double written, const TakeTarget& target);
  /// A moment in which no face was seen.
  void skip_row() { ++bridged_; }

  /// The motion, and what is to be told. An error for a take without rows.
  Expected<Motion> finish(std::vector<Error>& told);

 private:
  void tell_time_units(std::vector<Error>& told);
  void scale_percent(std::vector<Error>& told);
  void clamp(std::vector<Error>& told);

  std::string name_;
  MotionLimits limits_;
  std::vector<TakeTarget> targets_;
  std::shared_ptr<SampleTable> table_;
  std::size_t bridged_ = 0, replaced_ = 0;
};

}  // namespace mien
