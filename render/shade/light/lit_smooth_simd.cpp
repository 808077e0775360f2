// Tiles whose light is smooth: by Gauss's 4 × 4 places. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/light/lit_smooth_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/blend/transfer.h"
#include "render/shade/light/lamp_lanes-inl.h"
#include "render/shade/light/lit_tile.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>

#ifndef MIEN_RENDER_SHADE_LIT_SMOOTH_ONCE_
#define MIEN_RENDER_SHADE_LIT_SMOOTH_ONCE_
namespace mien {

/// Polynomials through Gauss's four places in [−1, 1], in place of a side of a tile.
struct GaussBasis {
  static constexpr int kNodes = 4, kSide = LitTile::kSide, kRim = 4 * (kSide / 2);
  static constexpr double kNode[kNodes] = {-0.8611363115940526, -0.3399810435848563,
                                           0.3399810435848563, 0.8611363115940526};
  float mean[kNodes][kSide];                       ///< of the k-th polynomial over the i-th pixel
  float rim_x[kNodes][kRim], rim_y[kNodes][kRim];  ///< its values at the tile's border, every 2 px

  static double value(int k, double u) {
    double v = 1.0;
    for (int j = 0; j < kNodes; ++j)
      if (j != k) v *= (u - kNode[j]) / (kNode[k] - kNode[j]);
    return v;
  }
  /// The border's places, clockwise.
  static void rim(int i, double& u, double& v) {
    constexpr int kEdge = kSide / 2;
    const int edge = i / kEdge;
    const double at = -1.0 + 2.0 * (i % kEdge) / kEdge;
    u = edge == 0 ? at : edge == 1 ? 1.0 : edge == 2 ? -at : -1.0;
    v = edge == 0 ? -1.0 : edge == 1 ? at : edge == 2 ? 1.0 : -at;
  }

  GaussBasis() {
    for (int k = 0; k < kNodes; ++k) {
      for (int i = 0; i < kSide; ++i) {  // Simpson's rule: exact for cubics
        const double a = -1.0 + 2.0 * i / kSide, b = -1.0 + 2.0 * (i + 1) / kSide;
        mean[k][i] = float((value(k, a) + 4.0 * value(k, 0.5 * (a + b)) + value(k, b)) / 6.0);
      }
      for (int i = 0; i < kRim; ++i) {
        double u, v;
        rim(i, u, v);
        rim_x[k][i] = float(value(k, u)), rim_y[k][i] = float(value(k, v));
      }
    }
  }
  static const GaussBasis& get() {
    static const GaussBasis basis;
    return basis;
  }
};

}  // namespace mien
#endif

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kNodes = GaussBasis::kNodes, kSide = LitTile::kSide, kRim = GaussBasis::kRim;

/// The largest difference between the polynomial through the nodes and the border's values.
float MissedAt(const GaussBasis& basis, const float* nodes, const float* rim) {
  const F f;
  VF most = hn::Zero(f);
  for (size_t i = 0; i < size_t(kRim); i += hn::Lanes(f)) {
    VF sum = hn::Zero(f);
    for (int j = 0; j < kNodes; ++j) {
      VF row = hn::Zero(f);
      for (int k = 0; k < kNodes; ++k)
        row = Fused(Const(nodes[kNodes * j + k]), hn::LoadU(f, basis.rim_x[k] + i), row);
      sum = Fused(row, hn::LoadU(f, basis.rim_y[j] + i), sum);
    }
    most = hn::Max(most, hn::Abs(hn::Sub(sum, hn::LoadU(f, rim + i))));
  }
  return hn::GetLane(hn::MaxOfLanes(f, most));
}

void MeansOfNodes(const GaussBasis& basis, const float* nodes, float* mean) {
  const F f;
  for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
    VF row[kNodes];
    for (int j = 0; j < kNodes; ++j) {
      row[j] = hn::Zero(f);
      for (int k = 0; k < kNodes; ++k)
        row[j] = Fused(Const(nodes[kNodes * j + k]), hn::LoadU(f, basis.mean[k] + i), row[j]);
    }
    for (int y = 0; y < kSide; ++y) {
      VF sum = hn::Zero(f);
      for (int j = 0; j < kNodes; ++j) sum = Fused(row[j], Const(basis.mean[j][y]), sum);
      hn::StoreU(sum, f, mean + size_t(y * kSide) + i);
    }
  }
}

bool SmoothMeans(const SmoothPlaces& at, const LampLanes& lamp, float tolerance, float* r, float* g,
                 float* b) {
  const F f;
  HWY_ALIGN float cr[SmoothPlaces::kCount], cg[SmoothPlaces::kCount], cb[SmoothPlaces::kCount];
  for (size_t k = 0; k < size_t(SmoothPlaces::kCount); k += hn::Lanes(f)) {
    const LitColor c =
        LitAt(lamp, hn::Neg(hn::LoadU(f, &at.d[k])), hn::LoadU(f, &at.nx[k]),
              hn::LoadU(f, &at.ny[k]), hn::LoadU(f, &at.x[k]), hn::LoadU(f, &at.y[k]));
    hn::Store(c.r, f, cr + k), hn::Store(c.g, f, cg + k), hn::Store(c.b, f, cb + k);
  }
  const GaussBasis& basis = GaussBasis::get();
  constexpr int kInner = kNodes * kNodes;
  if (lamp.linear) {
    const auto dark = [](const float* c) { return *std::min_element(c, c + SmoothPlaces::kCount); };
    tolerance /= float(std::max(encoding_slope(std::min({dark(cr), dark(cg), dark(cb)})), 1.0));
  }
  for (const float* c : {cr, cg, cb})
    if (!(MissedAt(basis, c, c + kInner) <= tolerance)) return false;
  MeansOfNodes(basis, cr, r), MeansOfNodes(basis, cg, g), MeansOfNodes(basis, cb, b);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(SmoothMeans);
}  // namespace batch

SmoothPlaces::SmoothPlaces() {
  constexpr float kHalf = 0.5f * LitTile::kSide;
  constexpr int kInner = GaussBasis::kNodes * GaussBasis::kNodes;
  static_assert(kCount == kInner + GaussBasis::kRim);
  for (int k = 0; k < kInner; ++k) {
    x[std::size_t(k)] = kHalf * float(GaussBasis::kNode[k % GaussBasis::kNodes]);
    y[std::size_t(k)] = kHalf * float(GaussBasis::kNode[k / GaussBasis::kNodes]);
  }
  for (int i = 0; i < GaussBasis::kRim; ++i) {
    double u, v;
    GaussBasis::rim(i, u, v);
    x[std::size_t(kInner + i)] = kHalf * float(u), y[std::size_t(kInner + i)] = kHalf * float(v);
  }
}

bool smooth_means(const SmoothPlaces& at, float tolerance, LitTile& tile) {
  return MIEN_DISPATCH(SmoothMeans)(at, tile.lamp, tolerance, tile.smooth_r.data(),
                                    tile.smooth_g.data(), tile.smooth_b.data());
}

}  // namespace mien
#endif
