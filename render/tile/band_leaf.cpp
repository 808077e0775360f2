// The leaves of a band: edges and a palette, or their parts.

#include <mien/render/tile/band.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace mien {
namespace {

constexpr double kSqrtHalf = 0.70710678118654757;  // rounded up

/// Bit i: i has bit `edge` set. All combinations of sides at once.
constexpr std::array<std::uint64_t, Leaf::kMostEdges> kPatterns{
    0xAAAAAAAAu, 0xCCCCCCCCu, 0xF0F0F0F0u, 0xFF00FF00u, 0xFFFF0000u};

}  // namespace

bool BandPainter::add_edges(const LeafOutline& outline, std::span<const LeafEdge> edges,
                            glm::dvec2 shift, double most_bend) {
  for (int i = outline.first; i < outline.first + outline.count; ++i) {
    if (leaf_.edge_count == Leaf::kMostEdges) return false;
    LeafEdge& e = leaf_.edges[std::size_t(leaf_.edge_count++)] = edges[std::size_t(i)];
    if (!(std::abs(e.bend) <= most_bend && e.end_bend <= most_bend)) return false;
    if (!(std::abs(e.next.bend) <= most_bend)) return false;
    e.x += float(shift.x), e.y += float(shift.y);
    e.end_x += float(shift.x), e.end_y += float(shift.y);
    e.next.x += float(shift.x), e.next.y += float(shift.y);
  }
  return true;
}

/// For which combinations of its edges' sides the outline's inside is met.
std::uint64_t BandPainter::pattern(const LeafOutline& outline, int first) const {
  const auto edge = [&](int i) { return kPatterns[std::size_t(first + i)]; };
  std::uint64_t all = ~std::uint64_t{0}, any = 0, wound = 0;
  for (int i = 0; i < outline.count; ++i) all &= edge(i), any |= edge(i);
  switch (outline.rule) {
    case EdgeRule::outside:
      return 0;
    case EdgeRule::inside:
      return ~std::uint64_t{0};
    case EdgeRule::all:
      return all;
    case EdgeRule::any:
      return any;
    default:
      break;
  }
  for (int sides = 0; sides < Leaf::kMostSides; ++sides) {
    int winding = outline.winding;
    for (int i = 0; i < outline.count; ++i)
      if (edge(i) >> sides & 1u) winding += leaf_.edges[std::size_t(first + i)].turn;
    const bool in = outline.rule == EdgeRule::nonzero ? winding != 0 : (winding & 1) != 0;
    wound |= std::uint64_t(in) << sides;
  }
  return wound;
}

/// Edges and palette of the present leaf, or of a part of it; `shift`: the part's centre from the
/// leaf's. False if that is not proven for a square so large.
bool BandPainter::assemble(std::span<const LeafOutline> outlines, std::span<const LeafEdge> edges,
                           glm::dvec2 shift, double side, double most_bend) {
  leaf_.edge_count = 0;
  varies_here_ = false;
  double error = 0.0;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const int first = leaf_.edge_count;
    error += outlines[i].error;
    if (!(error <= plan_->tolerance) || !add_edges(outlines[i], edges, shift, most_bend))
      return false;
    const std::uint64_t in = pattern(outlines[i], first);
    leaf_sides_[std::size_t(leaf_wanted_[i])] = {in, ~in};
  }
  varies_here_ = !color_leaf(leaf_center_ + shift, side);
  return !varies_here_;
}

