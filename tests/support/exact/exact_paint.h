#pragma once
// What a scene's layers are painted with at one place, in both blending spaces, and where along a
// line paints have kinks or jumps. By the definitions of sdf/scene/paint.h.

#include <mien/scene.h>
#include <mien/view.h>

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "tests/support/exact/exact_distance.h"
#include "tests/support/exact/exact_mix.h"

namespace mien::test {

/// A line across a picture: `u` [px] along it to a place of the face.
struct FaceLine {
  glm::dvec2 start, way;

  glm::dvec2 operator()(double u) const { return start + u * way; }
};

/// Where something begins or ends along a line; `what` tells such things apart.
struct LineEnd {
  double at;  ///< [px]
  std::size_t what;
};

class ExactPaint {
 public:
  static constexpr double kShortest = 1e-3;  ///< [px] two kinks closer together may be missed

  /// `unit`: face units per pixel. The scene and its distances must outlive this.
  ExactPaint(const Scene& scene, const ExactDistance& distance, const View& view, double unit);

  const Mixes& background() const { return background_; }
  /// Whether nothing below the layer is seen inside it.
  bool hides(int layer) const { return hides_[std::size_t(layer)]; }
  /// False where the layer has one colour all over a disc, proven.
  bool varies(int layer, glm::dvec2 center, double radius) const;
  /// Whether colours may jump within the layer.
  bool jumps(int layer) const;
  /// Whether its surface stands upright at p: beside such a place colours grow like a square root.
  bool upright(int layer, glm::dvec2 p) const;

  Mixes at(int layer, glm::dvec2 p) const;
  /// Which clamps of light hold at p, by bits.
  unsigned clamps_at(int layer, glm::dvec2 p) const;

  /// Where between a and b the paint has a kink or a jump, but for ridges.
  void find_kinks(int layer, const FaceLine& line, double a, double b,
                  std::vector<LineEnd>& out) const;
  /// Where between a and b its relief has a ridge: places equally far from two pieces of the outline.
  void find_ridges(int layer, const FaceLine& line, double a, double b,
                   std::vector<LineEnd>& out) const;

 private:
  const Layer& layer(int i) const { return scene_.layers()[std::size_t(i)]; }
  Mixes mixes(const Color& color, double opacity) const;
  bool is_lit(int i) const { return layer(i).paint.relief != nullptr; }
  Mixes unlit(int layer, glm::dvec2 p) const;
  /// x right, y UP.
  glm::dvec2 slope_at(int layer, glm::dvec2 p) const;
  double place(const Gradient& gradient, glm::dvec2 p) const;
  bool opaque(const Layer& layer) const;
  void gradient_kinks(const Gradient& gradient, const FaceLine& line, double a, double b,
                      std::size_t what, std::vector<LineEnd>& out) const;
  void relief_kinks(const Relief& relief, const FaceLine& line, double a, double b,
                    std::size_t what, std::vector<LineEnd>& out) const;

  /// A relief's distance along a line, by how far along it.
  struct ReliefLine {
    std::function<glm::dvec2(double)> slope;
    std::function<double(double)> distance;  ///< [px]
    glm::dvec2 way;                          ///< of length 1
  };
  bool goes_evenly(const ReliefLine& line, double a, const glm::dvec2& at_a, double b,
                   const glm::dvec2& at_b) const;
  void ridges(const ReliefLine& line, double a, const glm::dvec2& at_a, double b,
              const glm::dvec2& at_b, std::size_t what, std::vector<LineEnd>& out) const;

  const Scene& scene_;
  const ExactDistance& distance_;
  Light light_;
  double unit_;
  Mixes background_;
  std::vector<bool> hides_;
  std::vector<Mixes> flat_;  ///< the layers' colours without gradient
};

/// The depths at which the slope of a relief's profile may jump [face units].
std::vector<double> edges_of(const Relief& relief);

}  // namespace mien::test
