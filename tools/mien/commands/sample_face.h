#pragma once
// The faces that come with mien, by their names.

#include <string>

namespace mien::command {

/// The file of a sample face, for its name: where it is installed, or in the tree that the program was built in. Any other text
/// comes back as it is, and so does the name of a file that is there.
std::string sample_face_path(const std::string& text);

}  // namespace mien::command