/// The palette of the present edges; false where a colour that can be seen varies in the square.
bool BandPainter::color_leaf(glm::dvec2 center, double side) {
  const Tape& tape = plan_->tape;
  const int count = 1 << leaf_.edge_count;
  std::uint64_t open = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  std::uint64_t mixed = 0;
  leaf_.blend = tape.blend;
  leaf_.opaque = true;
  const auto set = [&](int i, const Mix& mix) {
    for (std::size_t c = 0; c < 4; ++c)
      leaf_.palette[c][std::size_t(i)] = float(255.0 * mix[int(c)]);
  };
  const auto finish = [&](std::uint64_t lanes, const Mix& mix, std::uint32_t packed, int same) {
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      if (mixed >> i & 1u) {
        mixes_[std::size_t(i)] = over(mixes_[std::size_t(i)], mix);
        continue;
      }
      set(i, mix);
      leaf_.packed[std::size_t(i)] = packed, leaf_.same[std::size_t(i)] = std::uint8_t(same);
    }
  };
  int number = 0;
  for (const int layer : leaf_layers_) {
    const TapeLayer& l = tape.layers[std::size_t(layer)];
    const std::span<const Step> steps{tape.steps.data() + l.first, std::size_t(l.count)};
    const std::uint64_t in = sides_of(steps, leaf_sides_, stack_).in & open;
    ++number;
    if (!in) continue;
    const std::optional<Mix> seen = l.plain() ? l.mix : mix_of(layer, center, side);
    if (!seen) return false;
    const Mix& layer_mix = *seen;
    if (layer_mix.a >= 1.0) {
      finish(in, layer_mix,
             l.plain() ? plan_->packed[std::size_t(layer)] : packed_pixel(layer_mix, tape.blend),
             number);
      open &= ~in;
      if (!open) break;
      continue;
    }
    for (std::uint64_t lanes = in; lanes; lanes &= lanes - 1) {
      const auto i = std::size_t(std::countr_zero(lanes));
      mixes_[i] = mixed >> i & 1u ? over(mixes_[i], layer_mix) : layer_mix;
      mixed |= std::uint64_t{1} << i;
    }
  }
  finish(open, tape.background, plan_->background, 0);
  leaf_.opaque = tape.background.a >= 1.0;
  for (std::uint64_t lanes = mixed; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const Mix& mix = mixes_[std::size_t(i)];
    set(i, mix);
    store(mix, tape.blend, Depth::u8, &leaf_.packed[std::size_t(i)]);
    leaf_.same[std::size_t(i)] = std::uint8_t(128 + i);
    leaf_.opaque = leaf_.opaque && mix.a >= 1.0 - 1e-9;
  }
  return true;
}

/// Draws blocks of the present leaf.
void BandPainter::paint(std::uint32_t blocks) {
  const PixelRect part = visible({leaf_x_, leaf_y_, kLeaf, kLeaf});
  const bool whole = part.width == kLeaf && part.height == kLeaf;
  const auto scalar = [&](int x, int y, void* to) {
    long long cells = 0;
    const Mix mix = leaf_pixel(leaf_, x - 7.5, y - 7.5, plan_->tolerance, cells);
    stats_->cells += cells;
    store(mix / 255.0, plan_->tape.blend, target_->depth, to);
  };
  if (target_->depth != Depth::u8 || !leaf_.opaque) {
    for (int y = 0; y < kLeaf; ++y)
      for (int x = 0; x < kLeaf; ++x) {
        const int px = leaf_x_ + x, py = leaf_y_ + y;
        const bool shown =
            px >= part.x && px < part.x + part.width && py >= part.y && py < part.y + part.height;
        if (shown && (blocks >> (y / 4 * 4 + x / 4) & 1u)) scalar(x, y, at(px, py));
      }
    LeafPixels none;
    none.edge_blocks = blocks;
    return count(none, blocks, part);
  }
  std::uint32_t* to = scratch_.data();
  std::size_t stride = kLeaf;
  // Rows of a target are whole pixels apart wherever callers let them be.
  if (whole && target_->stride % 4 == 0 && reinterpret_cast<std::uintptr_t>(target_->data) % 4 == 0)
    to = reinterpret_cast<std::uint32_t*>(at(leaf_x_, leaf_y_)), stride = target_->stride / 4;
  LeafPixels left;
  paint_leaf(leaf_, blocks, to, stride, left);
  count(left, blocks, part);
  if (to != scratch_.data()) return;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) {
      const int bx = x - leaf_x_, by = y - leaf_y_;
      if (blocks >> (by / 4 * 4 + bx / 4) & 1u)
        std::memcpy(at(x, y), &scratch_[std::size_t(by * kLeaf + bx)], 4);
    }
}

/// Counts the shown pixels of blocks just drawn.
void BandPainter::count(const LeafPixels& left, std::uint32_t blocks, const PixelRect& part) {
  if (part.width == kLeaf && part.height == kLeaf) {
    const int edges = std::popcount(left.edge_blocks & blocks);
    stats_->one_edge_pixels += 16 * edges - left.count;
    stats_->fill_pixels += 16 * (std::popcount(blocks) - edges);
    stats_->divided_pixels += left.count;
    return;
  }
  for (; blocks; blocks &= blocks - 1) {
    const int b = std::countr_zero(blocks), x = leaf_x_ + 4 * (b % 4), y = leaf_y_ + 4 * (b / 4);
    const int width = std::min(x + 4, part.x + part.width) - std::max(x, part.x);
    const int height = std::min(y + 4, part.y + part.height) - std::max(y, part.y);
    if (width <= 0 || height <= 0) continue;
    (left.edge_blocks >> b & 1u ? stats_->one_edge_pixels : stats_->fill_pixels) += width * height;
  }
  for (int i = 0; i < left.count; ++i) {
    const int x = leaf_x_ + left.at[std::size_t(i)] % kLeaf,
              y = leaf_y_ + left.at[std::size_t(i)] / kLeaf;
    if (x < part.x || x >= part.x + part.width || y < part.y || y >= part.y + part.height) continue;
    ++stats_->divided_pixels, --stats_->one_edge_pixels;
  }
}

