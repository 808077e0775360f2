#pragma once
// Emotions, muscles and standard names as people type them: "joy=0.8", "left.joy=0.4", "zygomaticus".

#include <mien/pose.h>

#include <string>
#include <string_view>

namespace mien {

/// What becomes of a strength below 0 or above 1.
enum class OutOfRange { refuse, clamp };

/// Reads "NAME=VALUE", or "NAME" for 1, against the names of one set of a face: "emotion", "muscle",
/// "arkit", …; "left.NAME" and "right.NAME" mean one side. Errors: a face without that set, an unknown
/// name (with the nearest known one), no number, a number out of 0 … 1 if that is refused. The
/// error's `where` is the text itself.
Expected<Setting> read_expression(const Face& face, std::string_view set, std::string_view text,
                                  OutOfRange out = OutOfRange::refuse);

}  // namespace mien
