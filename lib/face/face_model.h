#pragma once
// Everything about a face that does not move: what its numbers are, what is drawn from them, what
// poses them.

#include <mien/canvas.h>
#include <mien/clip.h>
#include <mien/control.h>
#include <mien/effect.h>
#include <mien/eye.h>
#include <mien/face_paint.h>
#include <mien/feature.h>
#include <mien/head_turn.h>
#include <mien/layout.h>
#include <mien/muscle.h>

#include <string>
#include <vector>

namespace mien {

/// Invariant: every index points at what it says, every slice has its kind's size
/// (docs/face-format.md), every number of a table or curve is finite.
struct FaceModel {
  std::string name;
  std::string credit;
  FaceCanvas canvas;
  Layout layout;
  int background = -1;            ///< slice of its colour
  std::vector<Feature> features;  ///< bottom to top
  std::vector<GradientPaint> gradients;
  std::vector<FaceRelief> reliefs;
  std::vector<FaceSurroundings> surroundings;
  std::vector<FaceGroup> groups;
  FaceLight light;
  std::vector<Channel> channels;  ///< act in this order
  std::vector<Control> controls;
  MuscleSystem muscles;
  std::vector<Expression> expressions;  ///< emotions first
  std::vector<Clip> clips;
  std::vector<Eye> eyes;
  HeadTurn turn;
  std::vector<Effect> effects;  ///< laid over the finished picture, in this order
  int default_clip = -1;        ///< the clip that runs when a time is given; −1: none
};

}  // namespace mien
