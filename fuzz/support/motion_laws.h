#pragma once
// What a motion that was read holds to, and a reader that is given any bytes as lines.

#include <mien/bound_motion.h>
#include <mien/motion_file.h>
#include <mien/motion_length.h>
#include <mien/poser.h>
#include "lib/file/motion/motion_reader_private.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/support/require.h"
#include "fuzz/support/small_face.h"

namespace mien::fuzz {

inline constexpr MotionLimits kMotionLimits{
    .rows = 100'000, .numbers = 1'000'000, .bytes = 1 << 20};

inline void require_table(const SampleTable& table) {
  require(!table.times.empty());
  require(table.values.size() == table.times.size() * table.columns);
  require(table.values.size() <= 15 * kMotionLimits.numbers);
  for (std::size_t row = 1; row < table.times.size(); ++row)
    require(table.times[row] >= table.times[row - 1]);
  for (const float value : table.values) require(std::abs(value) <= 180);
}

/// An error is a sentence; a motion has tables in order, and poses a face to finite numbers.
inline void require_motion(Expected<Motion> motion, const std::vector<Error>& told) {
  for (const Error& one : told) require_sentence(one);
  if (!motion) return require_sentence(motion.error());
  const double length = motion_length(*motion);
  require(std::isfinite(length) && length >= 0);
  const SampleTable* last = nullptr;
  for (const MotionChannel& channel : motion->channels)
    if (const auto* table = std::get<SampledCurve>(channel.curves[0]).table.get();
        std::exchange(last, table) != table)
      require_table(*table);
  const BoundMotion bound = bind_motion(*std::move(motion), small_face());
  Poser poser(small_face());
  for (const double t : {-1.0, length / 2, length + 1})
    for (const double number :
         poser.pose({.time = t, .motions = {{.motion = bound.motion}}}).vector)
      require(std::isfinite(number));
}

/// Gives one reader the lines of any text, as read_motion does once it has chosen.
inline void require_reader(std::unique_ptr<MotionReader> (*reader_for)(const MotionSource&),
                           const std::uint8_t* data, std::size_t size) {
  const std::unique_ptr<MotionReader> reader = reader_for({"fuzz", kMotionLimits});
  std::string_view left(reinterpret_cast<const char*>(data), size);
  std::size_t number = 1;
  bool begun = false;
  while (!left.empty()) {
    const std::string_view line = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(line.size() + 1, left.size()));
    begun |= !without_blanks(line).empty();
    if (begun)
      if (const auto taken = reader->take({line, number}); !taken)
        return require_sentence(taken.error());
    ++number;
  }
  if (!begun) return;
  std::vector<Error> told;
  Expected<Motion> motion = reader->finish(told);
  require_motion(std::move(motion), told);
}

}  // namespace mien::fuzz
