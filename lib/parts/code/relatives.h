#pragma once
// Codes out of codes: people like somebody, between two people, children of two.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face_code.h>

namespace mien {

/// Somebody like the person of a code. `by`, from 0 to 1: how far numbers go, of half their range, and how
/// likely half of the parts are others. Different seeds are different people.
MIEN_API Expected<FaceCode> code_near(const FaceCode& code, double by, std::uint64_t seed);

/// From one person (0) to another (1): numbers go evenly, each part changes at a place of its own.
MIEN_API Expected<FaceCode> code_between(const FaceCode& from, const FaceCode& to, double at);

/// A child of two: each part and number is one parent's, numbers a little beside it, at an age of 5 to 15.
MIEN_API Expected<FaceCode> code_of_child(const FaceCode& one, const FaceCode& other,
                                          std::uint64_t seed);

/// How different two people look, about 1 for other hair; people of one crowd differ by 3.5.
MIEN_API Expected<double> difference(const FaceCode& one, const FaceCode& other);

}  // namespace mien
