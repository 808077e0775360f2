#include <mien/render/shade/lit_mean.h>
#include <mien/render/shade/lit_paint.h>
#include <mien/render/shade/lit_tile.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace mien {
namespace {

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

int floor_to_tile(int x) {
  return x & ~(LitTile::kSide - 1);
}

/// Whether a part is what the zone's own ends leave of the pixel: has its area, and its depth.
bool is_own_part(const LitTile& t, int column, int row, float area, glm::vec2 off) {
  constexpr float kAreaApart = 0.01f, kDepthApart = 0.01f;
  const auto k = std::size_t(row * LitTile::kSide + column);
  if (t.trust[k] == LitTile::Trust::none || std::abs(t.area[k] - area) > kAreaApart) return false;
  if (!t.rises) return false;
  const auto at = std::size_t((row + 1) * LitTile::kRow + column + 1);
  const float out = off.x * t.nx[at] + off.y * t.ny[at],
              aside = off.y * t.nx[at] - off.x * t.ny[at];
  const float d = t.d[at] + out + 0.5f * t.bend[at] * aside * aside;
  return std::abs(-d - t.depth[k]) < kDepthApart && std::abs(aside * t.bend[at]) < 0.01f;
}

/// The mean of a part of a pixel that the middles around it tell well, to second order: what is left
/// of the pixel is taken to spread as it would if it kept its form.
glm::vec3 smooth_part(const LitTile& t, int column, int row, float area, glm::vec2 off) {
  const auto at = std::size_t((row + 1) * LitTile::kRow + column + 1),
             below = std::size_t(LitTile::kRow);
  const auto of = [&](const auto& c) {
    const float x = c[at + 1] - c[at - 1], y = c[at + below] - c[at - below];
    const float xx = c[at + 1] + c[at - 1] - 2.0f * c[at];
    const float yy = c[at + below] + c[at - below] - 2.0f * c[at], spread = area / 24.0f;
    return c[at] + 0.5f * (x * off.x + y * off.y) + xx * (spread + 0.5f * off.x * off.x) +
           yy * (spread + 0.5f * off.y * off.y);
  };
  return {of(t.r), of(t.g), of(t.b)};
}

}  // namespace

/// Tiles by paint, zone and column: those of the row of tiles that was asked for last.
struct LitPaint::Scratch::Kept {
  static constexpr std::size_t kTiles = 512;
  std::vector<std::unique_ptr<LitTile>> tiles{kTiles};
  LitPixel pixel;
};

LitPaint::Scratch::Scratch() : kept_(std::make_unique<Kept>()) {}
LitPaint::Scratch::~Scratch() = default;
LitPaint::Scratch::Scratch(Scratch&&) noexcept = default;
LitPaint::Scratch& LitPaint::Scratch::operator=(Scratch&&) noexcept = default;

LitPaint::LitPaint(const TapePaint& paint, std::span<const AreaDistance> distances, Blend blend,
                   glm::dvec2 center, double tolerance)
    : surface_(paint, distances, blend, center), tolerance_(tolerance), id_(next_id()) {
  if (surface_.area()) area_ = FeetArea(*surface_.area(), center);
}

bool LitPaint::level(int zone) const {
  return surface_.relief().domes.empty() && surface_.flat(zone);
}

