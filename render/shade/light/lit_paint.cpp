#include "render/shade/light/lit_paint.h"
#include "render/shade/light/lit_mean.h"
#include "render/shade/light/lit_tile.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace mien {
namespace {

constexpr double kRadius = 13.0;  // [px] of a tile, and what cells beside it need

/// The feet at the middles of a tile's pixels and of those around it.
void find_feet(LitTile& t) {
  constexpr std::size_t kCount = (LitTile::kBlocks * LitTile::kBlocks + 15) / 16 * 16;
  std::array<float, kCount> px, py;
  for (int i = 0; i < int(kCount); ++i) {
    px[std::size_t(i)] = float(2 * (i % LitTile::kBlocks)) - 8.0f;
    py[std::size_t(i)] = float(2 * std::min(i / LitTile::kBlocks, LitTile::kBlocks - 1)) - 8.0f;
  }
  t.feet.at(px, py, {t.block_d.data(), t.block_nx.data(), t.block_ny.data(), t.block_bend.data()});
  spread_feet(t);
}

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

int floor_to_tile(int x) {
  return x & ~(LitTile::kSide - 1);
}

/// The mean over a part of a pixel where the middles around it suffice, to second order.
glm::vec3 smooth_part(const LitTile& t, int column, int row, const PartForm& form) {
  PartCells cells;
  cells_of_form(form, 4, cells);
  const auto at = std::size_t((row + 1) * LitTile::kRow + column + 1),
             below = std::size_t(LitTile::kRow);
  float area = 0.0f, x = 0.0f, y = 0.0f, xx = 0.0f, xy = 0.0f, yy = 0.0f;
  for (std::size_t k = 0; k < 16; ++k) {
    // The own second moment of what is left of a cell is that of a square of its area.
    const float a = cells.area[k], own = a * a / 12;
    area += a, x += a * cells.x[k], y += a * cells.y[k];
    xx += a * cells.x[k] * cells.x[k] + own, yy += a * cells.y[k] * cells.y[k] + own;
    xy += a * cells.x[k] * cells.y[k];
  }
  if (!(area > 0.0f)) return {t.r[at], t.g[at], t.b[at]};
  const float over = 1.0f / area;
  const auto of = [&](const auto& c) {
    const float by_x = c[at + 1] - c[at - 1], by_y = c[at + below] - c[at - below];
    const float bends_x = c[at + 1] + c[at - 1] - 2.0f * c[at],
                bends_y = c[at + below] + c[at - below] - 2.0f * c[at];
    const float twists =
        c[at + below + 1] + c[at - below - 1] - c[at + below - 1] - c[at - below + 1];
    return c[at] +
           0.5f * over * (by_x * x + by_y * y + bends_x * xx + bends_y * yy + 0.5f * twists * xy);
  };
  return {of(t.r), of(t.g), of(t.b)};
}

}  // namespace

/// Tiles by paint, zone and column: those of the row of tiles that was asked for last.
struct LitPaint::Scratch::Kept {
  static constexpr std::size_t kTiles = 512;
  std::vector<std::unique_ptr<LitTile>> tiles{kTiles};
  LitPixel pixel;
  SmoothPlaces smooth;
  NearFeet::Work work;
};

LitPaint::Scratch::Scratch() : kept_(std::make_unique<Kept>()) {}
LitPaint::Scratch::~Scratch() = default;
LitPaint::Scratch::Scratch(Scratch&&) noexcept = default;
LitPaint::Scratch& LitPaint::Scratch::operator=(Scratch&&) noexcept = default;

NearFeet::Work LitPaint::Scratch::take_work() {
  return std::exchange(kept_->work, {});
}

void LitPaint::make(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
                    glm::dvec2 center, double tolerance, int index) {
  surface_.make(paint, distances, blend, center);
  tolerance_ = tolerance, in_lanes_ = lanes_know(paint);
  index_ = index, id_ = next_id();
  if (surface_.area()) area_.make(*surface_.area(), center);
  if (!surface_.gradient_area()) return;
  gradient_area_.make(*surface_.gradient_area(), center);
  // Dark colours in linear light are encoded up to 12.92 times as steep.
  const double steep = blend == Blend::linear ? 6.0 : 1.0;
  const double slope = steep * paint.ramp->steepest() * paint.field.per_pixel;
  distance_tolerance_ = tolerance / 255.0 / std::max(slope, 1e-3);
}

bool LitPaint::level(int zone) const {
  return surface_.relief().domes.empty() && surface_.flat(zone);
}

