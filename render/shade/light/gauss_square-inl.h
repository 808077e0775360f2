// A square by Gauss's 4 × 4 places: the bicubic through them, its means over pixels, and whether it serves. Included
// once per instruction set.
//
// The places' Legendre coefficients of third degree, by row and by column, bound those of higher ones where colours are
// analytic in a disc twice as wide as the square: each degree then takes at most a third of the one before. Nothing
// that a kink or a ridge could break is looked at by them: those are asked for by themselves.
#if defined(MIEN_RENDER_SHADE_GAUSS_SQUARE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_GAUSS_SQUARE_INL_H_
#undef MIEN_RENDER_SHADE_GAUSS_SQUARE_INL_H_
#else
#define MIEN_RENDER_SHADE_GAUSS_SQUARE_INL_H_
#endif

#include "render/shade/light/light_tile.h"
#include "sdf/distance/feet/feet-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr double kGaussNode[4] = {-0.861136311594052575, -0.339981043584856265,
                                         0.339981043584856265, 0.861136311594052575};
inline constexpr double kGaussWeight[4] = {0.173927422568726929, 0.326072577431273071,
                                           0.326072577431273071, 0.173927422568726929};

struct GaussTables {
  alignas(64) float x[16], y[16];  ///< places, of half the side
  float second[4], third[4];  ///< of a row's values: its coefficients of second and third degree
  float power[4][4];          ///< the cubic of each node, by powers
  alignas(64) float mean[4][4][16];  ///< [log2 of the side − 1][node][pixel]: its share of the mean
  /// Sixteen places along the border, of half the side, and what each of the 4 × 4 gives to the cubic there.
  alignas(64) float border_x[16], border_y[16], border[16][16];

  static const GaussTables& get() {
    static const GaussTables made;
    return made;
  }

