#include <mien/render/tile/band.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace mien {
namespace {

constexpr double kSqrtHalf = 0.70710678118654757;  // rounded up

/// Targets from this size on are written past the caches [bytes]. Below, the next reader finds its
/// pixels there; measured: even at 15 MB, ahead from 30 MB on.
constexpr std::size_t kStreamedFrom = 16u << 20;

/// Outlines noted for tiles that are described together: half a kilobyte each. Faces never have so many.
constexpr std::size_t kMostDescribed = 4096;
/// Of those a tile's place keeps memory for so many.
constexpr std::size_t kMostKept = 512;

std::span<const Step> steps_of(const Tape& tape, int layer) {
  const TapeLayer& l = tape.layers[std::size_t(layer)];
  return {tape.steps.data() + l.first, std::size_t(l.count)};
}

}  // namespace

void BandPainter::draw(const Plan& plan, int width, int height, int y, const Target& target,
                       RenderStats& stats) {
  const std::size_t outlines = plan.tape.outlines.size();
  if (plan_ != &plan || made_ != plan.made) {
    made_ = plan.made;
    paints_.reset();
    if (plan_ != &plan) lit_.reset();
    if (!plan.plain) {
      paints_.emplace(plan.tape);
      if (!lit_) lit_.emplace(plan.tape);
    }
  }
  plan_ = &plan, target_ = &target, stats_ = &stats;
  width_ = width, height_ = height, y_ = y;
  const bool large = target.stride * std::size_t(target.rect.height) >= kStreamedFrom;
  stores_ = large && target.depth == Depth::u8 ? Stores::streamed : Stores::ordinary;
  stamp_.resize(outlines), wanted_.resize(outlines), heads_.assign(outlines, -1);
  group_sides_.resize(outlines), tile_sides_.resize(outlines), leaf_sides_.resize(outlines);
  const int first = target.rect.x / kBandTile;
  const int last = (target.rect.x + target.rect.width - 1) / kBandTile;
  for (int i = first; i <= last; i += kGroup) group(i * kBandTile, std::min(kGroup, last + 1 - i));
  if (stores_ == Stores::streamed) finish_streams();
}

/// The outlines that the layers' programs read, each once, to noted_.
void BandPainter::note_outlines(std::span<const int> layers) {
  noted_.clear();
  ++stamp_now_;
  for (const int layer : layers)
    for (const Step& step : steps_of(plan_->tape, layer))
      if (step.kind == Step::Kind::outline && stamp_[std::size_t(step.outline)] != stamp_now_) {
        stamp_[std::size_t(step.outline)] = stamp_now_;
        noted_.push_back(step.outline);
      }
}

Sides BandPainter::classified(int outline, std::span<const float> x, std::span<const float> y,
                              float half_diagonal) {
  plan_->squares[std::size_t(outline)].classify(x, y, half_diagonal, {answers_.data(), x.size()});
  Sides sides;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sides.in |= std::uint64_t(answers_[i] < 0) << i;
    sides.out |= std::uint64_t(answers_[i] > 0) << i;
  }
  return sides;
}

/// Which colour each square has, and which are mixed.
void BandPainter::resolve(std::span<const int> layers, std::span<const Sides> outlines,
                          std::uint64_t valid, Squares& squares) {
  std::uint64_t open = valid, composite = 0;
  squares.seen.clear();
  squares.mixed = 0;
  const auto paint = [&](std::uint64_t lanes, int color) {
    for (; lanes; lanes &= lanes - 1) squares.color[std::size_t(std::countr_zero(lanes))] = color;
  };
  for (const int layer : layers) {
    const Sides s = sides_of(steps_of(plan_->tape, layer), outlines, stack_);
    const std::uint64_t in = s.in & open, unknown = s.unknown() & open;
    if (!(in | unknown)) continue;
    squares.seen.push_back({layer, in, unknown});
    squares.mixed |= unknown;
    const TapeLayer& l = plan_->tape.layers[std::size_t(layer)];
    if (!l.plain()) {  // its leaves are left to the sure way
      squares.mixed |= in;
    } else if (l.mix.a >= 1.0) {
      paint(in & ~squares.mixed & ~composite, layer);
      open &= ~in;
    } else {
      composite |= in;
    }
    if (!open) break;
  }
  paint(open & ~squares.mixed & ~composite, kBackground);
  paint(composite & ~squares.mixed, kComposite);
}

Mix BandPainter::composite(const Squares& squares, int lane) const {
  Mix mix{0.0};
  for (const Seen& s : squares.seen)
    if (s.in >> lane & 1u) mix = over(mix, plan_->tape.layers[std::size_t(s.layer)].mix);
  return over(mix, plan_->tape.background);
}

