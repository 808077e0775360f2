#pragma once
// A scene's layers prepared for drawing: their programs on outlines, and their paints on the grid of the whole
// picture's pixels.
//
// A gradient is smooth but for its stops, a relief's light but for the steps and the end of its
// profile. Each of these kinks is a line, and the line is an outline like any other: so no region has
// a kink inside it.

#include <mien/scene.h>
#include <mien/view.h>
#include "render/shade/light/lit_paint.h"
#include "render/shade/paint.h"
#include "render/shade/ramp/integral.h"
#include "sdf/outline/area_program.h"

#include <vector>

namespace mien {

/// Where a paint has a kink: a program that says whether a place lies before it.
struct PaintKink {
  AreaProgram program;
  bool after = false;  ///< the program says whether it lies beyond it
  double at;           ///< t of a gradient
};

/// A colour that varies from place to place.
struct VariedPaint {
  GridPaint paint;
  std::vector<PaintKink> kinks;    ///< of the ramp, rising; with an integral its ends alone
  bool by_integral = false;        ///< the ramp has more kinks than outlines are made of
  RampIntegral integral;           ///< of such a ramp
  double tolerance = 0;            ///< what a mean by integrals may be off by, encoded
  bool linear = false;             ///< it is in linear light
  double lowest = 0, highest = 0;  ///< t in the picture
  /// Its means are LitPaint's: it is lit or goes by a distance. Index into PaintTable::lit; −1: a ramp is all of it.
  int lit = -1;
  std::vector<AreaProgram> levels;  ///< of LitPaint, each as {distance <= level}
  std::vector<AreaProgram> domes;   ///< beyond all of them they do nothing
};

struct PaintedLayer {
  AreaProgram program;
  Mix mix{0.0};     ///< its colour, where that does not vary
  int varied = -1;  ///< index into PaintTable::varied; −1: it does not
  int group = -1;   ///< index into PaintTable::groups; −1: on its own
};

/// Layers that are composited first and then mixed with what is below as one: groups only that are translucent, mix
/// by a mode of their own, or are what such a group mixes with.
struct PaintedGroup {
  int parent;  ///< −1: none
  double opacity;
  MixMode mode;
};

struct PaintTable {
  AreaPrograms programs;
  std::vector<PaintedLayer> layers;  ///< bottom to top
  std::vector<VariedPaint> varied;
  std::vector<PaintedGroup> groups;  ///< parents first
  std::vector<AreaDistance> distances;
  std::vector<LitPaint> lit;
  Mix background{0.0};
  Blend blend = Blend::linear;

  PaintTable() = default;
  PaintTable(const PaintTable&) = delete;  // its lit paints refer to it
  PaintTable& operator=(const PaintTable&) = delete;

  /// Made anew; memory is kept where it can be.
  void make(const Scene& scene, const View& view, Depth depth);

 private:
  friend class PaintMaker;
  void make_lit(const Scene& scene, const View& view, Depth depth);
  void make_groups(const Scene& scene);

  std::vector<int> nearest_;   ///< by group of the scene: the painted one it is in
  std::vector<char> ground_;   ///< by group of the scene: whether a group in it mixes with it
  std::vector<int> distance_;  ///< by node of the scene: its distance's index; −1: none yet
  std::vector<int> place_;
  std::vector<double> kinks_;
};

/// Takes face units to the grid of the picture.
Map<GridSpace, FaceSpace> grid_from_face(const Canvas& canvas, const View& view);

}  // namespace mien
