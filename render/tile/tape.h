#pragma once
// A scene made ready to draw: outlines in pixels, and layers as small programs on their bits.
//
// CSG is resolved on bits (is the point inside this outline?), never on distances: offsets and
// shells are pushed down to the shapes on the way, where they are exact statements about a
// distance. So a pixel cut by several outlines evaluates each of them, and abutting areas of a
// union leave no seam.

#include <mien/render/blend/blender.h>
#include <mien/render/tile/paint.h>
#include <mien/sdf/edge/edge.h>
#include <mien/sdf/scene/scene.h>

#include <vector>

namespace mien {

/// One step of a layer's program, in postfix order.
struct Step {
  enum class Kind : unsigned char { outline, nothing, not_, and_, or_ } kind;
  int outline = 0;  ///< index into Tape::outlines
};

struct TapeLayer {
  int first, count;  ///< steps, in Tape::steps
  Mix mix;           ///< what the layer lays over those below; of a paint its least opacity alone
  int paint = -1;  ///< index into Tape::paints: the colour varies with the place; −1: it is `mix`
  int group = -1;  ///< index into Tape::groups: a part of a translucent group; −1: on its own

  /// One colour, laid over what is below by itself: all that fast paths need to know.
  bool plain() const { return paint < 0 && group < 0; }
};

/// Layers that are mixed first and laid over what is below as one.
struct TapeGroup {
  int parent;  ///< in Tape::groups; −1: none
  int depth;   ///< 1 for a group in no other
  double opacity;
};

/// Immutable once made; shared by all threads.
struct Tape {
  std::vector<OffsetShape> outlines;  ///< in pixels, origin at the picture's centre
  std::vector<Step> steps;
  std::vector<TapeLayer> layers;  ///< top to bottom
  std::vector<TapePaint> paints;
  std::vector<AreaDistance> distances;
  std::vector<TapeGroup> groups;  ///< translucent ones only, parents first
  Mix background;
  Blend blend;
  bool dither;  ///< pixels in which paints vary
};

Tape tape_from_scene(const Scene& scene, const View& view);

/// The same into a tape that was used before: its memory, and the maker's, is used again.
class TapeMaker {
 public:
  void make(const Scene& scene, const View& view, Tape& tape);

  struct Task {  ///< a node of the scene to write next, or a step
    int node = -1;
    double offset = 0;
    Step::Kind kind = Step::Kind::nothing;
  };
  struct Range {
    int first = -1, count = 0;  ///< in Tape::steps; −1: not written yet
  };

 private:
  std::vector<Task> todo_;
  std::vector<Range> written_;  ///< by shape, without offset
  std::vector<int> groups_;
};

}  // namespace mien
