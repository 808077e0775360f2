#pragma once
// A stroke of varying width made ready for many points.
//
// Spine and half-width together are one curve (B, w + L) in a space whose last coordinate counts
// negatively; the candidates for the nearest disc are its nearest points, by the same depressed cubic
// as QuadBezierFrame's (docs/derivations/tapered_batches.md).

#include <mien/shape.h>
#include "sdf/distance/quad_bezier/quad_bezier_frame.h"

#include <optional>

namespace mien::batch {

template <class T>
struct TaperedFrame {
  QuadBezierFrame<T> spine;
  T w0, wa2, wb, wb2;  ///< half-width w0 + t (wa2 + t wb), scaled; wb2 = 2 wb
  T px, py, pw, p1;    ///< P = px·dx + py·dy + pw·L + p1
  T sx, sy, sw, s1;    ///< S2 likewise
  T vertex;            ///< t = x − vertex
  /// An error e of t changes a depth by at most e² steep2 / |q|; least_lead is that bound for the error of the
  /// largest root.
  T steep2, least_lead;
};

/// None for spines that are points, nearly straight or out of float's range, where the half-width bends
/// nearly as much as the spine, and where the vertex is far away: those go through the scalar form.
template <class T>
std::optional<TaperedFrame<T>> tapered_frame(const TaperedStroke& stroke);

/// |p − B(t)| − w(t) in double precision.
double depth_at(const TaperedStroke& stroke, double t, glm::dvec2 p);

}  // namespace mien::batch
