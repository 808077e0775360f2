#include "render/shade/light/lit_paint.h"
#include "lib/base/monotonic_seconds.h"
#include "render/shade/light/light_tile.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace mien {
namespace {

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

/// Tiles by paint, piece and column, and their grounds: those of the row of tiles that was asked for last.
struct LitPaint::Scratch::Kept {
  static constexpr std::size_t kTiles = 512;
  std::vector<std::unique_ptr<LightTile>> tiles{kTiles};
  std::vector<std::unique_ptr<LightGround>> grounds{kTiles};
  CellScratch cells;
  std::vector<Doubt> doubts;
  long long feet = 0;
  double seconds = 0;
  unsigned asked = 0;
  bool used = false;  ///< whether any tile was asked for since the work was last taken

  void note_doubt(LightTile& tile, int x) {
    if (tile.off > 0.0f) doubts.push_back({x, std::exchange(tile.off, 0.0f)});
  }

  /// Does work that takes about as long as looking at the clock: one in so many is timed, for all of them.
  template <class Work>
  auto timed(const Work& work) {
    constexpr unsigned kOneIn = 16;
    if (asked++ % kOneIn != 0) return work();
    const double begin = monotonic_seconds();
    auto made = work();
    seconds += kOneIn * (monotonic_seconds() - begin);
    return made;
  }
};

LitPaint::Scratch::Scratch() : kept_(std::make_unique<Kept>()) {}
LitPaint::Scratch::~Scratch() = default;
LitPaint::Scratch::Scratch(Scratch&&) noexcept = default;
LitPaint::Scratch& LitPaint::Scratch::operator=(Scratch&&) noexcept = default;

LitPaint::Scratch::Work LitPaint::Scratch::take_work() {
  if (!std::exchange(kept_->used, false)) return {};
  Work work{std::exchange(kept_->feet, 0), std::exchange(kept_->seconds, 0.0)};
  for (const auto& g : kept_->grounds)
    if (g) work.feet += g->take_feet();
  return work;
}

std::vector<LitPaint::Doubt>& LitPaint::Scratch::doubts() {
  return kept_->doubts;
}

void LitPaint::make(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
                    glm::dvec2 center, double tolerance, int index) {
  surface_.make(paint, distances, blend, center);
  tolerance_ = tolerance, index_ = index, id_ = next_id();
  if (surface_.area()) area_.make(*surface_.area(), center);
  if (surface_.gradient_area()) gradient_area_.make(*surface_.gradient_area(), center);
}

bool LitPaint::level(int zone) const {
  return surface_.relief().domes.empty() && surface_.flat(zone);
}

LightTile* LitPaint::tile(const LitPiece& piece, int x, int y, Scratch& scratch) const {
  Scratch::Kept& kept = *scratch.kept_;
  kept.used = true;
  const std::uint64_t hash =
      (std::uint64_t(index_) * 8 + std::uint64_t(piece.zone + 1)) * 0x9E3779B97F4A7C15u;
  const std::size_t segment = piece.segment ? std::hash<double>()(piece.segment->from) : 0;
  for (int side = LightTile::kSide; side > 0; side /= 2) {
    const int left = x & ~(side - 1), top = y & ~(side - 1);
    const std::uint64_t column =
        std::uint64_t(left / LightTile::kSide) + 37u * std::uint64_t(16 - side) + (hash >> 40);
    auto& ground = kept.grounds[std::size_t(column % Scratch::Kept::kTiles)];
    if (!ground) ground = std::make_unique<LightGround>();
    auto& slot = kept.tiles[std::size_t((column + segment) % Scratch::Kept::kTiles)];
    if (!slot) slot = std::make_unique<LightTile>();
    LightTile& t = *slot;
    const LightGround::Whose whose{id_, piece.zone, left, top, side};
    const bool known = ground->whose == whose;
    if (!known) kept.feet += ground->take_feet(), ground->whose = whose, ++ground->made;
    if (!known || t.ground != ground.get() || t.of_ground != ground->made ||
        t.segment != piece.segment) {
      t.ground = ground.get(), t.of_ground = ground->made, t.segment = piece.segment,
      t.scratch = &kept.cells;
      t.x = left, t.y = top, t.side = side;
      make_tile(piece, t, !known);
    }
    if (!ground->crowded) return &t;
  }
  scratch.kept_->doubts.push_back({x, 1.0f});
  return nullptr;
}

void LitPaint::make_tile(const LitPiece& piece, LightTile& t, bool on_new_ground) const {
  // [of the side] Half a diagonal, and what parts beside the tile need.
  const double radius = 0.75 * t.side;
  const glm::dvec2 middle = glm::dvec2{t.x, t.y} + 0.5 * t.side;
  constexpr double kFine = 0.1;  // [levels] of 8 bits it is 0.3
  t.channels = 3, t.rises = t.apart = false, t.fine = tolerance_ < kFine;
  t.shallow = -1e9f, t.deep = 1e9f, t.tolerance = float(tolerance_ / 255.0);
  set_lamp(surface_, piece, middle, radius, t.lamp);
  t.rises = !surface_.flat(piece.zone);
  const auto levels = surface_.levels();
  const std::size_t zone = std::size_t(piece.zone);
  if (zone > 0) t.shallow = float(-levels[zone - 1]);
  if (zone < levels.size()) t.deep = float(-levels[zone]);
  if (piece.segment && piece.segment->slope.a != 0.0) t.channels = 4;
  t.apart = t.lamp.goes_by_distance() && !(t.rises && surface_.area() == surface_.gradient_area());
  LightGround& g = *t.ground;
  if (on_new_ground) {
    if (t.rises) g.area.narrow(area_, middle, radius);
    if (t.apart) g.gradient.narrow(gradient_area_, middle, radius);
    g.crowded = (t.rises && g.area.crowded()) || (t.apart && g.gradient.crowded());
  }
  if (g.crowded) return;
  if (on_new_ground) t.begin_ground();
  t.begin();
}

namespace {

/// The opacity where it does not vary.
float opacity_of(const LightTile& t) {
  return t.lamp.ramp.kind == LampRamp::Kind::none ? t.lamp.alpha : t.lamp.ramp.at[3];
}

}  // namespace

void LitPaint::pixels(const LitPiece& piece, int x, int y, int count, float* r, float* g, float* b,
                      float* a, Scratch& scratch) const {
  float* const to[4] = {r, g, b, a};
  for (int i = 0; i < count;) {
    LightTile* t = tile(piece, x + i, y, scratch);
    if (!t) {
      for (int c = 0; c < 4; ++c) to[c][i] = 0.0f;
      ++i;
      continue;
    }
    const int column = x + i - t->x, row = y - t->y, n = std::min(count - i, t->side - column);
    const auto from = std::size_t(row * LightTile::kSide + column);
    if (!t->lamp.varies()) {
      for (int c = 0; c < 4; ++c) std::fill_n(to[c] + i, n, float(surface_.paint().color[c]));
      i += n;
      continue;
    }
    for (int k = 0; k < n; ++k)
      if (!t->known[from + std::size_t(k)]) {
        scratch.kept_->timed([&] { return find_mean(*t, column + k, row), 0; });
        scratch.kept_->note_doubt(*t, x + i + k);
      }
    for (int c = 0; c < t->channels; ++c) std::copy_n(&t->mean[std::size_t(c)][from], n, to[c] + i);
    if (t->channels < 4) std::fill_n(a + i, n, opacity_of(*t));
    i += n;
  }
}

glm::vec4 LitPaint::part(const LitPiece& piece, int x, int y, const LitPart& part,
                         Scratch& scratch) const {
  LightTile* t = tile(piece, x, y, scratch);
  if (!t) return glm::vec4{0.0f};
  if (!t->lamp.varies()) return glm::vec4(surface_.paint().color);
  const std::array<float, 4> mean =
      scratch.kept_->timed([&] { return mean_of_part(*t, x - t->x, y - t->y, part); });
  scratch.kept_->note_doubt(*t, x);
  return {mean[0], mean[1], mean[2], t->channels == 4 ? mean[3] : opacity_of(*t)};
}

void LitPaint::colors_of_cells(const LitPiece& piece, int x, int y, const PartCells& cells,
                               const LitPart* part, bool each, std::span<float> r,
                               std::span<float> g, std::span<float> b, std::span<float> a,
                               Scratch& scratch) const {
  const auto count = std::size_t(cells.count());
  glm::vec4 mean{0.0f};
  if (part)
    mean = this->part(piece, x, y, *part, scratch);
  else
    pixels(piece, x, y, 1, &mean.r, &mean.g, &mean.b, &mean.a, scratch);
  const std::array<float*, 4> to{r.data(), g.data(), b.data(), a.data()};
  for (std::size_t c = 0; c < 4; ++c) std::fill_n(to[c], count, mean[int(c)]);
  if (!each) return;
  LightTile* t = tile(piece, x, y, scratch);
  if (!t || !t->lamp.varies()) return;
  mien::colors_of_cells(*t, x - t->x, y - t->y, cells, to);
  glm::vec4 sum{0.0f};
  float area = 0.0f;
  for (std::size_t k = 0; k < count; ++k)
    sum += cells.area[k] * glm::vec4{r[k], g[k], b[k], a[k]}, area += cells.area[k];
  if (!(area > 0.0f)) return;
  // Places give its variation, the form its mean.
  const glm::vec4 by = mean - sum / area;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t k = 0; k < count; ++k) to[c][k] += by[int(c)];
}

}  // namespace mien
