#pragma once
// A square of a leaf in which colours vary, in vectors: 8 bits a channel.
//
//   stacks    for each combination of sides of the leaf's edges, the layers seen there, top to bottom
//   cells     the square's pixels; where a distance is not bilinear in a pixel, its parts
//   samples   places in a cell on one set of sides, and what they count for
//
// A cell that no edge and no kink of a paint crosses is seen from Gauss's two points each way. Another is
// cut by its edges and kinks, and each piece seen from three places of each of its triangles. Then each
// stack's samples are coloured all at once (lane_paint.h), added up per pixel, and stored.
// docs/derivations/lit_leaves.md has the errors.

#include <mien/render/cover/arrangement.h>
#include <mien/render/tile/lane_paint.h>
#include <mien/render/tile/leaf.h>
#include <mien/render/tile/local_paint.h>
#include <mien/render/tile/near_area.h>
#include <mien/render/tile/pixel.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace mien {

/// A layer that can be seen in the square.
struct SquareLayer {
  std::uint32_t in;  ///< bit i: with the sides i
  Mix mix;           ///< its colour, or with a paint its least opacity
  int paint = -1;    ///< it varies
  int group = -1;
};

/// Draws such squares of one picture. One per thread; keeps its scratch.
class VariedSquare {
 public:
  explicit VariedSquare(const Tape& tape);

  /// Where the square is.
  struct Place {
    glm::dvec2 leaf_center;  ///< [px] of the picture's coordinates
    glm::dvec2 shift;        ///< the square's middle from there
    int side;                ///< [px] 1, 4, 8 or 16
    int x, y;                ///< its first pixel in the picture
  };
  /// The edges are the leaf's; its palette is not read, Leaf::same is written. `layers`: top to
  /// bottom. `tolerance`: [px] of outlines. Rows of side × side pixels, with room for 16. False: not this way.
  bool draw(Leaf& leaf, std::span<const SquareLayer> layers, const Place& place, double tolerance,
            std::uint32_t* pixels);

 private:
  static constexpr int kMostPaints = 16;
  static constexpr int kMostDepth = 3;  ///< divisions of a pixel for what its paints are like
  static constexpr int kEdgeDepth = 6;  ///< and for what its edges are

  struct Stack {
    std::vector<LaneLayer> layers;
    std::uint32_t paints = 0;  ///< bit i: paint i is among them
    LanePlaces places() const;
    std::vector<float> x, y;
    std::vector<std::int32_t> cell;
    std::vector<double> weight;
    std::vector<std::uint16_t> pixel;
  };
  struct Distance {
    int index = -1;  ///< in Tape::distances
    NearArea area;
    std::vector<float> corners, centers;  ///< of the square's pixels
    LaneDistances lanes;
    struct Fine {
      int pixel = -1;
      std::vector<float> corners, centers;
    };
    std::array<Fine, kMostDepth> fine;  ///< of one pixel, in 2, 4 and 8 parts each way
  };
  struct Paint {
    int index;                                      ///< in Tape::paints
    int place_distance = -1, relief_distance = -1;  ///< in distances_
    bool smooth = false;  ///< no kink in the whole square, and no radial centre near
  };
  struct Cell {
    glm::dvec2 center;  ///< from the leaf's
    double side;
    int pixel, depth, column, row;  ///< the part, in units of its side
    int index = -1;                 ///< among the cells that samples name
  };

  bool make_stacks(Leaf& leaf, std::span<const SquareLayer> layers);
  bool add_layers(std::uint32_t sides, std::span<const SquareLayer> layers, Stack& stack);
  int paint_of(int index);
  bool make_paints();
  void make_distance(Distance& distance);
  void classify_paint(Paint& paint);
  void blocks(const Leaf& leaf);
  void pixel(const Leaf& leaf, int column, int row, std::uint32_t asked, std::uint32_t base);
  void cell(const Leaf& leaf, const Cell& cell, std::uint32_t asked, std::uint32_t base);
  void edges(const Leaf& leaf, const Cell& cell, glm::dvec2 center, double side, int depth,
             std::uint32_t asked, std::uint32_t base);
  bool good(const Cell& cell, std::uint32_t paints);
  Bilinear bilinear_of(Distance& distance, const Cell& cell);
  LocalPaint local_of(const Paint& paint, const Cell& cell);
  std::uint32_t paints_of(std::uint32_t active, std::uint32_t base) const;
  int name(const Cell& cell);
  bool put_right(const LeafView::Sight& edge, double side);
  void sample(std::uint32_t sides, glm::dvec2 at, double weight, int cell, int pixel);
  void sample_gauss(std::uint32_t sides, glm::dvec2 center, double side, double weight, int cell,
                    int pixel);
  void sample_pieces(const LeafView& view, const Cell& cell, glm::dvec2 center, double side);
  void store(std::uint32_t* pixels);

  const Tape& tape_;
  double tolerance_ = 0;
  PaintSampler sampler_;
  Place place_{};
  std::array<Stack, Leaf::kMostSides> stacks_;
  int stack_count_ = 0;
  std::array<std::uint8_t, Leaf::kMostSides> stack_of_{};
  std::vector<Paint> paints_;
  std::vector<LanePaint> lane_paints_;
  std::vector<Distance> distances_;
  int distance_count_ = 0;
  std::vector<float> cell_x_, cell_y_;
  std::vector<float> xs_, ys_, ds_;
  std::vector<double> kinks_;
  std::vector<Cut> cuts_;  ///< of the cell at hand, where its paints have kinks
  std::vector<Cut> all_cuts_;
  double in_share_ = 1, out_share_ = 1;  ///< what pieces inside and outside the only edge count for
  Arrangement arrangement_;
  std::array<std::vector<float>, 4> colors_;
  std::array<Mix, kLeaf * kLeaf> sums_;
  std::array<char, kLeaf * kLeaf> varies_;
};

}  // namespace mien
