#pragma once
// What `mien pca` draws.

#include <mien/box2.h>
#include <mien/image.h>
#include <mien/npy_basis.h>
#include "tools/mien/cli/pca_arguments.h"
#include "tools/mien/pca/frames.h"

#include <array>
#include <span>
#include <vector>

namespace mien::command {

/// Draws frames of one kind: of a face, of a mesh, or of points.
class FramePainter {
 public:
  /// Errors: a face, mesh or size that does not fit the basis.
  static Expected<FramePainter> of(const PcaArguments& arguments, const BasisFile& basis,
                                   const std::optional<Face>& face);

  /// Makes the picture hold all of these frames; before the first is painted.
  void include(std::span<const double> frame);
  Image paint(std::span<const double> frame) const;
  /// Colours each vertex by an amount, 0 … 1 of the spectrum; faces are drawn as painted.
  Image paint_heat(std::span<const double> frame, std::span<const double> amounts) const;
  bool is_face() const { return face_.has_value(); }

 private:
  std::optional<Face> face_;
  std::size_t vertices_ = 0, dimensions_ = 1;
  std::vector<std::array<int, 3>> triangles_;  // of a mesh
  int side_ = 512;
  Box2 box_;  // of all frames
};

/// The error curve: the largest error and the RMS over the count of components, on a logarithmic
/// scale.
Image curve_picture(const std::vector<PcaError>& curve, int width, int height);

}  // namespace mien::command
