#pragma once
// A crowd in which no two people look alike.

#include <mien/api.h>
#include <mien/face_code.h>

#include <string_view>
#include <vector>

namespace mien {

/// So many people of a word, each at least 3.5 (`difference`) from the 200 before. Where none of the 64 tried for
/// a place is that far, the farthest of them is taken. The first n are the same in every crowd of the word.
MIEN_API std::vector<FaceCode> crowd(std::string_view word, int count);

}  // namespace mien
