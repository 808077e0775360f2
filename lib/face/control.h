#pragma once
// Controls: the numbers that pose a face without being part of it (gaze, dilation, blink).

#include <mien/index.h>
#include <mien/key_shapes.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace mien {

/// slice += (value − rest) · by
struct Offset {
  int slice;
  std::vector<double> by;
};

/// slice *= value; only for controls that rest at 1
struct Scale {
  int slice;
};

/// slice += (value − rest) · (to − from), a share of the way to another shape. At a share of 1 a slice that
/// was `from` becomes `to`, bit for bit.
struct Toward {
  int slice;
  std::vector<double> from, to;
};

/// What a channel does to the face vector. When the channel rests, the vector stays as it is.
using Drive = std::variant<Offset, Scale, KeyShapes, Toward>;

struct Channel;

/// Another channel's value += (value − rest) · by. The other channel has no couplings of its own.
struct Coupling {
  Index<Channel> channel;
  double by;
};

/// One number that drives slices: a control, or a control's left or right half.
struct Channel {
  double rest = 0;
  double lo = 0, hi = 1;      ///< finite; values outside act like the nearer end
  std::vector<Drive> drives;  ///< act in this order
  bool joins = false;  ///< expressions move it as they pull muscles: v = 1 − Π (1 − amount)
  bool pose = false;   ///< whether it is the weight of a pose; those act first
  std::vector<Coupling> couplings;  ///< of a pose
};

/// The channels of a control: one, or a left and a right one.
class ControlChannels {
 public:
  std::size_t size() const { return count_; }
  const Index<Channel>* begin() const { return all_.data(); }
  const Index<Channel>* end() const { return all_.data() + count_; }
  Index<Channel> operator[](std::size_t i) const { return all_[i]; }
  /// There must be less than two.
  void push_back(Index<Channel> channel) { all_[count_++] = channel; }

 private:
  std::array<Index<Channel>, 2> all_{};
  std::size_t count_ = 0;
};

/// A name for one channel ("gaze.left.x"), or for a left and a right one together ("gaze.x").
struct Control {
  std::string_view name, unit;  ///< the model's names keep them
  ControlChannels channels;
  bool pose = false;  ///< the weight of a named pose ("brow.sad", "brow.left.sad")
};

}  // namespace mien