/// The present leaf's outlines in parts of it: edges where they may cross, by distance, else a side.
void BandPainter::find_outlines(const Leaves& squares, Parts& to) {
  auto& [found, edges, list] = to;
  found.resize(leaf_wanted_.size()), list.resize(leaf_wanted_.size());
  edges.clear();
  std::array<float, Leaves::kMost> xs, ys;
  for (std::size_t i = 0; i < Leaves::kMost; ++i)
    xs[i] = float(squares.x[i]), ys[i] = float(squares.y[i]);
  const auto all = std::size_t(std::bit_width(squares.wanted));
  for (std::size_t i = 0; i < leaf_wanted_.size(); ++i) {
    if (leaf_list_[i].count == 0 && leaf_list_[i].error <= plan_->tolerance) {
      found[i].fill(leaf_list_[i]);
      continue;
    }
    const Sides sides =
        classified(leaf_wanted_[i], {xs.data(), all}, {ys.data(), all}, float(squares.radius));
    for (std::size_t k = 0; k < all; ++k)
      found[i][k] = {.rule = sides.in >> k & 1u ? EdgeRule::inside : EdgeRule::outside,
                     .error = 0.0};
    Leaves near = squares;
    near.wanted = std::uint32_t(sides.unknown()) & squares.wanted;
    if (near.wanted) plan_->outlines[std::size_t(leaf_wanted_[i])].in_leaves(near, found[i], edges);
  }
}

/// The quarters of a square of the present leaf by edges of their own: `center` from the leaf's, its
/// first block. A square of one block is left to the pixels.
void BandPainter::divide(glm::dvec2 center, int side, int block_x, int block_y) {
  if (side == 4) return pixel_by_pixel(center, block_x, block_y);
  const int half = side / 2, step = side / 8;
  const double quarter = 0.25 * side;
  Leaves quarters;
  quarters.wanted = 0xF;
  quarters.radius = kSqrtHalf * half;
  std::array<glm::dvec2, 4> centers;
  for (std::size_t i = 0; i < Leaves::kMost; ++i) {
    const glm::dvec2 c =
        center + quarter * glm::dvec2{double(2 * int(i & 1)) - 1.0, double(int(i & 2)) - 1.0};
    if (i < 4) centers[i] = c;
    quarters.x[i] = leaf_center_.x + c.x, quarters.y[i] = leaf_center_.y + c.y;
  }
  Parts& parts = parts_[side == kLeaf ? 0 : 1];  // quarters may be divided themselves
  find_outlines(quarters, parts);
  const auto& [found, edges, list] = parts;
  for (int q = 0; q < 4; ++q) {
    const int x = block_x + (q & 1) * step, y = block_y + (q >> 1) * step;
    for (std::size_t i = 0; i < list.size(); ++i) parts.list[i] = found[i][std::size_t(q)];
    if (assemble(list, edges, centers[std::size_t(q)], half, kMostLeafBend)) {
      std::uint32_t blocks = 0;
      for (int j = y; j < y + half / 4; ++j)
        for (int i = x; i < x + half / 4; ++i) blocks |= 1u << (4 * j + i);
      paint(blocks);
    } else if (varies_here_) {
      if (!lit_square(centers[std::size_t(q)], 4 * x, 4 * y, half)) sure_square(x, y, half);
    } else {
      divide(centers[std::size_t(q)], half, x, y);
    }
  }
}

/// Every part asks all outlines of its leaf, up to 4096 times a pixel: with hundreds of them, as in a mesh,
/// the sure way, which leaves behind what a part does not need, is a hundred times faster.
constexpr std::size_t kMostInCells = 32;

/// The mean colour times 255 of a square of the present leaf, a pixel or less, by the present edges.
Mix BandPainter::square(glm::dvec2 center, double side, std::uint32_t asked, std::uint32_t base) {
  if (target_->depth == Depth::u8 && leaf_.opaque)
    return square_in_parts(leaf_, center.x, center.y, side, asked, base);
  return leaf_square(leaf_, center.x, center.y, side, asked, base, plan_->tolerance, stats_->cells);
}

