#pragma once
// The reference: a square's mean colour by distances alone.
//
// It shares nothing with the way pictures are drawn (outlines, their order, areas of pieces): only the
// layers' signed distances and their paints. A square is divided into quarters until every layer
// covers it, misses it or cuts it along what is all but a straight line; those lines cut it into
// polygons of one colour each. Slow and simple: it draws what the arrangement's certificate refuses,
// and judges flat pictures in tests.

#include <mien/render/shade/paint_table.h>

#include <span>
#include <vector>

namespace mien {

/// A mean colour, premultiplied, in the blending space, and what a channel of it may be off by.
struct Resolved {
  Mix mix{0.0};
  double bound = 0;
  bool varies = false;  ///< a paint that varies may be seen
};

class SquareResolver {
 public:
  /// `tolerance`: what squares that are not divided any more may add to a pixel. All must outlive
  /// this.
  SquareResolver(const Scene& scene, const View& view, const PaintTable& paints, double tolerance);

  /// The pixel (x, y) of the whole picture.
  Resolved pixel(int x, int y);

 private:
  enum class Reach : unsigned char { part, whole, none };
  /// A layer that can be seen in a square.
  struct Seen {
    int layer;
    Reach reach;  ///< how much of the square it covers
  };
  /// An outline across a square: inside where offset + dot(normal, p − middle) <= 0.
  struct StraightCut {
    std::size_t seen;
    glm::dvec2 normal;
    double offset;
  };
  Resolved square(glm::dvec2 center, double half, std::size_t first, int depth);
  std::size_t look_at(glm::dvec2 center, double half, std::size_t first, std::size_t last);
  bool may_jump(glm::dvec2 center, double half, std::size_t first);
  Resolved covered(glm::dvec2 center, double half, std::size_t first, int depth);
  bool cuts(glm::dvec2 center, double half, std::size_t first, Resolved& to);
  bool straight(glm::dvec2 center, double half, std::size_t which);
  void polygon(glm::dvec2 center, std::size_t first, std::size_t done,
               std::span<const glm::dvec2> corners);
  Mix color(glm::dvec2 p, std::size_t first);
  Mix paint(const PaintedLayer& layer, glm::dvec2 p);
  double distance(int layer, glm::dvec2 p) const;

  const Scene& scene_;
  const PaintTable& paints_;
  Map<FaceSpace, GridSpace> face_from_grid_;
  double scale_;  ///< [px per face unit]
  double tolerance_;
  std::vector<Seen> seen_;  ///< bottom to top; of all squares around the present one, in turn
  bool varies_ = false;
  std::vector<double> kinks_;
  std::vector<StraightCut> lines_;
  double off_ = 0;  ///< what the lines leave their outlines by, together [px]
  Mix sum_{0.0}, least_{0.0}, most_{0.0};  ///< of the square's polygons: by area; their colours
  std::vector<Mix> levels_;
  std::vector<int> open_, chain_;
};

}  // namespace mien
