#pragma once
// A scene of more layers or shapes than one sweep should hold, drawn window by window.
//
// The cost of a sweep grows with the crossings of its outlines, hidden or not, and of ten thousand discs next to
// nothing is seen; what it holds grows with its regions, each a set of outlines. So a strip of rows is halved until few
// layers and shapes are left in each window: shapes that their distance puts outside it, or all around it, are left
// out of the expressions that say where layers are (render/reference/layer_logic.h), and so is all that lies below a
// layer that covers it. The rest is a scene of its own, drawn like any other. Windows lie at absolute places: pixels do not depend on what is asked for.
//
// Layers of opacities a, b … that each cover a window let (1 − a)(1 − b) … through. Layers below them change no
// channel by more than that, as premultiplied colours lie in [0, 1] and the picture is linear in each layer's, by
// whatever mode groups above mix. Where that is less than kUnseen of a pixel's
// permitted error, encoded at its steepest, the background replaces them.

#include <mien/image.h>
#include <mien/view.h>
#include "render/reference/layer_logic.h"
#include "sdf/scene/part.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace mien {

/// A window and the scene of what is seen in it; its canvas is the window.
struct CrowdWindow {
  PixelRect rect;
  Scene scene;
  View view;
  double left_out = 0;  ///< what layers that are left out may change a channel by, encoded, of 1
};

/// Scratch of one thread.
struct CrowdScratch {
  ScenePart part;
  std::optional<LayerLogic> logic;  ///< a copy of the crowd's
  std::vector<PartLayer> layers;
  std::vector<PartStep> steps;
};

class Crowd {
 public:
  /// A scene of so many layers or shapes, or more, is a crowd: more than any face has.
  static constexpr std::size_t kMany = 2000;

  /// Share of a pixel's permitted error (a level of 255, or 32 of 65535) by which left out layers may change it.
  static constexpr double kUnseen = 0.125;

  static bool is_one(const Scene& scene) {
    return std::max(scene.layers().size(), scene.shapes().size()) >= kMany;
  }

  void make(const Scene& scene, const View& view, Depth depth);

  /// The windows of the rows from `top` to `bottom` that show some of `wanted`.
  void each_window(int top, int bottom, const PixelRect& wanted, CrowdScratch& scratch,
                   const std::function<void(const CrowdWindow&)>& draw) const;

 private:
  using Scope = LayerLogic::Scope;
  void halve(const PixelRect& rect, const PixelRect& wanted, const Scope& outer,
             CrowdScratch& scratch, const std::function<void(const CrowdWindow&)>& draw) const;
  Scope look(const PixelRect& rect, const Scope& outer, LayerLogic& logic) const;
  Reach reach(const LevelSet& set, const Box2& box, const PixelRect& rect) const;
  CrowdWindow window(const PixelRect& rect, const Scope& scope, CrowdScratch& scratch) const;

  Scene scene_;
  View view_;
  Map<FaceSpace, GridSpace> face_from_grid_;
  std::optional<LayerLogic> logic_;
  std::vector<Box2> boxes_;      ///< [px] by set
  std::vector<double> through_;  ///< by layer: what of those below shows through it, at most
  /// Where less light than this shows through what covers a window, the rest is left out.
  double unseen_ = 0;
};

}  // namespace mien
