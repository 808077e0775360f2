#pragma once
// A layer's lit paint, ready to give means over pixels and parts of pixels.
//
//   LitPaint head(paint, table.distances, view.blend, {width / 2.0, height / 2.0}, 0.3);
//   head.pixels(1, x, y, count, r, g, b, a, scratch);         // whole pixels of a row
//   glm::vec4 edge = head.part(1, x, y, form, scratch);
//
// Every answer depends on the paint and the pixel alone: not on earlier questions, nor on scratch, region or
// thread.

#include "render/cover/part_form.h"
#include "render/shade/light/lit_surface.h"
#include "render/shade/nearest/feet_area.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace mien {

struct LightTile;
struct LitPart;

class LitPaint {
 public:
  /// What an answer may be off by, of what a pixel may be; 1 and more where branches were too many for any tile.
  struct Doubt {
    int column = 0;
    float off = 0;
  };

  /// What is kept between questions, of all paints. One per thread.
  class Scratch {
   public:
    Scratch();
    ~Scratch();
    Scratch(Scratch&&) noexcept;
    Scratch& operator=(Scratch&&) noexcept;

    /// The feet that were looked for since it was last taken, and about the time that means took with them.
    struct Work {
      long long feet = 0;
      double seconds = 0;
    };
    Work take_work();

    /// What answers since the caller emptied it may be off by. All in a column add up: where that is more than a
    /// pixel may be off by, it wants the reference.
    std::vector<Doubt>& doubts();

   private:
    friend class LitPaint;
    struct Kept;
    std::unique_ptr<Kept> kept_;
  };

  /// Refers to the paint and the distances. `center`: where their origin lies in the picture, whose own is its top
  /// left corner, y down. `tolerance`: the permitted error of a mean, in levels of 255.
  LitPaint(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
           glm::dvec2 center, double tolerance = 0.3) {
    make(paint, distances, blend, center, tolerance, 0);
  }
  LitPaint() = default;

  /// Made anew; memory is kept. `index`: among the picture's lit paints; scratch keeps what belongs to one index in
  /// the same places from frame to frame.
  void make(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
            glm::dvec2 center, double tolerance, int index);

  /// The depths (signed distances, falling, in px) at which the profile has a kink. Zone k lies
  /// between level k − 1 and level k: zone 0 is outside, the last one the plateau. No levels: one
  /// zone.
  std::span<const double> levels() const { return surface_.levels(); }

  /// What its means are means of.
  const LitSurface& surface() const { return surface_; }

  /// Whether the surface is level in all of a zone: then it has its base colour there.
  bool level(int zone) const;
  /// The same but for its domes.
  bool flat(int zone) const { return surface_.flat(zone); }

  /// What the paint's gradient goes by, if that is a distance.
  const FeetArea& gradient_area() const { return gradient_area_; }

  /// Means of `count` whole pixels of row y from x on, all of that piece: premultiplied, in the
  /// blending space, to four planes.
  void pixels(const LitPiece& piece, int x, int y, int count, float* r, float* g, float* b,
              float* a, Scratch& scratch) const;

  /// The mean over a part of pixel (x, y) that lies in that piece.
  glm::vec4 part(const LitPiece& piece, int x, int y, const LitPart& part, Scratch& scratch) const;

  /// Colours at the centroids of a pixel's cells, each evaluated by itself; else the mean over the form, or over
  /// the whole pixel without one, for all of them.
  void colors_of_cells(const LitPiece& piece, int x, int y, const PartCells& cells,
                       const LitPart* part, bool each, std::span<float> r, std::span<float> g,
                       std::span<float> b, std::span<float> a, Scratch& scratch) const;

 private:
  /// The tile that has pixel (x, y), made if it is not there; none, and noted, where branches are too many for any.
  LightTile* tile(const LitPiece& piece, int x, int y, Scratch& scratch) const;
  void make_tile(const LitPiece& piece, LightTile& tile, bool on_new_ground) const;
  LitSurface surface_;
  FeetArea area_, gradient_area_;
  double tolerance_ = 0.3;
  int index_ = 0;
  std::uint64_t id_ = 0;  ///< of this paint and no other, ever
};

}  // namespace mien