/// A block of 4 × 4 pixels that its edges do not describe: by every pixel's own edges, and where those
/// are not proven either, by the sure way.
void BandPainter::pixel_by_pixel(glm::dvec2 center, int block_x, int block_y) {
  const PixelRect part = visible({leaf_x_ + 4 * block_x, leaf_y_ + 4 * block_y, 4, 4});
  Leaves pixels;
  pixels.wanted = 0xFFFF;
  pixels.radius = kSqrtHalf;
  for (std::size_t i = 0; i < Leaves::kMost; ++i) {
    pixels.x[i] = leaf_center_.x + center.x + double(i % 4) - 1.5;
    pixels.y[i] = leaf_center_.y + center.y + double(i / 4) - 1.5;
  }
  Parts& parts = parts_[2];
  find_outlines(pixels, parts);
  const auto& [found, edges, list] = parts;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) {
      const auto i = std::size_t(4 * (y - leaf_y_ - 4 * block_y) + x - leaf_x_ - 4 * block_x);
      for (std::size_t k = 0; k < list.size(); ++k) parts.list[k] = found[k][i];
      const glm::dvec2 at_pixel = center + glm::dvec2{double(i % 4) - 1.5, double(i / 4) - 1.5};
      varied_ = false;
      std::optional<Mix> mix = described(list, edges, at_pixel, 1.0, kMostPixelBend);
      if (!mix && varies_here_) {  // its edges are the present ones
        if (lit_square(at_pixel, x - leaf_x_, y - leaf_y_, 1)) continue;
      } else if (!mix && leaf_wanted_.size() <= kMostInCells) {
        mix = cells(at_pixel, 1.0, 0);
      }
      if (!mix) {
        draw_square(plan_->tape, leaf_layers_, width_, height_, x, y, 1, *target_, *stats_);
        continue;
      }
      put(*mix, x, y);
      ++stats_->divided_pixels;
    }
}

/// A square of the present leaf in which a colour varies or a group is seen, its edges assembled, in vectors; its first
/// pixel. False: not this way.
bool BandPainter::lit_square(glm::dvec2 shift, int leaf_x, int leaf_y, int side) {
  if (target_->depth != Depth::u8) return false;
  square_layers_.clear();
  const auto all = std::uint32_t((std::uint64_t{1} << (1 << leaf_.edge_count)) - 1);
  bool wanted = false;
  for (const int layer : leaf_layers_) {
    const TapeLayer& l = plan_->tape.layers[std::size_t(layer)];
    const std::span<const Step> steps{plan_->tape.steps.data() + l.first, std::size_t(l.count)};
    SquareLayer seen{.in = std::uint32_t(sides_of(steps, leaf_sides_, stack_).in) & all,
                     .mix = l.mix,
                     .paint = l.paint,
                     .group = l.group};
    if (!seen.in) continue;
    if (l.paint >= 0)
      if (const auto mix = paints_->constant(l.paint, leaf_center_ + shift, kSqrtHalf * side))
        seen.mix = *mix, seen.paint = -1;
    wanted |= seen.group >= 0 || seen.paint >= 0;
    square_layers_.push_back(seen);
  }
  const int x = leaf_x_ + leaf_x, y = leaf_y_ + leaf_y;
  const VariedSquare::Place place{leaf_center_, shift, side, x, y};
  if (!wanted || !lit_->draw(leaf_, square_layers_, place, plan_->tolerance, scratch_.data()))
    return false;
  const PixelRect part = visible({x, y, side, side});
  for (int row = part.y; row < part.y + part.height; ++row)
    std::memcpy(at(part.x, row), &scratch_[std::size_t((row - y) * side + part.x - x)],
                4 * std::size_t(std::max(part.width, 0)));
  stats_->varied_pixels += (long long)std::max(part.width, 0) * std::max(part.height, 0);
  return true;
}

/// A square of the present leaf by the sure way; its first block.
void BandPainter::sure_square(int block_x, int block_y, int side) {
  draw_square(plan_->tape, leaf_layers_, width_, height_, leaf_x_ + 4 * block_x,
              leaf_y_ + 4 * block_y, side, *target_, *stats_);
}

/// A part of 1/64 px that nothing describes for sure: by the edges that are likely, or the side its
/// centre is on. A corner is in a few of those, of 1/4096 of a pixel each.
std::optional<Mix> BandPainter::undescribed(glm::dvec2 at_part, double side, Parts& parts) {
  const auto sided = [&](LeafOutline& outline, std::size_t k) {
    const bool in =
        distance(plan_->tape.outlines[std::size_t(leaf_wanted_[k])], leaf_center_ + at_part) <= 0.0;
    outline = {.rule = in ? EdgeRule::inside : EdgeRule::outside, .error = 0.0};
  };
  for (std::size_t k = 0; k < parts.list.size(); ++k) {
    LeafOutline& outline = parts.list[k];
    if (outline.count == 0 && outline.error > 0.0) sided(outline, k);
    outline.error = 0.0;
  }
  auto mix = described(parts.list, parts.edges, at_part, side, kMostPixelBend / side);
  if (mix || varies_here_) return mix;
  for (std::size_t k = 0; k < parts.list.size(); ++k) sided(parts.list[k], k);
  return described(parts.list, parts.edges, at_part, side, kMostPixelBend / side);
}

