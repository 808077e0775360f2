#pragma once
// What is still undecided in a square of the picture: a few outlines, a few layers, and the colour
// beneath them.
//
// Narrowing a scope to a smaller square decides outlines by ONE distance each (|d| larger than the
// half diagonal: all in or all out, since distances are 1-Lipschitz), simplifies the layers'
// programs with what is decided, drops what can't be seen, and forgets outlines nobody asks for any
// more. Scopes live on a stack and nest.

#include <mien/render/tile/tape.h>

#include <span>
#include <vector>

namespace mien {

/// A part of the scope stack; valid until the stack is reset below it.
struct Scope {
  int first_outline, outline_count;  ///< undecided outlines
  int first_layer, layer_count;      ///< visible layers, top to bottom
  Mix base;                          ///< what lies under the last of them
};

/// What is known of an outline: the point (or the whole square) is outside of it, inside, or it is
/// not decided.
enum class Side : unsigned char { out, in, unknown };

/// The stack of scopes of one thread, and the present side of every outline.
class ScopeStack {
 public:
  explicit ScopeStack(const Tape& tape);

  /// Everything: no outline decided.
  Scope everything();

  /// What stays undecided in the disc (center, radius) around a square. Pushes only what is new.
  Scope narrowed(const Scope& scope, glm::dvec2 center, double radius);

  /// A mark to come back to: reset(mark()) forgets all scopes pushed in between.
  struct Mark {
    std::size_t outlines, layers, steps;
  };
  Mark mark() const { return {outlines_.size(), layers_.size(), steps_.size()}; }
  void reset(const Mark& mark);

  std::span<const int> outlines(const Scope& scope) const {
    return {outlines_.data() + scope.first_outline, std::size_t(scope.outline_count)};
  }

  /// Says on which side of an outline the next colors are asked for.
  void set_side(int outline, Side side) { sides_[std::size_t(outline)] = side; }

  /// The colour of a point of the scope, for the sides set. All outlines of the scope must be
  /// decided.
  Mix color(const Scope& scope);

 private:
  struct Layer {
    int first, count;  // steps; none: the layer covers the whole square
    Mix mix;
  };
  Side simplify(int first, int count);
  bool inside(const Layer& layer);
  void forget_unused(Scope& scope);

  const Tape& tape_;
  std::vector<int> outlines_;
  std::vector<Layer> layers_;
  std::vector<Step> steps_;
  std::vector<Side> sides_;
  std::vector<char> used_, bits_;
  struct Partial {
    Side side;
    std::size_t begin;
  };
  std::vector<Partial> partials_;
};

}  // namespace mien
