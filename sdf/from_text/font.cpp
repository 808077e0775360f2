#include <mien/font.h>
#include "lib/base/memory_ran_out.h"
#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_FONT_FORMATS_H
#include FT_OUTLINE_H

#include <cstdio>
#include <mutex>
#include <new>
#include <string>

#include "shipped_font_private.h"

namespace mien {
namespace {

constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of a font file; large ones have 30 MB

/// FreeType's walk along an outline, collected as closed loops of quadratics in ems.
struct Walk {
  std::vector<Path::Loop> loops;
  glm::dvec2 at{}, begin{};
  double em = 1;

  glm::dvec2 point(const FT_Vector* p) const { return {double(p->x) / em, double(p->y) / em}; }

  void line(glm::dvec2 to) {
    if (to != at) loops.back().sides.push_back({at, 0.5 * (at + to), to});
    at = to;
  }
  void close() {
    if (loops.empty()) return;
    line(begin);
    if (loops.back().sides.empty()) loops.pop_back();
  }

  static Walk& of(void* user) { return *static_cast<Walk*>(user); }
  static int move_to(const FT_Vector* to, void* user) {
    Walk& walk = of(user);
    walk.close();
    walk.loops.emplace_back();
    walk.begin = walk.at = walk.point(to);
    return 0;
  }
  static int line_to(const FT_Vector* to, void* user) {
    of(user).line(of(user).point(to));
    return 0;
  }
  static int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
    Walk& walk = of(user);
    walk.loops.back().sides.push_back({walk.at, walk.point(control), walk.point(to)});
    walk.at = walk.point(to);
    return 0;
  }
  static int cubic_to(const FT_Vector*, const FT_Vector*, const FT_Vector*, void*) { return 1; }
};

constexpr FT_Outline_Funcs kWalk{
    Walk::move_to, Walk::line_to, Walk::conic_to, Walk::cubic_to, 0, 0};

}  // namespace

/// FreeType's face is for one thread at a time.
struct Font::Data {
  std::vector<unsigned char> bytes;  // of a file; FreeType keeps reading from them
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  mutable std::mutex mutex;

  Data() {
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  ~Data() {
    if (face) FT_Done_Face(face);
    FT_Done_FreeType(library);
  }

  bool open(const unsigned char* data, std::size_t size) {
    return FT_New_Memory_Face(library, data, FT_Long(size), 0, &face) == 0;
  }
};

Font::Font(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Font Font::shipped() {
  static const Font font = [] {
    auto data = std::make_shared<Data>();
    if (!data->open(kShippedFont, kShippedFontSize)) throw std::bad_alloc();
    return Font(std::move(data));
  }();
  return font;
}

Expected<Font> Font::read(const std::filesystem::path& path) try {
  const auto refuse = [&](const std::string& what) { return Error{one_line(path.string()), what}; };
  try {
    auto bytes = read_bytes(path, kMostBytes);
    if (!bytes) return bytes.error();
    auto data = std::make_shared<Data>();
    data->bytes.assign(bytes->begin(), bytes->end());
    if (!data->open(data->bytes.data(), data->bytes.size()))
      return refuse("is no font that FreeType can read");
    if (std::string(FT_Get_Font_Format(data->face)) != "TrueType" || !FT_IS_SCALABLE(data->face))
      return refuse("has no quadratic outlines: mien takes TrueType fonts");
    return Font(std::move(data));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return refuse(std::string("cannot be read: ") + failure.what());
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

bool Font::has(char32_t character) const {
  const std::lock_guard lock(data_->mutex);
  return FT_Get_Char_Index(data_->face, character) != 0;
}

Glyph Font::glyph(char32_t character) const {
  const std::lock_guard lock(data_->mutex);
  FT_Face face = data_->face;
  const FT_UInt index = FT_Get_Char_Index(face, character);
  if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0) return {};
  Walk walk;
  walk.em = face->units_per_EM;
  if (FT_Outline_Decompose(&face->glyph->outline, &kWalk, &walk) != 0) return {};
  walk.close();
  return {std::move(walk.loops), double(face->glyph->metrics.horiAdvance) / walk.em};
}

double Font::kerning(char32_t first, char32_t second) const {
  const std::lock_guard lock(data_->mutex);
  FT_Face face = data_->face;
  FT_Vector by{};
  const FT_UInt a = FT_Get_Char_Index(face, first), b = FT_Get_Char_Index(face, second);
  if (FT_Get_Kerning(face, a, b, FT_KERNING_UNSCALED, &by) != 0) return 0;
  return double(by.x) / face->units_per_EM;
}

double Font::ascent() const {
  return double(data_->face->ascender) / data_->face->units_per_EM;
}

double Font::descent() const {
  return -double(data_->face->descender) / data_->face->units_per_EM;
}

}  // namespace mien
