#pragma once
// Outline fonts.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/shape.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace mien {

/// One glyph: its loops in ems, y up, with the pen position at the origin.
struct Glyph {
  std::vector<Path::Loop> loops;
  double advance = 0;  ///< [em] to the next glyph
};

/// A TrueType font, whose outlines are quadratic. Immutable, shared by its copies, safe on any thread.
class MIEN_API Font {
 public:
  /// The font that ships with mien, DejaVu Sans: Latin, Greek, Cyrillic, punctuation, a few symbols.
  static Font shipped();

  /// The first face of a font file. Errors: it cannot be read, is no font, or its outlines are not
  /// quadratic.
  static Expected<Font> read(const std::filesystem::path& path);

  /// Whether it has a glyph of its own for a character.
  bool has(char32_t character) const;

  /// The glyph of a character; for a character that the font lacks, its replacement glyph (a box).
  Glyph glyph(char32_t character) const;

  /// [em] The kerning of two neighbours, by which the second one moves; mostly 0.
  double kerning(char32_t first, char32_t second) const;

  double ascent() const;   ///< [em] height of the line above the baseline
  double descent() const;  ///< [em] depth below it, positive

  struct Data;

 private:
  explicit Font(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace mien