void BandPainter::group(int x, int tiles) {
  const glm::dvec2 half{0.5 * width_, 0.5 * height_};
  const Box2 box{glm::dvec2{x, y_} - half,
                 glm::dvec2{x + tiles * kBandTile, y_ + kBandTile} - half};
  group_layers_.clear();
  for (std::size_t i = 0; i < plan_->layer_boxes.size(); ++i)
    if (!common(plan_->layer_boxes[i], box).empty()) group_layers_.push_back(int(i));
  for (int i = 0; i < tiles; ++i) {
    xs_[std::size_t(i)] = float(box.lo.x + kBandTile * (i + 0.5));
    ys_[std::size_t(i)] = float(box.lo.y + 0.5 * kBandTile);
  }
  note_outlines(group_layers_);
  const auto n = std::size_t(tiles);
  for (const int o : noted_)
    group_sides_[std::size_t(o)] =
        common(plan_->outline_boxes[std::size_t(o)], box).empty()
            ? Sides{0, ~std::uint64_t{0}}
            : classified(o, {xs_.data(), n}, {ys_.data(), n}, float(kSqrtHalf * kBandTile));
  const std::uint64_t valid = tiles == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << tiles) - 1;
  resolve(group_layers_, group_sides_, valid, group_);
  for (int i = 0; i < tiles;) i = draw_tiles(x, i, tiles);
}

/// Tiles of the present group from the first on, as many as are described together; the next one.
int BandPainter::draw_tiles(int x, int first, int tiles) {
  std::array<int, kGroup> places;
  std::size_t noted = 0;
  described_ = 0;
  int last = first;
  for (; last < tiles && noted <= kMostDescribed; ++last) {
    if (!(group_.mixed >> last & 1u)) continue;
    places[std::size_t(last)] = described_;
    if (tiles_.size() == std::size_t(described_)) tiles_.emplace_back();
    Tile& tile = tiles_[std::size_t(described_++)];
    tile.x = x + last * kBandTile;
    note(last, tile);
    noted += tile.noted.size();
  }
  place_leaves();
  for (int i = 0; i < described_; ++i) resolve_leaves(i);
  find_edges();
  // The one colour that tile i shows in a row of leaves, if it does.
  struct Filled {
    const Squares* squares;
    int lane;
    int color() const { return squares->color[std::size_t(lane)]; }
  };
  const auto filled = [&](int i, int row) -> std::optional<Filled> {
    if (!(group_.mixed >> i & 1u)) return Filled{&group_, i};
    const Tile& tile = tiles_[std::size_t(places[std::size_t(i)])];
    if (!tile.one_color(row)) return {};
    return Filled{&tile.squares, row * kLeavesAcross};
  };
  for (int row = 0; row < kLeavesAcross; ++row)
    for (int i = first; i < last;) {
      const std::optional<Filled> one = filled(i, row);
      if (!one) {
        draw_row(tiles_[std::size_t(places[std::size_t(i)])], row);
        ++i;
        continue;
      }
      int end = i + 1;  // a run of one colour
      if (one->color() != kComposite)
        for (; end < last; ++end) {
          const std::optional<Filled> next = filled(end, row);
          if (!next || next->color() != one->color()) break;
        }
      fill(*one->squares, one->lane,
           {x + i * kBandTile, y_ + row * kLeaf, (end - i) * kBandTile, kLeaf});
      i = end;
    }
  // A crowded tile may have been in any of 64 places.
  for (std::size_t i = 1; i < tiles_.size(); ++i)
    if (tiles_[i].outlines.size() > kMostKept) tiles_[i].outlines = {};
  return last;
}

bool BandPainter::Tile::one_color(int row) const {
  const int first = row * kLeavesAcross, last = first + kLeavesAcross - 1;
  if (squares.mixed >> first & ((1u << kLeavesAcross) - 1)) return false;
  const int color = squares.color[std::size_t(first)];
  for (int lane = first + 1; lane <= last; ++lane)
    if (squares.color[std::size_t(lane)] != color) return false;
  return color != kComposite;
}

/// The outlines that a tile's layers read: on which side of them it lies, if all of it does; else they are asked
/// about its leaves.
void BandPainter::note(int index, Tile& tile) {
  tile.layers.clear();
  for (const Seen& s : group_.seen)
    if ((s.in | s.unknown) >> index & 1u) tile.layers.push_back(s.layer);
  note_outlines(tile.layers);
  tile.noted.assign(noted_.begin(), noted_.end());
  tile.sides.clear();
  for (const int o : noted_) {
    const Sides s = group_sides_[std::size_t(o)];
    const bool in = s.in >> index & 1u, out = s.out >> index & 1u;
    if (!in && !out) link(o, described_ - 1, int(tile.sides.size()));
    tile.sides.push_back({in ? ~std::uint64_t{0} : 0, out ? ~std::uint64_t{0} : 0});
  }
}