/// The tile that has pixel (x, y), made if it is not there. Zone −1: of the gradient's distance.
LitTile& LitPaint::tile(int zone, int x, int y, Scratch& scratch) const {
  const int left = floor_to_tile(x), top = floor_to_tile(y);
  const std::uint64_t column = std::uint64_t(left / LitTile::kSide);
  const std::uint64_t hash =
      (std::uint64_t(index_) * 8 + std::uint64_t(zone + 1)) * 0x9E3779B97F4A7C15u;
  auto& slot = scratch.kept_->tiles[std::size_t((column + (hash >> 40)) % Scratch::Kept::kTiles)];
  if (!slot) slot = std::make_unique<LitTile>();
  LitTile& t = *slot;
  if (t.paint == id_ && t.zone == zone && t.x == left && t.y == top) return t;
  t.paint = id_, t.zone = zone, t.x = left, t.y = top;
  t.feet.tell(scratch.kept_->work);
  if (zone < 0)
    make_distances(t);
  else
    make_tile(t, scratch);
  return t;
}

void LitPaint::make_tile(LitTile& t, Scratch& scratch) const {
  const glm::dvec2 middle = glm::dvec2{t.x, t.y} + 0.5 * LitTile::kSide;
  set_lamp(surface_, t.zone, middle, kRadius, t.lamp);
  t.full = t.smooth = false;
  constexpr double kAlikeSlopes =
      0.02;  // per level of tolerance: a jump of the slope by so much makes as much
  t.same = float(std::clamp(kAlikeSlopes * tolerance_, 0.002, double(LitTile::kSame)));
  t.rises = !surface_.flat(t.zone);
  const bool varies = t.rises || !t.lamp.domes.empty() || t.lamp.ramp.kind != LampRamp::Kind::none;
  t.kind = varies ? LitTile::Kind::means : LitTile::Kind::base;
  if (t.kind == LitTile::Kind::base) return;
  const auto levels = surface_.levels();
  t.shallow = t.zone > 0 ? float(-levels[std::size_t(t.zone) - 1]) : -1e9f;
  t.deep = std::size_t(t.zone) < levels.size() ? float(-levels[std::size_t(t.zone)]) : 1e9f;
  if (t.rises) t.feet.narrow(area_, middle, kRadius);
  t.tangled = t.rises && t.feet.tangled();
  make_smooth(t, scratch);
}

void LitPaint::make_smooth(LitTile& t, Scratch& scratch) const {
  constexpr double kShare = 0.5;  // of the tolerance: the border is where polynomials are worst
  SmoothPlaces& at = scratch.kept_->smooth;
  if (t.rises) t.feet.at(at.x, at.y, {at.d.data(), at.nx.data(), at.ny.data(), at.bend.data()});
  // A dome that is small for a tile may lie between its places, and so may a highlight on it.
  constexpr float kSmall = 20.0f, kNarrow = 3.0f;  // [px]
  const bool small =
      t.lamp.finest < kNarrow ||
      std::any_of(t.lamp.domes.begin(), t.lamp.domes.end(), [](const LampDome& d) {
        return d.xx * d.xx + d.xy * d.xy + d.yx * d.yx + d.yy * d.yy > 2.0f / (kSmall * kSmall);
      });
  t.smooth = !small && smooth_means(at, float(kShare * tolerance_ / 255.0), t);
}

/// Makes what pixels need where smooth means do not serve.
void LitPaint::make_full(LitTile& t) const {
  if (t.full) return;
  t.full = true;
  if (t.rises) find_feet(t);
  shade_tile(t, float(tolerance_));
}

void LitPaint::make_distances(LitTile& t) const {
  const glm::dvec2 middle = glm::dvec2{t.x, t.y} + 0.5 * LitTile::kSide;
  t.rises = true, t.kind = LitTile::Kind::distances;
  // Where the slope jumps by s, blocks beside the ridge see each other's distances wrong by up to 0.7 s px.
  t.same = float(std::clamp(distance_tolerance_, 2e-4, double(LitTile::kSame)));
  t.lamp.rise_kind = LampLanes::Rise::constant, t.lamp.rise = 1.0f, t.lamp.finest = 1e9f;
  t.shallow = -1e9f, t.deep = 1e9f;
  t.feet.narrow(gradient_area_, middle, kRadius);
  // Feet two pixels apart reveal a ridge between them to within half a level, but not to within an eighth.
  const bool unsure = tolerance_ < double(LitTile::kFine) && !t.feet.is_single();
  t.tangled = t.feet.tangled() || gradient_area_.is_fine() || unsure;
  find_feet(t);
  judge_distances(t);
}

