#pragma once
// Outline fonts.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/shape.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace mien {

/// One sign of a font: its loops with the pen's place on the line at the origin, in ems, y up.
struct Glyph {
  std::vector<Path::Loop> loops;
  double advance = 0;  ///< [em] to the next sign
};

/// A TrueType font, whose outlines are quadratic. Immutable, shared by its copies; any thread.
class MIEN_API Font {
 public:
  /// The one that ships with mien, DejaVu Sans: Latin, Greek, Cyrillic, punctuation, a few signs.
  static Font shipped();

  /// A file's first face. Errors: it cannot be read, is no font, or has outlines that are not
  /// quadratic.
  static Expected<Font> read(const std::filesystem::path& path);

  /// What the font draws for a character; for one that it does not have, its sign for that (a box).
  Glyph glyph(char32_t character) const;

  /// [em] by which the second of two neighbours moves; 0 mostly.
  double kerning(char32_t first, char32_t second) const;

  double ascent() const;   ///< [em] of the line above its base
  double descent() const;  ///< [em] below it, positive

  struct Data;

 private:
  explicit Font(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace mien
