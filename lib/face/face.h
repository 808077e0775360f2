#pragma once
// What a face is: an immutable model, shared, and ONE vector of numbers, its own.
//
// Everything about a face that can move is in the vector; the model names its slices (layout), says
// which features are drawn from which slices, and holds the tables that pose it (controls, key
// shapes, clips). Posing copies the vector alone. A Face that exists is valid: its file was checked
// when it was read.

#include <memory>
#include <vector>

namespace mien {

struct FaceModel;  // lib/face/face_model.h

/// The face vector: see Layout for what each number is.
using FaceVector = std::vector<double>;

struct Face {
  std::shared_ptr<const FaceModel> model;
  FaceVector vector;  ///< model->layout.size() numbers
};

}  // namespace mien
