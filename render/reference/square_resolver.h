#pragma once
// The reference: a square's mean colour by distances alone.
//
// It shares nothing with the way pictures are drawn (outlines, their order, areas of pieces): only the shapes'
// signed distances and the layers' paints. A square is divided into quarters until every shape that matters covers
// it, misses it, or crosses it along what is nearly a parabola. Nine distances decide that; three more, where it
// crosses, measure by how much it is off. Parabolas are replaced by straight lines that part the square in the same
// areas, and these cut it into polygons of one colour each. The reference draws what the arrangement's certificate
// refuses, and judges flat pictures in tests.

#include "render/reference/layer_logic.h"
#include "render/shade/paint_table.h"

#include <array>
#include <span>
#include <vector>

#include "distance_table_private.h"
#include "outline_fit_private.h"

namespace mien {

/// A mean colour, premultiplied, in the blending space, and what a channel of it may be off by.
struct Resolved {
  Mix mix{0.0};
  double bound = 0;
  bool varies = false;  ///< a paint that varies may be seen
};

/// The work of resolving so far.
struct ResolverStats {
  long long squares = 0, distances = 0;
};

class SquareResolver {
 public:
  /// `tolerance`: how much squares that are not divided further may add to the error of a pixel. All arguments must
  /// outlive this.
  SquareResolver(const Scene& scene, const View& view, const PaintTable& paints, double tolerance);

  /// The pixel (x, y) of the whole picture.
  Resolved pixel(int x, int y);

  const ResolverStats& stats() const { return stats_; }

 private:
  using Scope = LayerLogic::Scope;
  static constexpr double kLitHalf =
      1.0 / 16;                        ///< [px] half the side of squares that light is looked at in
  static constexpr int kUnits = 2048;  ///< of a pixel, in which squares are placed
  /// A square of the pixel at hand, by its middle and half its side.
  struct Square {
    int x, y, half;
  };
  /// A straight line that replaces an outline across the square: offset + dot(normal, p) = 0.
  struct Line {
    glm::dvec2 normal;
    double offset;
    double bend;  ///< of the outline
    double sag;   ///< how far the outline leaves the line
  };
  /// A set in the square: it lies where the given sides of its lines are, or everywhere else.
  struct Cut {
    int set;
    int line[2] = {-1, -1};
    bool inside[2] = {true, true};  ///< where offset + dot(normal, p) <= 0
    bool opposite = false;
  };
  enum class Side : unsigned char { crosses, inside, outside, unknown };

  enum class Kink : unsigned char { none, stop, jump };

  // square_resolver.cpp: squares
  void enter_blocks(int x, int y);
  Scope scope_of(const Scope& outer, glm::dvec2 center, double half);
  Resolved square(const Square& s, const Scope& scope, int depth);
  Resolved covered(glm::dvec2 center, double half, const Scope& scope, int depth);
  Kink kink_in(glm::dvec2 center, double half, const Scope& scope);
  bool varied(const Scope& scope) const;
  bool lit(const Scope& scope) const;
  Mix color(glm::dvec2 p, const Scope& scope);
  Mix paint(const PaintedLayer& layer, glm::dvec2 p);
  Outward outward(int lit, glm::dvec2 p);
  double distance(int shape, glm::dvec2 p);
  double distance(int shape, int x, int y);
  glm::dvec2 place(int x, int y) const;

  // square_cuts.cpp: what outlines part a square into
  bool cuts(const Square& s, const Scope& scope, Resolved& to);
  bool cut_by(int set, const Square& s);
  Side side_of(int set, const Square& s, const OutlineFit& fit, double sign, int& line);
  Side crosses(int set, const Square& s, const OutlineFit& fit, double sign, int& line);
  int line_like(const Line& line, double half, bool& turned);
  double beside_ends(const Line& line, double half) const;
  double crossings(double half) const;
  void add_varied(glm::dvec2 center, const Scope& scope, std::span<const glm::dvec2> corners);
  void polygon(const Square& s, const Scope& scope, std::size_t done,
               std::span<const glm::dvec2> corners);

  // square_folds.cpp: where distances are not smooth
  bool folded(int set, const Square& s, const NineDistances& d);
  bool cut_by_rims(Cut cut, const Square& s, const OutlineFit& fold, double width, double sign);
  bool two_lines(int set, const Square& s, const NineDistances& d);
  bool hold_between(int set, const Square& s, std::span<const OutlineFit> lines, bool either);
  bool cut_by_both(int set, std::span<const OutlineFit> lines, bool either, double off,
                   double half);

  const Scene& scene_;
  const PaintTable& paints_;
  Map<FaceSpace, GridSpace> face_from_grid_;
  double scale_;  ///< [px per face unit]
  double tolerance_;
  int depth_;  ///< halvings of a pixel
  LayerLogic logic_;
  ResolverStats stats_;

  static constexpr int kBlocks[] = {64, 8};  ///< [px] parts of the picture, one within the other
  struct Block {
    int x, y;
    Scope scope;
  };
  std::vector<Block> blocks_;
  glm::dvec2 corner_{0.0};  ///< of the pixel at hand
  DistanceTable table_;
  bool varies_ = false;
  std::vector<double> kinks_;
  /// What of a relief's area decides in a pixel.
  struct NearPixel {
    glm::dvec2 corner{0.0};
    std::vector<Node> nodes;
  };
  std::vector<NearPixel> near_;  ///< by lit paint

  std::vector<Line> lines_;
  std::vector<Cut> cuts_;
  std::array<char, 8> sides_{};  ///< by line: whether the polygon at hand is inside
  bool varies_here_ = false;
  double bent_ = 0;  ///< bound on the error of means of varying colours, times their area
  double off_ = 0;   ///< area that lines may put on the wrong side [px²]
  Mix sum_{0.0}, least_{0.0}, most_{0.0};  ///< of the square's polygons: by area; their colours
  std::vector<char> inside_;               ///< by set, at the place at hand
  std::vector<Mix> levels_;
  std::vector<int> open_, chain_;
};

}  // namespace mien