void BandPainter::link(int outline, int tile, int place) {
  int& head = heads_[std::size_t(outline)];
  if (head < 0) linked_.push_back(outline);
  links_.push_back({tile, place, head});
  head = int(links_.size()) - 1;
}

glm::dvec2 BandPainter::center_of(const Tile& tile, int lane) const {
  const glm::dvec2 corner{tile.x + kLeaf * (lane % kLeavesAcross),
                          y_ + kLeaf * (lane / kLeavesAcross)};
  return corner + 0.5 * kLeaf - 0.5 * glm::dvec2{width_, height_};
}

/// Where the leaves lie against the outlines asked for, those of four tiles at once.
void BandPainter::place_leaves() {
  constexpr std::size_t kTiles = kGroup / Leaves::kMost;
  for (const int o : linked_) {
    for (int next = std::exchange(heads_[std::size_t(o)], -1); next >= 0;) {
      std::array<Sides*, kTiles> asked;
      std::size_t count = 0;
      for (; next >= 0 && count < kTiles; ++count) {
        const Link& l = links_[std::size_t(next)];
        Tile& tile = tiles_[std::size_t(l.tile)];
        for (std::size_t i = 0; i < Leaves::kMost; ++i) {
          const glm::dvec2 c = center_of(tile, int(i));
          xs_[count * Leaves::kMost + i] = float(c.x), ys_[count * Leaves::kMost + i] = float(c.y);
        }
        asked[count] = &tile.sides[std::size_t(l.place)];
        next = l.next;
      }
      const std::size_t n = count * Leaves::kMost;
      const Sides all = classified(o, {xs_.data(), n}, {ys_.data(), n}, float(kSqrtHalf * kLeaf));
      for (std::size_t t = 0; t < count; ++t)
        *asked[t] = {all.in >> (t * Leaves::kMost) & 0xFFFFu,
                     all.out >> (t * Leaves::kMost) & 0xFFFFu};
    }
  }
  linked_.clear(), links_.clear();
}

/// What a tile's leaves show, and which need the edges of which outlines.
void BandPainter::resolve_leaves(int index) {
  Tile& tile = tiles_[std::size_t(index)];
  for (std::size_t i = 0; i < tile.noted.size(); ++i) {
    tile_sides_[std::size_t(tile.noted[i])] = tile.sides[i];
    wanted_[std::size_t(tile.noted[i])] = 0;
  }
  resolve(tile.layers, tile_sides_, 0xFFFF, tile.squares);
  tile.wanted.clear();
  for (const Seen& s : tile.squares.seen) {
    if (!s.unknown) continue;
    for (const Step& step : steps_of(plan_->tape, s.layer)) {
      if (step.kind != Step::Kind::outline) continue;
      const auto o = std::size_t(step.outline);
      const auto lanes = std::uint32_t(s.unknown & tile_sides_[o].unknown());
      if (lanes && !wanted_[o]) tile.wanted.push_back({step.outline, 0});
      wanted_[o] |= lanes;
    }
  }
  if (tile.outlines.size() < tile.wanted.size()) tile.outlines.resize(tile.wanted.size());
  for (std::size_t i = 0; i < tile.wanted.size(); ++i) {
    Tile::Wanted& w = tile.wanted[i];
    w.leaves = wanted_[std::size_t(w.outline)];
    link(w.outline, index, int(i));
  }
}

/// The edges of every outline in the leaves that need them, sixteen at once wherever they are.
void BandPainter::find_edges() {
  edges_.clear();
  Leaves leaves{.wanted = 0, .radius = kSqrtHalf * kLeaf};
  OutlineInLeaves found;
  std::array<LeafOutline*, Leaves::kMost> asked;
  std::size_t count = 0;
  const auto ask = [&](int outline) {
    for (std::size_t i = count; i < Leaves::kMost; ++i)
      leaves.x[i] = leaves.x[count - 1], leaves.y[i] = leaves.y[count - 1];
    leaves.wanted = (1u << count) - 1;
    plan_->outlines[std::size_t(outline)].in_leaves(leaves, found, edges_);
    for (std::size_t i = 0; i < count; ++i) *asked[i] = found[i];
    count = 0;
  };
  for (const int o : linked_) {
    for (int next = std::exchange(heads_[std::size_t(o)], -1); next >= 0;) {
      const Link& l = links_[std::size_t(next)];
      Tile& tile = tiles_[std::size_t(l.tile)];
      for (std::uint32_t left = tile.wanted[std::size_t(l.place)].leaves; left; left &= left - 1) {
        const int lane = std::countr_zero(left);
        const glm::dvec2 c = center_of(tile, lane);
        leaves.x[count] = c.x, leaves.y[count] = c.y;
        asked[count++] = &tile.outlines[std::size_t(l.place)][std::size_t(lane)];
        if (count == Leaves::kMost) ask(o);
      }
      next = l.next;
    }
    if (count > 0) ask(o);
  }
  linked_.clear(), links_.clear();
}