/// Of a pixel of the tile.
LitPixel::Place LitPaint::place(LitTile& t, int x, int y) const {
  const int column = x - t.x, row = y - t.y;
  const auto k = std::size_t(row * LitTile::kSide + column),
             at = std::size_t((row + 1) * LitTile::kRow + column + 1);
  const FootAt foot =
      t.rises ? FootAt{t.d[at], t.nx[at], t.ny[at], t.bend[at]} : FootAt{0.0f, 1.0f, 0.0f, 0.0f};
  return {&t.lamp,
          t.rises ? &t.feet : nullptr,
          t.shallow,
          t.deep,
          t.middle(column, row),
          foot,
          !t.rises || t.trust[k] != LitTile::Trust::none,
          float(t.kind == LitTile::Kind::distances ? distance_tolerance_ : tolerance_ / 255.0)};
}

void LitPaint::pixels(const LitPiece& piece, int x, int y, int count, float* r, float* g, float* b,
                      float* a, Scratch& scratch) const {
  const Mix& base = surface_.paint().color;
  if (sure_way()) {
    for (int i = 0; i < count; ++i) {
      const Mix mean = square_mean(surface_, piece, {x + i, y}, 1.0, 0.3 * tolerance_ / 255.0);
      r[i] = float(mean.r), g[i] = float(mean.g), b[i] = float(mean.b), a[i] = float(mean.a);
    }
    return;
  }
  for (int i = 0; i < count; ++i) a[i] = opacity(piece, x + i, y, nullptr);
  for (int i = 0; i < count;) {
    LitTile& t = tile(piece.zone, x + i, y, scratch);
    const int column = x + i - t.x, row = y - t.y;
    const int n = std::min(count - i, LitTile::kSide - column);
    const std::size_t from = std::size_t(row * LitTile::kSide + column);
    if (t.kind == LitTile::Kind::base) {
      std::fill_n(r + i, n, float(base.r)), std::fill_n(g + i, n, float(base.g));
      std::fill_n(b + i, n, float(base.b));
      i += n;
      continue;
    }
    if (t.smooth) {
      std::copy_n(&t.smooth_r[from], n, r + i), std::copy_n(&t.smooth_g[from], n, g + i);
      std::copy_n(&t.smooth_b[from], n, b + i);
      i += n;
      continue;
    }
    make_full(t);
    std::copy_n(&t.mean_r[from], n, r + i), std::copy_n(&t.mean_g[from], n, g + i);
    std::copy_n(&t.mean_b[from], n, b + i);
    for (int k = 0; k < n; ++k) {
      if (t.trust[from + std::size_t(k)] <= LitTile::Trust::within) continue;
      const glm::vec3 mean = scratch.kept_->pixel.mean(place(t, x + i + k, y), nullptr);
      r[i + k] = mean.r, g[i + k] = mean.g, b[i + k] = mean.b;
    }
    i += n;
  }
}

float LitPaint::opacity_at(const LitPiece& piece, double t) const {
  const RampSegment* s = piece.segment;
  return float(s ? s->at.a + std::clamp(t, s->from, s->to) * s->slope.a
                 : surface_.paint().ramp->color(t).a);
}

/// A ramp's kinks are outlines, so over a part of a pixel its opacity is that at the mean t. Along a line that is t
/// at the centroid, and no more is needed; from a centre t bends, and cells give its mean.
float LitPaint::opacity(const LitPiece& piece, int x, int y, const PartForm* form) const {
  const GridPaint& paint = surface_.paint();
  if (!paint.ramp) return float(paint.color.a);
  const Ramp& ramp = *paint.ramp;
  if (ramp.least_opacity() == ramp.most_opacity()) return float(ramp.least_opacity());
  const glm::dvec2 middle = glm::dvec2{x, y} + 0.5 - surface_.center();
  // [px] This far from a radial gradient's centre a pixel's mean is right to second order.
  constexpr double kFar = 6.0;
  const PaintField& field = paint.field;
  const bool straight = field.kind == PaintField::Kind::linear;
  if (!form && (straight || field.at(middle, 0.0) > kFar * field.per_pixel))
    return opacity_at(piece, field.mean(middle, 1.0 / 12));
  PartCells cells;
  if (form)
    cells_of_form(*form, 4, cells);
  else
    whole_cells(4, cells);
  const double variance = double(cells.cell() * cells.cell()) / 12;
  double sum = 0.0, area = 0.0;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    const auto a = double(cells.area[k]);
    if (a == 0.0) continue;
    const glm::dvec2 p = middle + glm::dvec2{cells.x[k], cells.y[k]};
    sum += a * field.mean(p, a * double(cells.count()) * variance), area += a;
  }
  return opacity_at(piece, area > 0.0 ? sum / area : field.mean(middle, 0.0));
}

