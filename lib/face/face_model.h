#pragma once
// The parts of a face that do not move: the meaning of its numbers, the features drawn from them, and the tables that pose
// them.

#include <mien/canvas.h>
#include <mien/control.h>
#include <mien/effect.h>
#include <mien/eye.h>
#include <mien/face_paint.h>
#include <mien/feature.h>
#include <mien/head_turn.h>
#include <mien/index.h>
#include <mien/layout.h>
#include <mien/motion.h>
#include <mien/mouth.h>
#include <mien/muscle.h>
#include <mien/names.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mien {

/// Invariants: every index is valid, every slice has the size of its kind (docs/face-format.md), and every
/// number of a table or curve is finite.
struct FaceModel {
  std::string name;
  std::string credit;
  Names names;  ///< of features, controls, muscles and expressions
  FaceCanvas canvas;
  Layout layout;
  int background = -1;            ///< slice of its colour
  std::vector<Feature> features;  ///< bottom to top
  std::vector<GradientPaint> gradients;
  std::vector<FaceRelief> reliefs;
  std::vector<FaceSurroundings> surroundings;
  std::vector<FaceGroup> groups;
  FaceLight light;
  std::vector<Channel> channels;  ///< in the order in which they act
  std::vector<Control> controls;
  MuscleSystem muscles;
  std::vector<Expression> expressions;  ///< emotions first; one at rest above 0 is the face's mood
  /// The face at rest minus its numbers in the file, which are without the mood: empty if it has none.
  FaceVector mood_shift;
  std::vector<Motion> clips;
  std::vector<Eye> eyes;
  std::optional<Mouth> mouth;
  HeadTurn turn;
  std::vector<Effect> effects;  ///< applied to the finished picture, in this order
  Index<Motion> default_clip;   ///< the clip that runs when a time is given
  /// What idle life draws from: seed_from_word of the code that the face was made from; without one, of its
  /// recipe or of its file's text.
  std::uint64_t seed = 0;
};

}  // namespace mien