/// The tile that has pixel (x, y), made if it is not there.
LitTile& LitPaint::tile(int zone, int x, int y, Scratch& scratch) const {
  const int left = floor_to_tile(x), top = floor_to_tile(y);
  const std::uint64_t column = std::uint64_t(left / LitTile::kSide);
  const std::uint64_t hash = (id_ * 8 + std::uint64_t(zone)) * 0x9E3779B97F4A7C15u;
  auto& slot = scratch.kept_->tiles[std::size_t((column + (hash >> 40)) % Scratch::Kept::kTiles)];
  if (!slot) slot = std::make_unique<LitTile>();
  LitTile& t = *slot;
  if (t.paint == id_ && t.zone == zone && t.x == left && t.y == top) return t;
  t.paint = id_, t.zone = zone, t.x = left, t.y = top;
  constexpr double kRadius = 13.0;  // of the tile, and what cells beside it need
  const glm::dvec2 middle = glm::dvec2{left, top} + 0.5 * LitTile::kSide;
  set_lamp(surface_, zone, middle, kRadius, t.lamp);
  t.rises = !surface_.flat(zone);
  t.kind = t.rises || !t.lamp.domes.empty() ? LitTile::Kind::means : LitTile::Kind::base;
  if (t.kind == LitTile::Kind::base) return t;
  const auto levels = surface_.levels();
  t.shallow = zone > 0 ? float(-levels[std::size_t(zone) - 1]) : -1e9f;
  t.deep = std::size_t(zone) < levels.size() ? float(-levels[std::size_t(zone)]) : 1e9f;
  if (t.rises) {
    t.feet.narrow(area_, middle, kRadius);
    std::array<float, LitTile::kPadded> px, py;
    for (int i = 0; i < LitTile::kPadded; ++i) {
      px[std::size_t(i)] = float(i % LitTile::kRow) - 8.5f;
      py[std::size_t(i)] = float(i / LitTile::kRow) - 8.5f;
    }
    t.feet.at(px, py, {t.d.data(), t.nx.data(), t.ny.data(), t.bend.data()});
  }
  shade_tile(t, float(tolerance_));
  return t;
}

void LitPaint::pixels(int zone, int x, int y, int count, float* r, float* g, float* b, float* a,
                      Scratch& scratch) const {
  scratch.error_ = tolerance_;
  const Mix& base = surface_.paint().color;
  if (sure_way()) {
    for (int i = 0; i < count; ++i) {
      const Mix mean = square_mean(surface_, zone, {x + i, y}, 1.0, 0.3 * tolerance_ / 255.0);
      r[i] = float(mean.r), g[i] = float(mean.g), b[i] = float(mean.b), a[i] = float(mean.a);
    }
    return;
  }
  std::fill_n(a, count, float(base.a));
  for (int i = 0; i < count;) {
    LitTile& t = tile(zone, x + i, y, scratch);
    const int column = x + i - t.x, row = y - t.y;
    const int n = std::min(count - i, LitTile::kSide - column);
    const std::size_t from = std::size_t(row * LitTile::kSide + column);
    if (t.kind == LitTile::Kind::base) {
      std::fill_n(r + i, n, float(base.r)), std::fill_n(g + i, n, float(base.g));
      std::fill_n(b + i, n, float(base.b));
      i += n;
      continue;
    }
    std::copy_n(&t.mean_r[from], n, r + i), std::copy_n(&t.mean_g[from], n, g + i);
    std::copy_n(&t.mean_b[from], n, b + i);
    for (int k = 0; k < n; ++k) {
      if (t.trust[from + std::size_t(k)] != LitTile::Trust::none) continue;
      const LitPixel::Place place{&t.lamp, t.rises ? &t.feet : nullptr, t.shallow, t.deep};
      const glm::vec3 mean = scratch.kept_->pixel.whole(place, t.middle(column + k, row));
      r[i + k] = mean.r, g[i + k] = mean.g, b[i + k] = mean.b;
    }
    i += n;
  }
}

glm::vec4 LitPaint::part(int zone, int x, int y, double area, glm::dvec2 centroid,
                         Scratch& scratch) const {
  scratch.error_ = tolerance_;
  const Mix& base = surface_.paint().color;
  if (sure_way()) return glm::vec4(part_mean(surface_, zone, {x, y}, area, centroid, 10));
  LitTile& t = tile(zone, x, y, scratch);
  if (t.kind == LitTile::Kind::base) return glm::vec4(base);
  const glm::vec2 off{centroid - glm::dvec2{x + 0.5, y + 0.5}};
  const int column = x - t.x, row = y - t.y;
  const auto k = std::size_t(row * LitTile::kSide + column);
  if (t.trust[k] == LitTile::Trust::around)
    return {smooth_part(t, column, row, float(area), off), float(base.a)};
  if (is_own_part(t, column, row, float(area), off)) {
    return {t.mean_r[k], t.mean_g[k], t.mean_b[k], float(base.a)};
  }
  const LitPixel::Place place{&t.lamp, t.rises ? &t.feet : nullptr, t.shallow, t.deep};
  const glm::vec3 mean = scratch.kept_->pixel.part(place, t.middle(column, row), float(area), off);
  return {mean, float(base.a)};
}

}  // namespace mien
