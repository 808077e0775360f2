#pragma once
// What all benches of whole pictures measure with: a clock, medians, memory that is warm.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace mien::bench {

/// Now [ms], on a clock that never goes back.
double now_ms();

double ms_of(const std::function<void()>& work);

/// The upper one of the two in the middle; 0 of nothing.
double median(std::vector<double> times);

/// "0.123", or "-" where there is nothing to divide by or nothing to divide.
std::string ratio_text(double a, double b);

/// A number for JSON, null where nothing was measured (0).
std::string json_number(double value);

/// Memory that a vector store may take: pages touched, 64-byte aligned.
class Pixels {
 public:
  explicit Pixels(std::size_t bytes);
  std::uint32_t* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  std::unique_ptr<std::uint32_t, Free> data_;
};

/// How many rounds to take: as many as asked for, else by the picture's size, and no further ones
/// once `seconds` are over, three aside.
class Rounds {
 public:
  Rounds(int asked, double seconds, std::size_t pixels);
  /// Whether round `index` (0, 1, …) is still to be taken.
  bool go_on(int index) const;

 private:
  int most_;
  bool asked_;
  double end_ms_;
};

}  // namespace mien::bench
