#include "render/rows/row_painter.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace mien {
namespace {

constexpr float kSame = 1e-5f;        // sums of thousands of cells agree with their look to less
constexpr float kUnseenArea = 1e-6f;  // a share of less shows nowhere
constexpr float kClosed = 1e-5f;      // a look that goes on by less than this has ended
constexpr float kFilled = 1e-4f;      // and one that lacks less than this fills the row

bool close(const Rgba& x, const Rgba& y) {
  return std::max(std::max(std::abs(x.r - y.r), std::abs(x.g - y.g)),
                  std::max(std::abs(x.b - y.b), std::abs(x.a - y.a))) < kSame;
}

}  // namespace

void Palette::make(const Looks& looks, const PixelFormat& format, int first_look) {
  first = first_look;
  entries.resize(std::size_t(looks.count()));
  any_varies = false;
  for (int i = 0; i < looks.count(); ++i) {
    Entry& e = entries[std::size_t(i)];
    e.varies = !looks.constant(i);
    any_varies = any_varies || e.varies;
    e.color = rgba_from_mix(looks.mix(i));
    if (e.varies) continue;
    store(looks.mix(i), format.blend(), format.depth(), e.pixels.data());
    for (std::size_t k = format.bytes(); k < e.pixels.size(); k *= 2)
      std::memcpy(&e.pixels[k], e.pixels.data(), k);
  }
}

void RowPainter::begin(const Palette& palette, const Looks& looks, const PixelFormat& format,
                       bool dither, Stores stores) {
  stores_ = stores;
  palette_ = &palette, looks_ = &looks, format_ = &format, dither_ = dither;
  if (bytes_ != format.bytes()) columns_.clear();  // room is made anew
  bytes_ = format.bytes();
  shader_.begin(looks);
  allowed_ = format.depth() == Depth::u8 ? 0.2 / 255 : 4.0 / 65535;
  // A twentieth of what is permitted, where colours are encoded most steeply.
  least_ = notes_ ? 0.0 : 0.05 * allowed_ / (format.blend() == Blend::linear ? 12.92 : 1.0);
  thresholds_.fill(0.5f);
}

/// Into how many cells each way a pixel must be divided so that what is neglected does not show; 0: into none. What
/// is neglected counts by how steeply the colour is encoded, and falls with the square of the cells' side.
int RowPainter::cells_for(double neglected, const Rgba& mix, int column) const {
  if (!notes_ && neglected * (format_->blend() == Blend::linear ? 12.92 : 1.0) <= allowed_)
    return 0;
  const double off = neglected * format_->steepness(mix);
  if (notes_) notes_->level(column, y_) = float(255.0 * std::min(off, allowed_));
  if (off <= allowed_) return 0;
  const double share = format_->depth() == Depth::u8 ? 0.5 : 0.2;  // of what is permitted
  const int most = format_->depth() == Depth::u8 ? 16 : 32;
  int side = 4;
  while (side < most && off > share * allowed_ * side * side) side *= 2;
  return side;
}

void RowPainter::set_thresholds() {
  constexpr std::size_t kPeriod = 8;
  for (std::size_t i = 0; i < thresholds_.size(); ++i)
    thresholds_[i] = i < kPeriod ? float(dither_threshold(int(i), y_)) : thresholds_[i - kPeriod];
}

void RowPainter::room_for(std::size_t cells) {
  cells_.room_for(cells);
  if (columns_.size() >= cells) return;
  columns_.resize(cells), carries_.resize(cells + kColorSpare), made_.resize(bytes_ * cells);
}

void RowPainter::paint(int y, RowSums& sums, int row, int x0, int x1, std::byte* to,
                       RenderStats& stats) {
  worked(50 + x1);
  y_ = y, x0_ = x0, x1_ = x1, to_ = to, stats_ = &stats;
  hints_ = sums.hints(row);
  refused_.clear();
  room_for(std::size_t(x1 - x0));
  open_.clear(), taken_.clear(), parts_.clear();
  look_ = palette_->first;
  sum_ = palette_->entries[std::size_t(look_)].color;
  if (palette_->entries[std::size_t(look_)].varies) open_.push_back(whole(look_));
  if (open_.empty() && sums.shares(row).empty())
    paint_flat(sums, row);
  else
    paint_varied(sums, row);
  put_cells();
  refuse_doubtful();
}