glm::vec4 LitPaint::part(const LitPiece& piece, int x, int y, const PartForm& form,
                         Scratch& scratch) const {
  const Mix& base = surface_.paint().color;
  if (sure_way()) {
    // Dark colours in linear light are encoded up to 12.92 times as steep.
    const double steep = surface_.blend() == Blend::linear ? 6.0 : 1.0;
    return glm::vec4(part_mean(surface_, piece, {x, y}, form, tolerance_ / 255.0 / steep));
  }
  LitTile& t = tile(piece.zone, x, y, scratch);
  if (t.kind == LitTile::Kind::base) return glm::vec4(base);
  make_full(t);
  const float opacity = this->opacity(piece, x, y, &form);
  const int column = x - t.x, row = y - t.y;
  if (t.trust[std::size_t(row * LitTile::kSide + column)] == LitTile::Trust::around)
    return {smooth_part(t, column, row, form), opacity};
  return {scratch.kept_->pixel.mean(place(t, x, y), &form), opacity};
}

void LitPaint::colors_of_cells(const LitPiece& piece, int x, int y, const PartCells& cells,
                               const PartForm* form, bool each, std::span<float> r,
                               std::span<float> g, std::span<float> b, std::span<float> a,
                               Scratch& scratch) const {
  const auto count = std::size_t(cells.count());
  glm::vec4 mean{0.0f};
  const glm::dvec2 middle{x + 0.5, y + 0.5};
  if (form)
    mean = part(piece, x, y, *form, scratch);
  else
    pixels(piece, x, y, 1, &mean.r, &mean.g, &mean.b, &mean.a, scratch);
  const auto fill = [&](std::span<float> to, float v) { std::fill_n(to.begin(), count, v); };
  fill(r, mean.r), fill(g, mean.g), fill(b, mean.b), fill(a, mean.a);
  if (!each) return;
  const bool varies = surface_.paint().ramp.has_value();
  if (in_lanes_) {
    LitTile& t = tile(piece.zone, x, y, scratch);
    if (t.kind == LitTile::Kind::base) return;
    make_full(t);
    scratch.kept_->pixel.colors(place(t, x, y), form, cells.side, mean, r, g, b);
  }
  glm::vec4 sum{0.0f};
  float area = 0.0f;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec2 p = middle + glm::dvec2{cells.x[k], cells.y[k]};
    if (!in_lanes_) {
      const Mix c = surface_.color(piece, p, surface_.outward(p));
      r[k] = float(c.r), g[k] = float(c.g), b[k] = float(c.b), a[k] = float(c.a);
    } else if (varies) {
      a[k] = opacity_at(piece, surface_.paint().field.at(p - surface_.center(), 0.0));
    }
    sum += cells.area[k] * glm::vec4{r[k], g[k], b[k], a[k]}, area += cells.area[k];
  }
  if (!(area > 0.0f)) return;
  // Places give its variation, the form its mean.
  const glm::vec4 by = mean - sum / area;
  for (std::size_t k = 0; k < count; ++k) r[k] += by.r, g[k] += by.g, b[k] += by.b, a[k] += by.a;
}

void LitPaint::distances(int x, int y, int count, float* d, Scratch& scratch) const {
  for (int i = 0; i < count; ++i) {
    LitTile& t = tile(-1, x + i, y, scratch);
    const auto k = std::size_t((y - t.y) * LitTile::kSide + x + i - t.x);
    d[i] = t.trust[k] == LitTile::Trust::around
               ? t.mean_r[k]
               : scratch.kept_->pixel.distance(place(t, x + i, y), nullptr);
  }
}

void LitPaint::distances_of_cells(int x, int y, const PartCells& cells, float* d,
                                  Scratch& scratch) const {
  LitTile& t = tile(-1, x, y, scratch);
  const glm::vec2 middle = t.middle(x - t.x, y - t.y);
  std::array<float, PartCells::kMost> px, py, nx, ny, bend;
  const auto count = std::size_t(cells.count());
  for (std::size_t k = 0; k < count; ++k)
    px[k] = middle.x + cells.x[k], py[k] = middle.y + cells.y[k];
  t.feet.at(std::span(px).first(count), std::span(py).first(count),
            {d, nx.data(), ny.data(), bend.data()});
}

float LitPaint::distance_of_part(int x, int y, const PartForm& form, Scratch& scratch) const {
  LitTile& t = tile(-1, x, y, scratch);
  return scratch.kept_->pixel.distance(place(t, x, y), &form);
}

}  // namespace mien
