#include <mien/render/rows/row_painter.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

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
  thresholds_.fill(0.5f);
}

/// What is neglected counts by how steeply the colour is encoded.
void RowPainter::refuse(double neglected, const Rgba& mix, int column) {
  const double allowed = format_->depth() == Depth::u8 ? 0.4 / 255 : 8.0 / 65535;
  if (!note_ && neglected * (format_->blend() == Blend::linear ? 12.92 : 1.0) <= allowed) return;
  const double off = neglected * format_->steepness(mix);
  if (note_) note_(column, y_, float(255.0 * off));
  if (off > allowed) refused_.push_back(column);
}

void RowPainter::paint(int y, RowSums& sums, int row, int x0, int x1, std::byte* to,
                       RenderStats& stats) {
  y_ = y, x0_ = x0, x1_ = x1, to_ = to, stats_ = &stats;
  hints_ = sums.hints(row);
  shares_ = &sums.shares(row);
  refused_.clear(), columns_.clear(), carries_.clear();
  cells_.room_for(std::size_t(x1 - x0));
  if (dither_) {
    constexpr std::size_t kPeriod = 8;
    for (std::size_t i = 0; i < thresholds_.size(); ++i)
      thresholds_[i] = i < kPeriod ? float(dither_threshold(int(i), y)) : thresholds_[i - kPeriod];
  }
  std::sort(shares_->begin(), shares_->end(),
            [](const LookShare& a, const LookShare& b) { return a.column < b.column; });
  next_share_ = 0;
  open_.clear();
  look_ = palette_->first;
  sum_ = palette_->entries[std::size_t(look_)].color;
  if (palette_->entries[std::size_t(look_)].varies)
    open_.push_back({look_, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f});
  Rgba* const cells = sums.sums(row);
  std::uint64_t* const marks = sums.marks(row);
  int at = 0;
  for (int w = 0; w < sums.mark_words(); ++w) {
    for (std::uint64_t bits = std::exchange(marks[w], 0); bits; bits &= bits - 1) {
      const int column = 64 * w + std::countr_zero(bits);
      if (column < x1) {
        if (column > at) run(at, column);
        sum_ = sum_ + cells[column];
        if (!open_.empty() || next_share_ < shares_->size()) take_shares(column);
        cell(column);
        at = column + 1;
        sum_ = sum_ + cells[at];  // what the pixel's outlines leave of all those after it
      }
      cells[column] = cells[column + 1] = {};
    }
  }
  if (at < x1) run(at, x1);
  put_cells();
  shares_->clear();
}

void RowPainter::put_cells() {
  const int count = int(columns_.size());
  carries_.resize(columns_.size() + kColorSpare, 0.5f);
  made_.resize(bytes_ * columns_.size());
  format_->put(cells_.planes(), carries_.data(), count, made_.data());
  scatter_pixels(made_.data(), columns_, bytes_, at(0));
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

void RowPainter::run(int from, int until) {
  // A varied look that has all but ended or all but filled the row goes on as if it had.
  if (!open_.empty())
    std::erase_if(open_, [](const Open& o) { return std::abs(o.height) < kClosed; });
  const int look = look_of_run(from);
  if (look >= 0) {
    look_ = look;
    sum_ = palette_->entries[std::size_t(look)].color;
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
  while (from < until) {
    const int first = from & ~(LookShader::kBlock - 1);
    const int count = std::min(until, first + LookShader::kBlock) - from;
    const ColorRow& c = shader_.pixels(look, from, y_, count);
    format_->put(c.planes(), &thresholds_[std::size_t(from - first)], count, at(from));
    if (looks_->neglected(look) > 0.0 || looks_->has_tip(look)) refuse_run(look, from, count, c);
    from += count;
  }
}

void RowPainter::refuse_run(int look, int from, int count, const ColorRow& c) {
  const double neglected = looks_->neglected(look);
  const bool tip = looks_->has_tip(look);
  for (int i = 0; i < count; ++i) {
    const auto k = std::size_t(i);
    const double near =
        tip ? looks_->neglected_near(look, {from + i + 0.5, y_ + 0.5}, false) : 0.0;
    refuse(neglected + near, {c.r[k], c.g[k], c.b[k], c.a[k]}, from + i);
  }
}

/// What varied looks take of the pixel, and of those after it.
void RowPainter::take_shares(int column) {
  for (Open& o : open_) o.area = o.height, o.mx = 0.0f, o.my = o.height_y;
  for (; next_share_ < shares_->size() && (*shares_)[next_share_].column <= column; ++next_share_) {
    const LookShare& s = (*shares_)[next_share_];
    auto found =
        std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.look == s.look; });
    if (found == open_.end()) found = open_.insert(found, {s.look, 0, 0, 0, 0, 0});
    found->area += s.area, found->mx += s.mx, found->my += s.my;
    found->height += s.height, found->height_y += s.height_y;
  }
}

void RowPainter::cell(int column) {
  if (column < x0_ || column >= x1_) return;
  ++stats_->edge_pixels;
  Rgba mix = sum_;
  double neglected = 0.0;
  bool varies = false;
  for (const Open& o : open_) {
    if (std::abs(o.area) < kNoArea) continue;
    const float up = 1.0f / o.area;
    const float x = std::clamp(o.mx * up, -0.5f, 0.5f), y = std::clamp(o.my * up, -0.5f, 0.5f);
    const glm::vec4 c = shader_.part(o.look, column + 0.5 + double(x), y_ + 0.5 + double(y),
                                     std::min(double(std::abs(o.area)), 1.0));
    mix = mix + o.area * Rgba{c.r, c.g, c.b, c.a};
    neglected +=
        double(std::abs(o.area)) * (looks_->neglected(o.look) + looks_->estimated(o.look) +
                                    looks_->neglected_near(o.look, {column + 0.5, y_ + 0.5}, true));
    varies = true;
  }
  if (neglected > 0.0) refuse(neglected, mix, column);
  const std::size_t k = columns_.size();
  cells_.r[k] = mix.r, cells_.g[k] = mix.g, cells_.b[k] = mix.b, cells_.a[k] = mix.a;
  columns_.push_back(column);
  carries_.push_back(varies ? thresholds_[std::size_t(column % LookShader::kBlock)] : 0.5f);
}

}  // namespace mien
