#include "tools/accuracy/methods/freetype_field.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MODULE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace mien::accuracy {
namespace {

/// A slot for glyphs belongs to a font, so there is one, of a single dot.
constexpr std::string_view kFont =
    "STARTFONT 2.1\nFONT -mien-dot-medium-r-normal--1-10-75-75-c-10-iso10646-1\nSIZE 1 75 "
    "75\nFONTBOUNDINGBOX 1 1 0 0\n"
    "STARTPROPERTIES 2\nFONT_ASCENT 1\nFONT_DESCENT 0\nENDPROPERTIES\nCHARS 1\nSTARTCHAR "
    "dot\nENCODING 46\n"
    "SWIDTH 1000 0\nDWIDTH 1 0\nBBX 1 1 0 0\nBITMAP\n80\nENDCHAR\nENDFONT\n";

/// Points of the curve, there and back; none for what is no Bézier curve.
std::vector<glm::dvec2> there_and_back(const Case& k) {
  if (const auto* c = std::get_if<QuadBezier>(&k.figure)) return {c->p0, c->p1, c->p2, c->p1};
  if (const auto* c = std::get_if<CubicBezier>(&k.figure))
    return {c->p0, c->p1, c->p2, c->p3, c->p2, c->p1};
  return {};
}

double size_of(const std::vector<glm::dvec2>& points) {
  const auto extent = [&](auto coordinate) {
    const auto less = [&](glm::dvec2 a, glm::dvec2 b) { return a.*coordinate < b.*coordinate; };
    const auto [lo, hi] = std::minmax_element(points.begin(), points.end(), less);
    return (*hi).*coordinate - (*lo).*coordinate;
  };
  return points.empty() ? 0 : std::max(extent(&glm::dvec2::x), extent(&glm::dvec2::y));
}

/// The middle of pixel (0, 0), in 64ths.
constexpr FT_Pos kMiddle = 32;

/// The points with k.p in kMiddle, the curve `size` pixels large.
std::vector<FT_Vector> in_pixels(const std::vector<glm::dvec2>& points, glm::dvec2 p, int size) {
  const double scale = size * 64.0 / size_of(points);
  std::vector<FT_Vector> out;
  for (const glm::dvec2 point : points) {
    const glm::dvec2 at = (point - p) * scale;
    out.push_back({std::lround(at.x) + kMiddle, std::lround(at.y) + kMiddle});
  }
  return out;
}

}  // namespace

struct FreetypeField::Library {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Library() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }

  /// Draws into the slot's bitmap.
  bool draw(std::vector<FT_Vector>& points, FT_UInt spread) {
    std::vector<char> tags(points.size(), FT_CURVE_TAG_CUBIC);
    if (points.size() == 4) std::fill(tags.begin(), tags.end(), char(FT_CURVE_TAG_CONIC));
    tags[0] = tags[points.size() / 2] = FT_CURVE_TAG_ON;
    short last = short(points.size() - 1);
    FT_GlyphSlot slot = face->glyph;
    slot->format = FT_GLYPH_FORMAT_OUTLINE;
    slot->outline = {};
    slot->outline.n_contours = 1, slot->outline.n_points = short(points.size());
    slot->outline.points = points.data(), slot->outline.contours = &last;
    slot->outline.tags = reinterpret_cast<decltype(slot->outline.tags)>(tags.data());
    const bool drawn = FT_Property_Set(library, "sdf", "spread", &spread) == 0 &&
                       FT_Render_Glyph(slot, FT_RENDER_MODE_SDF) == 0;
    slot->outline = {};
    return drawn;
  }
};

FreetypeField::FreetypeField() : library_(std::make_shared<Library>()) {
  Library& its = *library_;
  if (FT_Init_FreeType(&its.library) != 0) throw std::runtime_error("FreeType does not start");
  if (!FT_Get_Module(its.library, "sdf"))
    throw std::runtime_error("this FreeType has no module 'sdf', which came with 2.11");
  if (FT_New_Memory_Face(its.library, reinterpret_cast<const FT_Byte*>(kFont.data()),
                         FT_Long(kFont.size()), 0, &its.face) != 0)
    throw std::runtime_error("this FreeType reads no BDF fonts, one of which the field needs");
}

bool FreetypeField::can_draw(const Case& k) {
  return size_of(there_and_back(k)) > 0;
}

std::optional<double> FreetypeField::distance(const Case& k, FieldSetting setting) {
  std::vector<FT_Vector> points = in_pixels(there_and_back(k), k.p, setting.size);
  pixels_ = 0;
  if (!library_->draw(points, FT_UInt(setting.spread))) return {};
  const FT_GlyphSlot slot = library_->face->glyph;
  const FT_Bitmap& field = slot->bitmap;
  pixels_ = std::size_t(field.width) * field.rows;
  const int column = -slot->bitmap_left, row = slot->bitmap_top - 1;
  if (column < 0 || row < 0 || column >= int(field.width) || row >= int(field.rows)) return {};
  const int byte = field.buffer[row * field.pitch + column];
  const int steps = std::abs(byte - 128);
  if (steps >= 127) return {};
  return (steps + 0.5) * setting.step();
}

}  // namespace mien::accuracy
