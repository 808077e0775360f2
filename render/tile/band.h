#pragma once
// The fast way through a picture: bands of 64 rows, cut into tiles and leaves.
//
//   a band    up to 64 tiles of 64 × 64 pixels against every outline near, and the layers' programs
//             on a bit per tile;
//   a tile    its 16 leaves of 16 × 16 pixels in the same way; written a row of leaves at a time, across
//             all tiles: memory takes long runs faster (docs/decisions/frame_times.md);
//   a leaf    a few edges and a palette: drawn in vectors (leaf.h). What is not proven for a leaf is
//             asked again for its quarters, down to blocks of 4 × 4; what is not proven there is
//             resolved pixel by pixel (pixel.h).
//
// What a pixel becomes depends on its leaf alone, and leaves are at absolute positions of the whole
// picture: never on threads, regions or order.

#include <mien/render/tile/leaf.h>
#include <mien/render/tile/local_paint.h>
#include <mien/render/tile/picture.h>
#include <mien/render/tile/pixel.h>
#include <mien/render/tile/plan.h>
#include <mien/render/tile/sides.h>
#include <mien/render/tile/stores.h>
#include <mien/render/tile/varied_square.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace mien {

/// Height of a band and side of its tiles [px].
inline constexpr int kBandTile = 64;

/// Draws bands of one picture after another; keeps its scratch. One per thread.
class BandPainter {
 public:
  /// The band whose top row is y, a multiple of kBandTile, of a picture of width × height, as far
  /// as the target shows it.
  void draw(const Plan& plan, int width, int height, int y, const Target& target,
            RenderStats& stats);

 private:
  static constexpr int kGroup = 64;  // tiles decided together: bits of a mask
  static constexpr int kLeavesAcross = kBandTile / kLeaf;

  /// A layer that can be seen somewhere in the squares: where it covers all, where perhaps.
  struct Seen {
    int layer;
    std::uint64_t in, unknown;
  };
  struct Squares {
    std::vector<Seen> seen;  // top to bottom
    std::uint64_t mixed = 0;
    std::array<int, kGroup> color;  // of the others: a layer, or one of those below
  };
  static constexpr int kBackground = -1, kComposite = -2;

  using OutlineInLeaves = std::array<LeafOutline, Leaves::kMost>;
  /// A tile of several colours: its leaves described, to be drawn a row of them at a time.
  struct Tile {
    struct Wanted {
      int outline;
      std::uint32_t leaves;  // that need its edges
    };
    int x = 0;  // its left side [px]
    std::vector<int> layers;
    Squares squares;
    std::vector<int> noted;  // outlines that its layers read, and where its leaves lie against them
    std::vector<Sides> sides;
    std::vector<Wanted> wanted;
    std::vector<OutlineInLeaves> outlines;  // by place in `wanted`

    bool one_color(int row) const;  // its leaves, all plain
  };

  void group(int x, int tiles);
  int draw_tiles(int x, int first, int tiles);
  void note(int index, Tile& tile);
  void link(int outline, int tile, int place);
  glm::dvec2 center_of(const Tile& tile, int lane) const;
  void place_leaves();
  void resolve_leaves(int index);
  void find_edges();
  void draw_row(const Tile& tile, int row);
  void stream_row(const Tile& tile, int row, std::uint32_t* to);
  void leaf(const Tile& tile, int lane);
  std::optional<Mix> mix_of(int layer, glm::dvec2 center, double side);
  void resolve(std::span<const int> layers, std::span<const Sides> outlines, std::uint64_t valid,
               Squares& squares);
  Mix composite(const Squares& squares, int lane) const;
  void fill(const Squares& squares, int lane, const PixelRect& square);
  void fill(const PixelRect& square, std::uint32_t value);
  void fill_slowly(const PixelRect& square, const Mix& mix);
  void note_outlines(std::span<const int> layers);
  Sides classified(int outline, std::span<const float> x, std::span<const float> y,
                   float half_diagonal);

  bool assemble(std::span<const LeafOutline> outlines, std::span<const LeafEdge> edges,
                glm::dvec2 shift, double side, double most_bend);
  bool add_edges(const LeafOutline& outline, std::span<const LeafEdge> edges, glm::dvec2 shift,
                 double most_bend);
  std::uint64_t pattern(const LeafOutline& outline, int first) const;
  bool color_leaf(glm::dvec2 center, double side);