void RowPainter::paint_varied(RowSums& sums, int row) {
  if (dither_) set_thresholds();
  shares_ = sums.shares(row), stretches_ = sums.stretches(row);
  moments_.make(stretches_);
  Rgba* const cells = sums.sums(row);
  std::uint64_t* const marks = sums.marks(row);
  int* const shares = sums.first_shares(row);
  int at = 0;
  for (int w = 0; w < sums.mark_words(); ++w) {
    for (std::uint64_t bits = std::exchange(marks[w], 0); bits; bits &= bits - 1) {
      const int column = 64 * w + std::countr_zero(bits);
      if (column < x1_) {
        if (column > at) run(at, column);
        sum_ = sum_ + cells[column];
        const int before = int(taken_.size());
        take_shares(shares[column]);
        cell(column, before);
        at = column + 1;
        sum_ = sum_ + cells[at];  // what the pixel's outlines add to all pixels after it
      }
      cells[column] = cells[column + 1] = {};
      shares[column] = -1;
    }
  }
  if (at < x1_) run(at, x1_);
  if (!parts_.empty()) shade_parts();
  sums.forget_shares(row);
}

/// The same where no look varies, with the sum in registers.
void RowPainter::paint_flat(RowSums& sums, int row) {
  Rgba* const cells = sums.sums(row);
  std::uint64_t* const marks = sums.marks(row);
  float r = sum_.r, g = sum_.g, b = sum_.b, a = sum_.a;  // each in a register
  const auto add = [&](const Rgba& c) { r += c.r, g += c.g, b += c.b, a += c.a; };
  const auto run_to = [&](int from, int until) {
    const Rgba sum = flat_run(from, until, {r, g, b, a});
    r = sum.r, g = sum.g, b = sum.b, a = sum.a;
  };
  int at = 0, kept = 0;
  for (int w = 0; w < sums.mark_words(); ++w) {
    for (std::uint64_t bits = std::exchange(marks[w], 0); bits; bits &= bits - 1) {
      const int column = 64 * w + std::countr_zero(bits);
      if (column < x1_) {
        if (column > at) run_to(at, column);
        add(cells[column]);
        if (column >= x0_) {
          const auto k = std::size_t(kept++);
          cells_.r[k] = r, cells_.g[k] = g, cells_.b[k] = b, cells_.a[k] = a;
          columns_[k] = column, carries_[k] = 0.5f;
        }
        at = column + 1;
        add(cells[at]);
      }
      cells[column] = cells[column + 1] = {};
    }
  }
  if (at < x1_) run_to(at, x1_);
  kept_ = kept;
  stats_->edge_pixels += kept;
}

/// Draws a run; returns its sum, as its look's own colour if that is known.
Rgba RowPainter::flat_run(int from, int until, const Rgba& sum) {
  const Palette::Entry* entry =
      &palette_->entries[std::size_t(from > 0 ? hints_[from - 1] : look_)];
  const bool hinted = !entry->varies && close(sum, entry->color);
  if (!hinted) {
    sum_ = sum;
    const int look = look_of_run(from);
    entry = look >= 0 ? &palette_->entries[std::size_t(look)] : nullptr;
  }
  const int first = std::max(from, x0_), end = std::min(until, x1_);
  if (first < end && entry) fill(first, end, entry->pixels);
  if (first < end && !entry) fill(first, end, pattern_of(sum));
  return entry ? entry->color : sum;
}

/// Columns of one colour. A short run is written as long as a pattern: what lies right of it is written later.
void RowPainter::fill(int first, int end, const RunPattern& pattern) {
  stats_->fill_pixels += end - first;
  const std::size_t size = std::size_t(end - first) * bytes_;
  if (size <= pattern.size() && std::size_t(x1_ - first) * bytes_ >= pattern.size())
    std::memcpy(at(first), pattern.data(), pattern.size());
  else
    fill_run(at(first), end - first, pattern, bytes_, stores_);
}

RunPattern RowPainter::pattern_of(const Rgba& mix) const {
  std::array<float, 1 + kColorSpare> r{mix.r}, g{mix.g}, b{mix.b}, a{mix.a}, carry{0.5f};
  RunPattern pattern;
  format_->put({r.data(), g.data(), b.data(), a.data()}, carry.data(), 1, pattern.data());
  for (std::size_t k = bytes_; k < pattern.size(); ++k) pattern[k] = pattern[k - bytes_];
  return pattern;
}

/// Whether the sum so far agrees with a look.
bool RowPainter::looks_like(int look) const {
  const Palette::Entry& e = palette_->entries[std::size_t(look)];
  if (!close(sum_, e.color)) return false;
  if (!e.varies) return open_.empty();
  // Over nothing the constant part of a varied look's sum is that of nothing, too.
  return open_.size() == 1 && open_[0].look == look && std::abs(open_[0].height - 1.0f) < kFilled;
}

/// The look of the run that begins at a column; −1 if none that may be agrees with the sum.
int RowPainter::look_of_run(int column) {
  if (column > 0 && looks_like(hints_[column - 1])) return hints_[column - 1];
  if (looks_like(look_)) return look_;
  return !open_.empty() && looks_like(open_[0].look) ? open_[0].look : -1;
}