 private:
  GaussTables() {
    for (int i = 0; i < 16; ++i) x[i] = float(kGaussNode[i & 3]), y[i] = float(kGaussNode[i >> 2]);
    for (int k = 0; k < 4; ++k) {
      double p[4] = {1.0, 0.0, 0.0, 0.0};
      int degree = 0;
      for (int j = 0; j < 4; ++j) {
        if (j == k) continue;
        const double by = 1.0 / (kGaussNode[k] - kGaussNode[j]);
        ++degree;
        for (int i = degree; i > 0; --i) p[i] = (p[i - 1] - kGaussNode[j] * p[i]) * by;
        p[0] *= -kGaussNode[j] * by;
      }
      const double t = kGaussNode[k];
      second[k] = float(5.0 * kGaussWeight[k] * 0.5 * (3.0 * t * t - 1.0));
      third[k] = float(7.0 * kGaussWeight[k] * 0.5 * (5.0 * t * t * t - 3.0 * t));
      for (int i = 0; i < 4; ++i) power[k][i] = float(p[i]);
      for (int s = 0; s < 4; ++s) SetMeans(p, 2 << s, mean[s][k]);
    }
    SetBorder();
  }
  void SetBorder() {
    constexpr float kCorner[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    const auto at = [&](int k, float u) {
      return power[k][0] + u * (power[k][1] + u * (power[k][2] + u * power[k][3]));
    };
    for (int q = 0; q < 16; ++q) {
      const float *a = kCorner[q / 4], *b = kCorner[q / 4 + 1], t = 0.25f * float(q % 4);
      border_x[q] = a[0] + t * (b[0] - a[0]), border_y[q] = a[1] + t * (b[1] - a[1]);
      for (int k = 0; k < 16; ++k) border[k][q] = at(k & 3, border_x[q]) * at(k >> 2, border_y[q]);
    }
  }
  static void SetMeans(const double* p, int pixels, float* to) {
    for (int q = 0; q < 16; ++q) {
      const double a = -1.0 + 2.0 * q / pixels, b = a + 2.0 / pixels;
      double sum = 0.0, pa = a, pb = b;
      for (int i = 0; i < 4; ++i, pa *= a, pb *= b) sum += p[i] * (pb - pa) / (i + 1);
      to[q] = q < pixels ? float(sum / (b - a)) : 0.0f;
    }
  }
};

/// The largest coefficient in a row or a column, by the table of its degree.
inline float MostOf(const float (&k)[4], const float* c) {
  float most = 0.0f;
  for (int i = 0; i < 4; ++i) {
    const float row =
        (k[0] * c[4 * i] + k[3] * c[4 * i + 3]) + (k[1] * c[4 * i + 1] + k[2] * c[4 * i + 2]);
    const float column = (k[0] * c[i] + k[3] * c[12 + i]) + (k[1] * c[4 + i] + k[2] * c[8 + i]);
    most = HWY_MAX(most, HWY_MAX(std::abs(row), std::abs(column)));
  }
  return most;
}

/// The means of a square's pixels, to the tile's.
inline void SpreadMeans(LightTile& tile, int left, int top, int side,
                        const LightTile::Bicubic& square) {
  const F f;
  const int which = side == 2 ? 0 : side == 4 ? 1 : side == 8 ? 2 : 3;
  const auto& share = GaussTables::get().mean[which];
  HWY_ALIGN float row[4][16], out[16];
  for (int c = 0; c < tile.channels; ++c) {
    const float* v = square.c[c];
    for (int k = 0; k < side; k += int(hn::Lanes(f)))
      for (int b = 0; b < 4; ++b) {
        VF sum = hn::Mul(hn::Set(f, v[4 * b]), hn::Load(f, share[0] + k));
        for (int a = 1; a < 4; ++a)
          sum = Fused(hn::Set(f, v[4 * b + a]), hn::Load(f, share[a] + k), sum);
        hn::Store(sum, f, row[b] + k);
      }
    for (int q = 0; q < side; ++q) {
      for (int k = 0; k < side; k += int(hn::Lanes(f))) {
        VF sum = hn::Mul(hn::Set(f, share[0][q]), hn::Load(f, row[0] + k));
        for (int b = 1; b < 4; ++b)
          sum = Fused(hn::Set(f, share[b][q]), hn::Load(f, row[b] + k), sum);
        hn::Store(sum, f, out + k);
      }
      float* to = &tile.mean[size_t(c)][size_t((top + q) * LightTile::kSide + left)];
      for (int k = 0; k < side; ++k) to[k] = out[k];
    }
  }
  for (int q = 0; q < side; ++q)
    for (int k = 0; k < side; ++k) tile.known[size_t((top + q) * LightTile::kSide + left + k)] = 1;
}

/// The mean of a square of one pixel.
inline void KnowPixel(LightTile& tile, int i, int j, const LightTile::Bicubic& square) {
  const size_t to = size_t(j * LightTile::kSide + i);
  for (int c = 0; c < tile.channels; ++c) {
    double sum = 0.0;
    for (int k = 0; k < 16; ++k)
      sum += kGaussWeight[k & 3] * kGaussWeight[k >> 2] * double(square.c[c][k]);
    tile.mean[size_t(c)][to] = float(sum);
  }
  tile.known[to] = 1;
}

/// The square's colour at (u, v) of half its side from its middle.
inline void BicubicAt(const LightTile::Bicubic& square, int channels, float u, float v, float* to) {
  const auto& p = GaussTables::get().power;
  float at_u[4], at_v[4];
  for (int k = 0; k < 4; ++k) {
    at_u[k] = p[k][0] + u * (p[k][1] + u * (p[k][2] + u * p[k][3]));
    at_v[k] = p[k][0] + v * (p[k][1] + v * (p[k][2] + v * p[k][3]));
  }
  for (int c = 0; c < channels; ++c) {
    float sum = 0.0f;
    for (int b = 0; b < 4; ++b) {
      const float* s = square.c[c] + 4 * b;
      sum += at_v[b] * ((at_u[0] * s[0] + at_u[1] * s[1]) + (at_u[2] * s[2] + at_u[3] * s[3]));
    }
    to[c] = sum;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
