#pragma once
// A face: a shared immutable model, and one vector of numbers of its own.
//
// Everything about a face that can move is in the vector. The model names its slices (layout), tells which
// features are drawn from which slices, and holds the tables that pose it (controls, key shapes, clips).
// Posing copies only the vector. Every Face is valid, because its file was checked when it was read.

#include <memory>
#include <vector>

namespace mien {

struct FaceModel;  // lib/face/face_model.h

/// The face vector; Layout tells what each number is.
using FaceVector = std::vector<double>;

struct Face {
  std::shared_ptr<const FaceModel> model;
  FaceVector vector;  ///< model->layout.size() numbers
};

}  // namespace mien
