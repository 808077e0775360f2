#include <mien/render/rows/row_painter.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mien {
namespace {

constexpr float kSame = 1e-5f;    // sums of thousands of cells agree with their look to less
constexpr float kNoArea = 1e-6f;  // a share of less shows nowhere
constexpr float kClosed = 1e-5f;  // a look that goes on by less has ended

bool close(const Rgba& x, const Rgba& y) {
  return std::abs(x.r - y.r) < kSame && std::abs(x.g - y.g) < kSame &&
         std::abs(x.b - y.b) < kSame && std::abs(x.a - y.a) < kSame;
}

}  // namespace

void Palette::make(const Looks& looks, const PixelFormat& format, int first_look) {
  first = first_look;
  entries.resize(std::size_t(looks.count()));
  for (int i = 0; i < looks.count(); ++i) {
    Entry& e = entries[std::size_t(i)];
    e.varies = !looks.constant(i);
    e.color = rgba_from_mix(looks.mix(i));
    if (!e.varies) store(looks.mix(i), format.blend(), format.depth(), e.pixel.data());
  }
}

void RowPainter::begin(const Palette& palette, const Looks& looks, const PixelFormat& format,
                       bool dither) {
  palette_ = &palette, looks_ = &looks, format_ = &format, dither_ = dither;
  bytes_ = format.bytes();
  shader_.begin(looks);
}

/// Whether what is neglected shows: it counts by how steeply the colour is encoded.
bool RowPainter::too_rough(double neglected, const Rgba& mix, int column) const {
  const double allowed = format_->depth() == Depth::u8 ? 0.4 / 255 : 8.0 / 65535;
  if (!note_ && neglected * (format_->blend() == Blend::linear ? 12.92 : 1.0) <= allowed)
    return false;
  const double off = neglected * format_->steepness(mix);
  if (note_) note_(column, y_, float(255.0 * std::min(off, allowed)));
  return off > allowed;
}

float RowPainter::carry(int x) const {
  return dither_ ? float(dither_threshold(x, y_)) : 0.5f;
}

void RowPainter::paint(int y, RowSums& sums, int row, int x0, int x1, std::byte* to,
                       RenderStats& stats) {
  y_ = y, x0_ = x0, x1_ = x1, to_ = to, stats_ = &stats;
  hints_ = sums.hints(row);
  shares_ = &sums.shares(row);
  refused_.clear();
  std::sort(shares_->begin(), shares_->end(),
            [](const LookShare& a, const LookShare& b) { return a.column < b.column; });
  next_share_ = 0;
  open_.clear(), formed_.clear();
  look_ = palette_->first;
  sum_ = palette_->entries[std::size_t(look_)].color;
  if (palette_->entries[std::size_t(look_)].varies) open_.push_back(whole(look_));
  Rgba* const cells = sums.sums(row);
  std::uint64_t* const marks = sums.marks(row);
  int at = 0;
  for (int w = 0; w < sums.mark_words(); ++w) {
    for (std::uint64_t bits = std::exchange(marks[w], 0); bits; bits &= bits - 1) {
      const int column = 64 * w + std::countr_zero(bits);
      if (column < x1) {
        if (column > at) run(at, column);
        sum_ = sum_ + cells[column];
        take_shares(column);
        cell(column);
        at = column + 1;
      }
      cells[column] = {};
    }
  }
  if (at < x1) run(at, x1);
  shares_->clear();
}

/// Whether a look is what all the sums up to here say.
bool RowPainter::looks_like(int look) const {
  const Palette::Entry& e = palette_->entries[std::size_t(look)];
  if (!close(sum_, e.color)) return false;
  if (!e.varies) return open_.empty();
  return open_.size() == 1 && open_[0].look == look;
}

/// The look of the run that begins at a column; −1 if none of those it may be agrees.
int RowPainter::look_of_run(int column) const {
  if (column > 0 && looks_like(hints_[column - 1])) return hints_[column - 1];
  if (looks_like(look_)) return look_;
  for (int i = 0; i < int(palette_->entries.size()); ++i)
    if (looks_like(i)) return i;
  return -1;
}

/// A look that fills the row from the left.
RowPainter::Open RowPainter::whole(int look) {
  Open o{look, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, {}};
  o.left.fill(1.0f / PartForm::kRows);
  return o;
}

/// What stretches did to this pixel they do to all after it.
void RowPainter::move_on() {
  for (const auto& [look, stretch] : formed_)
    for (Open& o : open_)
      if (o.look == look) add_height(stretch, o.left);
  formed_.clear();
}

