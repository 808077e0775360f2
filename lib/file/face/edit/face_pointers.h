#pragma once
// Where in a face's file each of its named values stands, as JSON pointers (RFC 6901).
//
//   brow.left/spine/1    /features/12/spine/1
//   palette/skin         /palette/skin

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face_limits.h>
#include <mien/letters.h>

#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// The pointers of a face file's text, one for each of settable_names(), in its order. Two sides that the file writes
/// once have the same one. It is empty where the file does not hold the value: of controls, whose values are poses; of
/// derived numbers, such as the shifts of lids; and of all names of a recipe (format version 2), whose numbers are made of
/// parts. Errors as for read_face_text.
MIEN_API Expected<std::vector<std::string>> face_pointers(std::string_view text,
                                                          std::string_view name = "face",
                                                          const FaceLimits& limits = {},
                                                          const Letters& letters = {});

}  // namespace mien
