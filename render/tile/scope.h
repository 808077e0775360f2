#pragma once
// What is still undecided in a square of the picture: a few outlines, a few layers, and the colour
// beneath them.
//
// Narrowing a scope to a smaller square decides outlines by ONE distance each (|d| larger than the
// half diagonal: all in or all out, since distances are 1-Lipschitz), simplifies the layers'
// programs with what is decided, drops what can't be seen, and forgets outlines nobody asks for any
// more. Scopes live on a stack and nest.

#include <mien/render/tile/local_paint.h>
#include <mien/render/tile/tape.h>

#include <span>
#include <vector>

namespace mien {

/// A part of the scope stack; valid until the stack is reset below it.
struct Scope {
  int first_outline, outline_count;  ///< undecided outlines
  int first_layer, layer_count;      ///< visible layers, top to bottom
  Mix base;                          ///< what lies under the last of them
  bool varied = false;               ///< some of them are not plain (TapeLayer::plain)
};

/// What is known of an outline: the point (or the whole square) is outside of it, inside, or it is
/// not decided.
enum class Side : unsigned char { out, in, unknown };

/// The stack of scopes of one thread, and the present side of every outline.
class ScopeStack {
 public:
  explicit ScopeStack(const Tape& tape);

  /// Who knows where paints are of one colour; without it no paint is ever taken for plain.
  PaintSampler* sampler = nullptr;

  /// Everything: no outline decided.
  Scope everything();

  /// These layers alone, top to bottom, and the background: no outline decided.
  Scope of_layers(std::span<const int> layers);

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

  struct Layer {
    int first, count;  ///< steps; none: the layer covers the whole square
    Mix mix;
    int paint, group;  ///< as in TapeLayer
  };
  std::span<const Layer> layers(const Scope& scope) const {
    return {layers_.data() + scope.first_layer, std::size_t(scope.layer_count)};
  }

  /// The same where some layers are not plain: paint_color(i) is the colour there of the scope's
  /// layer i, which has a paint.
  template <class PaintColor>
  Mix color(const Scope& scope, PaintColor&& paint_color);

 private:
  void enter(int group);
  bool in_group(int group, int ancestor) const;
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
  std::vector<Mix> group_mix_;  ///< what is collected so far: outside of groups, in the outermost …
  int group_ = -1;              ///< the innermost group being collected
};

template <class PaintColor>
Mix ScopeStack::color(const Scope& scope, PaintColor&& paint_color) {
  group_mix_.assign(1, Mix{0.0});
  group_ = -1;
  for (int l = 0; l < scope.layer_count; ++l) {
    const Layer& layer = layers_[std::size_t(scope.first_layer + l)];
    if (!inside(layer)) continue;
    enter(layer.group);
    Mix& mix = group_mix_.back();
    if (mix.a < 1.0) mix = over(mix, layer.paint < 0 ? layer.mix : paint_color(l));
  }
  enter(-1);
  const Mix& mix = group_mix_.back();
  return mix.a < 1.0 ? over(mix, scope.base) : mix;
}

}  // namespace mien
