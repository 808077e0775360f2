#pragma once
// A person given on the command line as the code that stands for them.

#include <mien/expected.h>
#include <mien/face_code.h>

#include <string>
#include <vector>

namespace mien::command {

/// The code itself, or that of a recipe's file. Warnings tell what of a recipe no code can hold: a style, parts of one's
/// own, and where a number lies between two steps.
Expected<FaceCode> code_of_person(const std::string& given, std::vector<Error>* warnings);

}  // namespace mien::command
