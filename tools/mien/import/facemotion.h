#pragma once
// Importer for the faces of facemotion.js (P. Mandel, 2014): from its morphology file, a JavaScript
// object literal, to the text of a mien face file. The literal is read as data; nothing is
// executed.
//
//   const auto text = mien::face_text_from_facemotion(javascript, "morphologies.js");
//
// The face file has the same features, muscles and recipes under the same names, and tables of
// standard names (docs/rig.md) for the muscles that it has.

#include <mien/expected.h>
#include <mien/face_file.h>

#include <string>
#include <string_view>

namespace mien {

struct FacemotionOptions {
  std::string morphology;  ///< which one, if the file has several
  bool smooth = false;     ///< draw polylines as smooth curves
  FaceLimits limits;
};

/// Strict: an unknown key, feature, attachment or muscle is an error that names the nearest known one.
/// Its `where` is "NAME:LINE:COLUMN: /pointer".
Expected<std::string> face_text_from_facemotion(std::string_view text,
                                                std::string_view name = "morphologies",
                                                const FacemotionOptions& options = {});

}  // namespace mien