/// A look that fills the row from here on.
RowPainter::Open RowPainter::whole(int look) const {
  return {look, {int(taken_.size()), true}, 1.0f, 0.0f, 1.0f / 12, {}};
}

void RowPainter::run(int from, int until) {
  // A varied look that has nearly ended, or nearly filled the row, is taken to have done so.
  if (!open_.empty())
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
  if (open_.empty()) return fill(from, until, pattern_of(sum_));
  // Several looks above each other: a level outline within the row, or rounding.
  for (int x = from; x < until; ++x) {
    for (Open& o : open_) o.go_on();
    cell(x, int(taken_.size()));
  }
}

void RowPainter::run_of(int look, int from, int until) {
  const Palette::Entry& e = palette_->entries[std::size_t(look)];
  if (!e.varies) return fill(from, until, e.pixels);
  stats_->varied_pixels += until - from;
  if (looks_->open(look)) {
    for (int x = from; x < until; ++x) refused_.push_back(x);
    return;
  }
  while (from < until) {
    const int first = from & ~(LookShader::kBlock - 1);
    const int count = std::min(until, first + LookShader::kBlock) - from;
    const ColorRow& c = shader_.pixels(look, from, y_, count);
    format_->put(c.planes(), &thresholds_[std::size_t(from - first)], count, at(from));
    mend_run(look, from, count, c);
    from += count;
  }
}

/// Where what is neglected would show in some pixels, these are divided into cells.
void RowPainter::mend_run(int look, int from, int count, const ColorRow& c) {
  const double neglected = looks_->neglected(look);
  if (notes_ && looks_->estimated(look))
    for (int i = 0; i < count; ++i) notes_->estimate(from + i, y_);
  if (neglected + double(shader_.most_neglected()) <= least_) return;
  rough_.clear();
  for (int i = 0; i < count; ++i) {
    const auto k = std::size_t(i);
    const double all = neglected + double(shader_.neglected()[k]);
    if (const int side = cells_for(all, {c.r[k], c.g[k], c.b[k], c.a[k]}, from + i))
      rough_.push_back({from + i, side});
  }
  for (const auto& [x, side] : rough_) {
    worked(30 * side * side);
    const glm::vec4 mean = shader_.by_cells(look, x, y_, nullptr, side, false);
    keep_cell({mean.r, mean.g, mean.b, mean.a}, threshold(x), x);
  }
}

void RowPainter::cell(int column, int before) {
  if (column < x0_ || column >= x1_) return;
  ++stats_->edge_pixels;
  const auto seen = [](const Open& o) { return std::abs(o.here.area) >= kUnseenArea; };
  const auto is_open = [&](const Open& o) { return seen(o) && looks_->open(o.look); };
  if (std::any_of(open_.begin(), open_.end(), is_open)) return refused_.push_back(column);
  const std::size_t parts_before = parts_.size();
  for (const Open& o : open_)
    if (seen(o))
      parts_.push_back({o.look, kept_, o.left, before, int(taken_.size()), o.here, {}, 0.0f});
  keep_cell(sum_, parts_.size() > parts_before ? threshold(column) : 0.5f, column);
}

/// Keeps a colour to be written together with the row's others.
void RowPainter::keep_cell(const Rgba& mix, float carry, int column) {
  const auto k = std::size_t(kept_++);
  cells_.r[k] = mix.r, cells_.g[k] = mix.g, cells_.b[k] = mix.b, cells_.a[k] = mix.a;
  columns_[k] = column, carries_[k] = carry;
}

/// Pixels whose light may be off by more than is permitted, in all their parts.
void RowPainter::refuse_doubtful() {
  std::vector<LitPaint::Doubt>& doubts = shader_.doubts();
  if (doubts.empty()) return;
  std::sort(doubts.begin(), doubts.end(), [](const LitPaint::Doubt& a, const LitPaint::Doubt& b) {
    return std::tie(a.column, a.off) < std::tie(b.column, b.off);
  });
  for (std::size_t k = 0; k < doubts.size();) {
    const int column = doubts[k].column;
    float off = 0.0f;
    for (; k < doubts.size() && doubts[k].column == column; ++k) off += doubts[k].off;
    if (off >= 1.0f) refused_.push_back(column);
  }
  doubts.clear();
  std::sort(refused_.begin(), refused_.end());
  refused_.erase(std::unique(refused_.begin(), refused_.end()), refused_.end());
}

void RowPainter::put_cells() {
  const auto count = std::size_t(std::exchange(kept_, 0));
  format_->put(cells_.planes(), carries_.data(), int(count), made_.data());
  scatter_pixels(made_.data(), {columns_.data(), count}, bytes_, at(0));
}

}  // namespace mien
