#pragma once
// A scene of more layers than one sweep should hold, drawn window by window.
//
// A sweep costs what its outlines cross, hidden or not; of ten thousand discs next to nothing is
// seen. So a strip of rows is halved until few layers are left in a window: one that a distance puts
// outside it is left out, and all that lies below one that covers it. What is left is a scene of its
// own, drawn like any other. Windows lie at absolute places: pixels do not depend on what is asked
// for.

#include <mien/render/view/view.h>
#include <mien/sdf/scene/part.h>

#include <functional>
#include <span>
#include <vector>

namespace mien {

/// A window and the scene of what is seen in it; its canvas is the window.
struct CrowdWindow {
  PixelRect rect;
  Scene scene;
  View view;
};

/// Scratch of one thread.
struct CrowdScratch {
  ScenePart part;
  std::vector<std::vector<int>> lists;  ///< of layers, by how often a strip is halved
};

class Crowd {
 public:
  /// Layers from which on a scene is one: more than any face has.
  static constexpr std::size_t kMany = 2000;

  static bool is_one(const Scene& scene) { return scene.layers().size() >= kMany; }

  void make(const Scene& scene, const View& view);

  /// The windows of the rows from `top` to `bottom` that show some of `wanted`.
  void each_window(int top, int bottom, const PixelRect& wanted, CrowdScratch& scratch,
                   const std::function<void(const CrowdWindow&)>& draw) const;

 private:
  struct Seen {
    Box2 box;  ///< [px]
    bool opaque;
  };
  void halve(const PixelRect& rect, const PixelRect& wanted, std::size_t depth,
             CrowdScratch& scratch, const std::function<void(const CrowdWindow&)>& draw) const;
  void look(const PixelRect& rect, std::span<const int> among, std::vector<int>& seen) const;
  CrowdWindow window(const PixelRect& rect, std::span<const int> layers,
                     CrowdScratch& scratch) const;

  Scene scene_;
  View view_;
  Map<FaceSpace, GridSpace> face_from_grid_;
  std::vector<Seen> layers_;
};

}  // namespace mien
