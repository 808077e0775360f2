#pragma once
// Controls: the numbers that pose a face without being part of it (gaze, dilation, blink).

#include <mien/index.h>
#include <mien/key_shapes.h>

#include <string>
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

/// A name for one channel ("gaze.left.x"), or for a left and a right one together ("gaze.x").
struct Control {
  std::string name;
  std::string unit;
  std::vector<Index<Channel>> channels;  ///< 1 or 2
  bool pose = false;  ///< the weight of a named pose ("brow.sad", "brow.left.sad")
};

}  // namespace mien