/// A row of a tile's leaves.
void BandPainter::draw_row(const Tile& tile, int row) {
  const PixelRect all{tile.x, y_ + row * kLeaf, kBandTile, kLeaf}, part = visible(all);
  if (part.width <= 0 || part.height <= 0) return;
  if (stores_ == Stores::streamed && part.width == all.width && part.height == all.height) {
    std::byte* const to = at(all.x, all.y);
    if (target_->stride % 64 == 0 && reinterpret_cast<std::uintptr_t>(to) % 64 == 0)
      return stream_row(tile, row, reinterpret_cast<std::uint32_t*>(to));
  }
  const int last = (row + 1) * kLeavesAcross - 1;
  for (int lane = row * kLeavesAcross; lane <= last; ++lane) {
    leaf_x_ = tile.x + kLeaf * (lane % kLeavesAcross), leaf_y_ = all.y;
    leaf_center_ = center_of(tile, lane);
    if (tile.squares.mixed >> lane & 1u) {
      leaf(tile, lane);
      continue;
    }
    const int color = tile.squares.color[std::size_t(lane)];
    int leaves = 1;
    for (; color != kComposite && lane < last; ++lane, ++leaves)
      if (tile.squares.mixed >> (lane + 1) & 1u ||
          tile.squares.color[std::size_t(lane + 1)] != color)
        break;
    fill(tile.squares, lane, {leaf_x_, leaf_y_, leaves * kLeaf, kLeaf});
  }
}

/// The same beside the target, and then whole lines of memory past the caches.
void BandPainter::stream_row(const Tile& tile, int row, std::uint32_t* to) {
  const Target beside{.data = reinterpret_cast<std::byte*>(row_.data()),
                      .stride = 4 * kBandTile,
                      .depth = Depth::u8,
                      .rect = {tile.x, y_ + row * kLeaf, kBandTile, kLeaf}};
  const Target* const target = std::exchange(target_, &beside);
  stores_ = Stores::ordinary;
  draw_row(tile, row);
  target_ = target;
  stores_ = Stores::streamed;
  stream_rows(row_.data(), kBandTile, kLeaf, to, target_->stride / 4);
}

/// The colour that a layer has all over a square; nothing if it varies there.
std::optional<Mix> BandPainter::mix_of(int layer, glm::dvec2 center, double side) {
  const TapeLayer& l = plan_->tape.layers[std::size_t(layer)];
  if (l.group >= 0) return {};
  if (l.paint >= 0) return paints_->constant(l.paint, center, kSqrtHalf * side);
  return l.mix;
}

void BandPainter::leaf(const Tile& tile, int lane) {
  const PixelRect part = visible({leaf_x_, leaf_y_, kLeaf, kLeaf});
  if (part.width <= 0 || part.height <= 0) return;
  leaf_layers_.clear();
  for (const Seen& s : tile.squares.seen)
    if ((s.in | s.unknown) >> lane & 1u) leaf_layers_.push_back(s.layer);
  leaf_wanted_.clear();
  leaf_list_.clear();
  for (std::size_t i = 0; i < tile.wanted.size(); ++i)
    if (tile.wanted[i].leaves >> lane & 1u) {
      leaf_wanted_.push_back(tile.wanted[i].outline);
      leaf_list_.push_back(tile.outlines[i][std::size_t(lane)]);
    }
  for (std::size_t i = 0; i < tile.noted.size(); ++i)
    leaf_sides_[std::size_t(tile.noted[i])] =
        tile.sides[i].in >> lane & 1u ? Sides{~std::uint64_t{0}, 0} : Sides{0, ~std::uint64_t{0}};
  if (assemble(leaf_list_, edges_, {0.0, 0.0}, kLeaf, kMostLeafBend))
    paint(0xFFFF);
  else if (!varies_here_)
    divide({0.0, 0.0}, kLeaf, 0, 0);
  else if (!lit_square({0.0, 0.0}, 0, 0, kLeaf))
    sure_square(0, 0, kLeaf);
}

}  // namespace mien
