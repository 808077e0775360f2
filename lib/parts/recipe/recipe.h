#pragma once
// What a face is made of: a part of each family, numbers, a style. Small enough to read.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face_code.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A part of one's own: a part file, read.
struct OwnPart {
  std::string path;  ///< what errors call it
  std::string text;
};

struct Recipe {
  std::string name;                          ///< of the face
  std::string code;                          ///< that it was made from; empty: of none
  std::map<std::string, std::string> parts;  ///< by family; families that are not there have none
  std::map<std::string, double> numbers;     ///< by name; others are at rest
  std::string style = "soft";
  std::map<std::string, OwnPart> own_parts;  ///< by what `parts` calls them, "fez.part.json"
};

/// The recipe of a seed.
MIEN_API Recipe recipe_from_seed(std::uint64_t seed);

/// The recipe of a code. The error names the held value that is not known.
MIEN_API Expected<Recipe> recipe_from_code(const FaceCode& code);

/// The same person without an expression: no smile, no mood, and for a mouth that grins or hangs one that does not. So
/// the lips are closed.
MIEN_API Recipe neutral_recipe(Recipe recipe);

/// The text of a face file, format version 1: parts are put together, and nothing of them is left. The
/// error names what is unknown or out of range, with the nearest known name.
MIEN_API Expected<std::string> face_text_from_recipe(const Recipe& recipe);

/// The recipe as a face file, format version 2: a few lines, for people to read and change.
MIEN_API std::string recipe_text(const Recipe& recipe);

/// A family of parts, as `mien parts` lists it.
struct PartFamily {
  std::string name;
  std::vector<std::string> parts;
  bool optional;  ///< a face may have none
};
MIEN_API std::vector<PartFamily> part_families();

/// A number that a recipe may hold.
struct PartNumber {
  std::string name;
  double lo, hi, rest;
};
MIEN_API std::vector<PartNumber> part_numbers();

MIEN_API std::vector<std::string> part_styles();

/// What a code can hold: the field's permanent number and the value's, from "hair=bob" or
/// "eye.size=1.05". `clamp`: values out of range are taken as the nearer end.
MIEN_API Expected<HeldValue> read_held_value(std::string_view text, bool clamp = false);

}  // namespace mien