void RowPainter::run(int from, int until) {
  move_on();
  // A varied look that has all but ended or all but filled the row goes on as if it had.
  std::erase_if(open_, [](const Open& o) { return std::abs(o.height) < kClosed; });
  const int look = look_of_run(from);
  if (look >= 0) {
    look_ = look;
    sum_ = palette_->entries[std::size_t(look)].color;
    if (!open_.empty()) open_[0] = whole(look);
  }
  from = std::max(from, x0_), until = std::min(until, x1_);
  if (from >= until) return;
  if (look >= 0) return run_of(look, from, until);
  // Several looks one above the other: a level outline within the row, or roundings.
  for (int x = from; x < until; ++x) {
    for (Open& o : open_) o.area = o.height, o.mx = 0.0f, o.my = o.height_y;
    cell(x);
  }
}

void RowPainter::run_of(int look, int from, int until) {
  const Palette::Entry& e = palette_->entries[std::size_t(look)];
  if (!e.varies) {
    stats_->fill_pixels += until - from;
    return fill_pixels(at(from), until - from, e.pixel.data(), bytes_);
  }
  stats_->varied_pixels += until - from;
  const double neglected = looks_->neglected(look);
  const bool tip = looks_->has_tip(look);
  while (from < until) {
    const int block_end = (from & ~(LookShader::kBlock - 1)) + LookShader::kBlock;
    const int count = std::min(until, block_end) - from;
    const ColorRow& c = shader_.pixels(look, from, y_, count);
    for (int i = 0; i < count; ++i) {
      const auto k = std::size_t(i);
      Rgba mix{c.r[k], c.g[k], c.b[k], c.a[k]};
      double off = neglected;
      if (tip) off += looks_->neglected_near(look, {from + i + 0.5, y_ + 0.5}, false);
      if (off > 0.0 && too_rough(off, mix, from + i)) rough_.push_back(from + i);
      format_->put(mix, carry(from + i), at(from + i));
    }
    from += count;
  }
  for (const int x : rough_) {
    if (looks_->dense(look)) refused_.push_back(x);
    const glm::vec4 c = shader_.by_cells(look, x, y_, nullptr, cell_side());
    format_->put({c.r, c.g, c.b, c.a}, carry(x), at(x));
  }
  rough_.clear();
}

/// What varied looks take of the pixel, and of those after it.
void RowPainter::take_shares(int column) {
  move_on();
  for (Open& o : open_) o.area = o.height, o.mx = 0.0f, o.my = o.height_y;
  for (; next_share_ < shares_->size() && (*shares_)[next_share_].column <= column; ++next_share_) {
    const LookShare& s = (*shares_)[next_share_];
    auto found =
        std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.look == s.look; });
    if (found == open_.end()) found = open_.insert(found, {s.look, 0, 0, 0, 0, 0, {}});
    found->area += s.area, found->mx += s.mx, found->my += s.my;
    found->height += s.height, found->height_y += s.height_y;
    if (looks_->formed(s.look)) formed_.push_back({s.look, s.stretch});
  }
}

/// The mean over what a look takes of the pixel.
glm::vec4 RowPainter::part(const Open& o, int column, bool by_cells) {
  const float up = 1.0f / o.area;
  const float x = std::clamp(o.mx * up, -0.4999f, 0.4999f),
              y = std::clamp(o.my * up, -0.4999f, 0.4999f);
  const double area = std::min(double(std::abs(o.area)), 1.0);
  if (!looks_->formed(o.look))
    return shader_.part(o.look, column + 0.5 + double(x), y_ + 0.5 + double(y), area);
  stretches_.clear();
  for (const auto& [look, stretch] : formed_)
    if (look == o.look) stretches_.push_back(stretch);
  const PartForm form{o.left, stretches_};
  if (by_cells) return shader_.by_cells(o.look, column, y_, &form, cell_side());
  return shader_.part(o.look, column + 0.5 + double(x), y_ + 0.5 + double(y), area, &form);
}

Rgba RowPainter::parts(int column, bool by_cells) {
  Rgba mix = sum_;
  for (const Open& o : open_) {
    if (std::abs(o.area) < kNoArea) continue;
    const glm::vec4 c = part(o, column, by_cells);
    mix = mix + o.area * Rgba{c.r, c.g, c.b, c.a};
  }
  return mix;
}

void RowPainter::cell(int column) {
  if (column < x0_ || column >= x1_) return;
  ++stats_->edge_pixels;
  Rgba mix = parts(column, false);
  double neglected = 0.0;
  bool varies = false, dense = false;
  for (const Open& o : open_) {
    if (std::abs(o.area) < kNoArea) continue;
    neglected +=
        double(std::abs(o.area)) * (looks_->neglected(o.look) +
                                    looks_->neglected_near(o.look, {column + 0.5, y_ + 0.5}, true));
    varies = true, dense = dense || looks_->dense(o.look);
  }
  if (neglected > 0.0 && too_rough(neglected, mix, column)) {
    if (dense) refused_.push_back(column);
    mix = parts(column, true);
  }
  format_->put(mix, varies ? carry(column) : 0.5f, at(column));
}

}  // namespace mien