  /// A layer that some combinations of the present edges' sides show.
  struct Shown {
    std::uint64_t combinations;
    Mix mix;
    int paint;  ///< −1: it is `mix`
    std::optional<PaintSampler::Mean> mean;
  };
  struct Look {
    Mix mix{0.0}, change{0.0}, error{0.0}, bent{0.0};  ///< as PaintSampler::Mean has them
    bool varied = false;
  };
  bool see_layers(glm::dvec2 center, double side);
  void look_at(glm::dvec2 center, double side);
  std::optional<Look> look(int sides);
  bool mixes(const Mix& change, const Mix& bent, const Mix& least) const;
  static void lay_under(Look& look, const PaintSampler::Mean& below);
  bool shows(const Mix& off, const Mix& least) const;
  bool color_varied(glm::dvec2 center, double side, std::uint32_t base, std::uint32_t asked);
  std::optional<Mix> whole(int sides);
  std::optional<Mix> varied_square(glm::dvec2 center, double side, std::uint32_t asked,
                                   std::uint32_t base);
  std::optional<Mix> described(std::span<const LeafOutline> outlines,
                               std::span<const LeafEdge> edges, glm::dvec2 shift, double side,
                               double most_bend);
  void put(const Mix& mix, int x, int y);

  void paint(std::uint32_t blocks);
  void count(const LeafPixels& left, std::uint32_t blocks, const PixelRect& part);
  /// The present leaf's outlines in parts of it.
  struct Parts {
    std::vector<OutlineInLeaves> found;  ///< by place in leaf_wanted_
    std::vector<LeafEdge> edges;
    std::vector<LeafOutline> list;  ///< those of the part at hand
  };
  void find_outlines(const Leaves& squares, Parts& to);
  void divide(glm::dvec2 center, int side, int block_x, int block_y);
  void pixel_by_pixel(glm::dvec2 center, int block_x, int block_y);
  std::optional<Mix> cells(glm::dvec2 center, double side, int depth);
  std::optional<Mix> undescribed(glm::dvec2 center, double side, Parts& parts);
  Mix square(glm::dvec2 center, double side, std::uint32_t asked, std::uint32_t base);
  bool lit_square(glm::dvec2 shift, int leaf_x, int leaf_y, int side);
  void sure_square(int block_x, int block_y, int side);
  std::byte* at(int x, int y) const;
  PixelRect visible(const PixelRect& square) const;

  // What is drawn now.
  const Plan* plan_ = nullptr;
  long made_ = 0;  // Plan::made
  const Target* target_ = nullptr;
  RenderStats* stats_ = nullptr;
  int width_ = 0, height_ = 0, y_ = 0;
  Stores stores_ = Stores::ordinary;
  int leaf_x_ = 0, leaf_y_ = 0;  // of the present leaf's corner
  glm::dvec2 leaf_center_{};
  Leaf leaf_;

  // Scratch.
  std::vector<int> group_layers_, leaf_layers_, noted_;
  std::vector<std::uint32_t> stamp_;
  std::uint32_t stamp_now_ = 0;
  std::vector<Sides> group_sides_, tile_sides_, leaf_sides_, stack_;
  Squares group_;
  std::vector<Tile> tiles_;  // those described together, and their number
  int described_ = 0;
  std::vector<LeafEdge> edges_;  // of all their outlines
  /// A tile that asks about an outline; what it asks for is at a place in its lists.
  struct Link {
    int tile, place;
    int next;  // of the same outline; −1: none
  };
  std::vector<Link> links_;
  std::vector<int> heads_, linked_;    // by outline: its first link; outlines that have one
  std::vector<std::uint32_t> wanted_;  // by outline: leaves of a tile that need its edges
  std::vector<int> leaf_wanted_;       // outlines of the present leaf
  bool varies_here_ = false;           // why assemble said no
  std::optional<PaintSampler> paints_;
  std::optional<VariedSquare> lit_;
  std::vector<SquareLayer> square_layers_;
  std::vector<Shown> shown_;
  glm::dvec2 look_center_{};
  double look_side_ = 1;
  bool varied_ = false;  ///< the pixel at hand shows a gradient
  std::vector<LeafOutline> leaf_list_;
  static constexpr int kCellLevels = 3;
  std::array<Parts, 3 + kCellLevels> parts_;  // of leaves, of their quarters, pixels, and cells
  std::array<Mix, Leaf::kMostSides> mixes_;
  std::array<float, kGroup> xs_, ys_;
  std::array<std::int8_t, kGroup> answers_;
  alignas(64) std::array<std::uint32_t, kLeaf * kLeaf> scratch_;
  alignas(
      64) std::array<std::uint32_t, kBandTile * kLeaf> row_;  // of leaves, before it is streamed
};

}  // namespace mien