/// The mean colour of a square that its edges do not describe: by the edges of its sixteen
/// parts, and of theirs. Nothing where a colour varies, or the target is finer.
std::optional<Mix> BandPainter::cells(glm::dvec2 center, double side, int depth) {
  if (target_->depth != Depth::u8) return {};
  const double step = 0.25 * side;
  Leaves squares;
  squares.wanted = 0xFFFF;
  squares.radius = kSqrtHalf * step;
  const auto part = [&](std::size_t i) {
    return center + step * glm::dvec2{double(i % 4) - 1.5, double(i / 4) - 1.5};
  };
  for (std::size_t i = 0; i < Leaves::kMost; ++i) {
    const glm::dvec2 c = leaf_center_ + part(i);
    squares.x[i] = c.x, squares.y[i] = c.y;
  }
  Parts& parts = parts_[std::size_t(3 + depth)];
  find_outlines(squares, parts);
  const auto& [found, edges, list] = parts;
  Mix sum{0.0};
  stats_->cells += int(Leaves::kMost);
  for (std::size_t i = 0; i < Leaves::kMost; ++i) {
    for (std::size_t k = 0; k < list.size(); ++k) parts.list[k] = found[k][i];
    const glm::dvec2 at_part = part(i);
    std::optional<Mix> mix = described(list, edges, at_part, step, kMostPixelBend / step);
    if (!mix && varies_here_) return {};
    if (!mix)
      mix = depth + 1 < kCellLevels ? cells(at_part, step, depth + 1)
                                    : undescribed(at_part, step, parts);
    if (!mix) return {};
    sum += *mix;
  }
  return sum / 16.0;
}

std::byte* BandPainter::at(int x, int y) const {
  return target_->data + target_->stride * std::size_t(y - target_->rect.y) +
         4 * bytes_per_channel(target_->depth) * std::size_t(x - target_->rect.x);
}

PixelRect BandPainter::visible(const PixelRect& s) const {
  const PixelRect& r = target_->rect;
  const int x = std::max(s.x, r.x), y = std::max(s.y, r.y);
  return {x, y, std::min(s.x + s.width, r.x + r.width) - x,
          std::min(s.y + s.height, r.y + r.height) - y};
}

void BandPainter::fill(const Squares& squares, int lane, const PixelRect& square) {
  const int color = squares.color[std::size_t(lane)];
  if (color == kComposite || target_->depth != Depth::u8)
    return fill_slowly(square, color == kComposite    ? composite(squares, lane)
                               : color == kBackground ? plan_->tape.background
                                                      : plan_->tape.layers[std::size_t(color)].mix);
  fill(square, color == kBackground ? plan_->background : plan_->packed[std::size_t(color)]);
}

void BandPainter::fill(const PixelRect& square, std::uint32_t value) {
  const PixelRect part = visible(square);
  if (part.width <= 0 || part.height <= 0) return;
  stats_->fill_pixels += (long long)part.width * part.height;
  if (target_->stride % 4 != 0 || reinterpret_cast<std::uintptr_t>(target_->data) % 4 != 0) {
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x) std::memcpy(at(part.x + x, part.y + y), &value, 4);
    return;
  }
  fill_rows(reinterpret_cast<std::uint32_t*>(at(part.x, part.y)), target_->stride / 4, part.height,
            part.width, value, stores_);
}

void BandPainter::fill_slowly(const PixelRect& square, const Mix& mix) {
  const PixelRect part = visible(square);
  if (part.width <= 0 || part.height <= 0) return;
  stats_->fill_pixels += (long long)part.width * part.height;
  std::array<std::byte, 16> pixel;
  store(mix, plan_->tape.blend, target_->depth, pixel.data());
  const std::size_t size = 4 * bytes_per_channel(target_->depth);
  std::byte* const first = at(part.x, part.y);
  for (int i = 0; i < part.width; ++i)
    std::memcpy(first + size * std::size_t(i), pixel.data(), size);
  for (int j = 1; j < part.height; ++j)
    std::memcpy(first + target_->stride * std::size_t(j), first, size * std::size_t(part.width));
}

}  // namespace mien
