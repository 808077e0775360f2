#include "render/rows/drawing.h"
#include "lib/base/monotonic_seconds.h"
#include "lib/base/watch.h"
#include "sdf/arrange/foreseen.h"
#include "sdf/scene/legible.h"
#include "sdf/scene/same_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace mien {
namespace {

/// How far an outline may be off [px]: a third of a level of 255 at full contrast, or of 32 levels of 65535. Dark
/// pixels blended in linear light are encoded up to 12.92 times as steeply, so there it is about a twelfth of that.
double tolerance_of(Depth depth, Blend blend) {
  const bool fine = depth != Depth::u8, linear = blend == Blend::linear;
  return fine ? (linear ? 1.0 / 48'000 : 1.0 / 4000) : (linear ? 1.0 / 9000 : 1.0 / 800);
}

}  // namespace

/// A crowd's window is drawn as a picture of its own.
struct StripScratch::Window {
  CrowdScratch crowd;
  Drawing drawing;
  StripScratch strip;
};

StripScratch::StripScratch() = default;
StripScratch::~StripScratch() = default;
StripScratch::StripScratch(StripScratch&&) noexcept = default;

bool Drawing::is_of(const View& view, Depth depth) const {
  const auto same_color = [](const std::optional<Color>& a, const std::optional<Color>& b) {
    return a.has_value() == b.has_value() &&
           (!a || (a->r == b->r && a->g == b->g && a->b == b->b && a->a == b->a));
  };
  return made_ && format_.depth() == depth && view.width == view_.width &&
         view.height == view_.height && view.fit == view_.fit && view.blend == view_.blend &&
         view.dither == view_.dither && view.light == view_.light &&
         same_color(view.background, view_.background);
}

void Drawing::make(const Scene& scene, const View& view, Depth depth, const Threads& threads) {
  prepare(scene, view, depth, threads);
  arrange_all(threads);
}

void Drawing::make_whole(const Scene& scene, const View& view, Depth depth,
                         const Threads& threads) {
  prepare(scene, view, depth, false, threads);
  arrange_all(threads);
}

void Drawing::prepare(const Scene& whole, const View& view, Depth depth, bool crowded,
                      const Threads& threads) {
  const double scale = pixel_from_face(whole.canvas(), view).scale();
  const Scene scene = legible_scene(whole, view.legible / scale);
  const bool like_before = crowded == crowded_ && is_of(view, depth);
  if (like_before && same_scene(scene, now().scene)) return changed_.begin(bands(), crowded);
  made_ = false, crowded_ = crowded;
  width_ = view.width, height_ = view.height, dither_ = view.dither;
  view_ = view, view_.legible = 0;  // the windows of a crowd are of this scene
  format_ = PixelFormat(depth, view.blend);
  now_ = 1 - now_;
  now().scene = scene;
  changed_.begin(bands(), true);
  forget_order();
  if (crowded_)
    crowd_.make(scene, view_, depth);
  else
    prepare_outlines(like_before, threads);
}

void Drawing::prepare_outlines(bool like_before, const Threads& threads) {
  const PreparedScene& before = prepared_[1 - now_];
  like_before = like_before && common_.find(before.scene, now().scene);
  const Box2 window{{0.0, 0.0}, {width_, height_}};
  tolerance_ = tolerance_of(format_.depth(), view_.blend);
  const OutlineFrame frame{grid_from_face(scene().canvas(), view_), window, tolerance_};
  foresee(scene(), frame);
  now().paints.make(scene(), view_, format_.depth());
  if (like_before)
    paints().programs.find_same(before.paints.programs, same_as_);
  else
    same_as_.assign(paints().programs.outlines().size(), -1);
  make_outlines(frame, threads);
  if (!like_before) return;
  changed_.begin(bands(), false);
  changed_.find(before, now(), common_, same_as_);
}

/// It counts as made when it is done: what ended early is made anew.
void Drawing::arrange(const std::function<bool(int)>& wanted, const Threads& threads) {
  made_ = false;
  const auto open = [&](int band) { return part_of_[std::size_t(band)] < 0 && wanted(band); };
  const int before = part_count_;
  for (int band = 0; !crowded_ && band < bands(); ++band) {
    const int first = band;
    while (band < bands() && open(band)) ++band;
    if (band > first) part_bands(first, band);
  }
  const auto job = [&](int i) { arrange(parts_[std::size_t(before + i)]); };
  if (part_count_ - before == 1)
    job(0);
  else
    parallel_for(part_count_ - before, threads, std::ref(job));
  made_ = true;
}

/// Into as many parts as are worth their beginnings, whatever the threads: limits and figures do not depend on those.
void Drawing::part_bands(int first, int end) {
  const int rows = std::min(end * kRows, height_) - first * kRows,
            parts = std::max(rows / rows_in_part_, 1), most = (end - first + parts - 1) / parts;
  for (; first < end; first += most, ++part_count_) {
    if (parts_.size() == std::size_t(part_count_)) parts_.emplace_back();
    PicturePart& part = parts_[std::size_t(part_count_)];
    const int last = std::min(first + most, end);
    part.first_band = first, part.top = first * kRows;
    part.bottom = std::min(last * kRows, height_);
    std::fill(part_of_.begin() + first, part_of_.begin() + last, part_count_);
  }
}

void Drawing::arrange(PicturePart& part) const {
  part.looks.begin(paints());
  part.regions.begin(int(paints().programs.outlines().size()), part.looks);
  part.sweep.run_in_bands(outlines(), part.top, part.bottom, part.regions, order());
  part.palette.make(part.looks, format_, part.regions.look(0));
  part.jumps.clear();
  for (const Fragment& f : part.sweep.fragments())
    part.jumps.push_back(part.palette.entries[std::size_t(f.right)].color -
                         part.palette.entries[std::size_t(f.left)].color);
}

/// Those of large pictures in groups, on several threads: the same outlines.
void Drawing::make_outlines(const OutlineFrame& frame, const Threads& threads) {
  constexpr int kGroups = 8;
  const auto sources = paints().programs.outlines();
  const int groups = threads.count == 1 || height_ < 2 * rows_in_part_ ? 1 : kGroups;
  if (groups_.size() < std::size_t(groups)) groups_.resize(std::size_t(groups));
  const auto job = [&](int i) {
    OutlineGroup& group = groups_[std::size_t(i)];
    Outlines& to = i == 0 ? now().outlines : group.made;
    group.maker.begin(frame, to);
    for (std::size_t k = sources.size() * i / groups, end = sources.size() * (i + 1) / groups;
         k < end; ++k) {
      if (const int same = same_as_[k]; same >= 0)
        to.add(prepared_[1 - now_].outlines, same, same + 1);
      else
        group.maker.add(paints().programs, sources[k]);
    }
  };
  if (groups == 1)
    job(0);
  else
    parallel_for(groups, threads, std::ref(job));
  for (int i = 1; i < groups; ++i) {
    const Outlines& made = groups_[std::size_t(i)].made;
    now().outlines.add(made, 0, int(made.rules.size()));
  }
  now().outlines.finish();
}

/// Adds up what the strip's fragments change in the rows [first, end), into sums that begin at `top`.
void Drawing::sum_fragments(int strip, int first, int end, RowSums& sums) const {
  sums.begin(kRows, width_);
  const PicturePart& part = part_of(strip);
  const auto varied = [&](int look) {
    return part.palette.entries[std::size_t(look)].varies ? look : -1;
  };
  for (const Fragment& f : part.of_band(strip)) {
    const double from = std::max(f.top, double(first)), to = std::min(f.bottom, double(end));
    if (from < to)
      sums.add(part.sweep.piece(f.piece), from, to, strip * kRows, part.jump(f), varied(f.left),
               varied(f.right), f.right);
  }
}

void Drawing::draw_strip(int strip, const RowTarget& target, StripScratch& scratch,
                         RenderStats& stats) const {
  if (strip < 0 || strip >= (height_ + kRows - 1) / kRows) return;
  const int top = strip * kRows, bottom = std::min(top + kRows, height_);
  const PixelRect& rect = target.rect;
  const int first = std::max(top, rect.y), end = std::min(bottom, rect.y + rect.height);
  if (first >= end) return;
  if (crowded_) return draw_windows(top, bottom, target, scratch, stats, nullptr);
  const long long cells_before = scratch.sums.cells();
  const double begin = monotonic_seconds();
  sum_fragments(strip, first, end, scratch.sums);
  stats.roots += scratch.sums.cells() - cells_before;
  stats.root_seconds += monotonic_seconds() - begin;
  // A picture that fits the caches is worth keeping there.
  constexpr std::size_t kCaches = std::size_t{8} << 20;
  const bool large = target.stride * std::size_t(rect.height) > kCaches;
  const PicturePart& part = part_of(strip);
  scratch.painter.begin(part.palette, part.looks, format_, dither_,
                        large ? Stores::streamed : Stores::ordinary);
  scratch.resolver.reset();
  scratch.odd_rows = 0;
  for (int y = first; y < end; ++y) {
    scratch.painter.paint(y, scratch.sums, y - top, rect.x, rect.x + rect.width,
                          target.data + target.stride * std::size_t(y - rect.y), stats);
    for (const int x : scratch.painter.refused()) resolve(x, y, target, scratch, stats);
    if (!scratch.painter.refused().empty()) scratch.odd_rows |= std::uint32_t{1} << (y - top);
  }
  scratch.painter.tell(stats);
  resolve_doubts(part.sweep.doubts(), first, end, target, scratch, stats);
  if (large) finish_streams();
}

void Drawing::draw_windows(int top, int bottom, const RowTarget& target, StripScratch& scratch,
                           RenderStats& stats, const ErrorNotes* notes) const {
  if (!scratch.window) scratch.window = std::make_unique<StripScratch::Window>();
  StripScratch::Window& own = *scratch.window;
  const PixelRect& all = target.rect;
  crowd_.each_window(top, bottom, all, own.crowd, [&](const CrowdWindow& window) {
    const PixelRect& w = window.rect;
    const int x = std::max(w.x, all.x), y = std::max(w.y, all.y);
    const PixelRect seen{x - w.x, y - w.y, std::min(w.x + w.width, all.x + all.width) - x,
                         std::min(w.y + w.height, all.y + all.height) - y};
    const std::size_t before = std::size_t(x - all.x), above = std::size_t(y - all.y);
    const RowTarget part{target.data + target.stride * above + format_.bytes() * before,
                         target.stride, seen};
    own.drawing.make_whole(window.scene, window.view, format_.depth());
    if (!notes) {
      own.drawing.draw_strip(0, part, own.strip, stats);
      return own.drawing.tell(stats);
    }
    std::vector<float> levels(std::size_t(seen.width) * std::size_t(seen.height));
    std::vector<std::uint8_t> estimated(levels.size());
    own.drawing.draw_strip_with_errors(0, part, own.strip, {seen, levels.data(), estimated.data()});
    for (float& level : levels) level += float(255.0 * window.left_out);
    for (std::size_t row = 0; row < std::size_t(seen.height); ++row) {
      const std::size_t from = row * std::size_t(seen.width), to = notes->at(x, y + int(row));
      std::copy_n(&levels[from], seen.width, notes->levels + to);
      std::copy_n(&estimated[from], seen.width, notes->estimated + to);
    }
  });
}

/// One pixel by distances.
Resolved Drawing::resolve(int x, int y, const RowTarget& target, StripScratch& scratch,
                          RenderStats& stats) const {
  // A quarter of a pixel's permitted error. Dark pixels in linear light are encoded 12.92 times as steeply, but are
  // divided no finer: the errors of their squares cancel by chance.
  const double tolerance = format_.depth() == Depth::u8 ? 0x1p-11 : 0x1p-14;
  if (!scratch.resolver) scratch.resolver.emplace(scene(), view_, paints(), tolerance);
  const Resolved found = scratch.resolver->pixel(x, y);
  std::byte* const to = target.data + target.stride * std::size_t(y - target.rect.y) +
                        format_.bytes() * std::size_t(x - target.rect.x);
  if (dither_ && found.varies)
    store_dithered(found.mix, format_.blend(), format_.depth(), x, y, to);
  else
    store(found.mix, format_.blend(), format_.depth(), to);
  if (scratch.errors) {
    // Encoding is steepest at the darkest colour it may be.
    const double steep = format_.steepness(rgba_from_mix(found.mix - Mix(found.bound)));
    scratch.errors->level(x, y) = float(255.0 * steep * found.bound);
  }
  ++stats.resolved_pixels;
  return found;
}

/// Pixels between outlines whose order is not proven.
void Drawing::resolve_doubts(std::span<const Doubt> doubts, int first, int end,
                             const RowTarget& target, StripScratch& scratch,
                             RenderStats& stats) const {
  const PixelRect& rect = target.rect;
  scratch.resolved.clear();  // doubts lie over each other, and a pixel is resolved once
  for (const Doubt& doubt : doubts) {
    worked(4);
    const int top = std::max(first, int(std::floor(doubt.top))),
              bottom = std::min(end, int(std::ceil(doubt.bottom)));
    const double least = rect.x, most = rect.x + rect.width;
    const int left = int(std::clamp(std::floor(doubt.left - order()), least, most)),
              right = int(std::clamp(std::ceil(doubt.right + order()), least, most));
    if (top >= bottom || left >= right) continue;
    const int row = top - top / kRows * kRows;
    scratch.odd_rows |= ((std::uint32_t{1} << (bottom - top)) - 1) << row;
    scratch.resolved.resize(std::size_t(rect.width) * std::size_t(end - first), 0);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) {
        char& done = scratch.resolved[std::size_t(y - first) * std::size_t(rect.width) +
                                      std::size_t(x - rect.x)];
        if (!std::exchange(done, 1)) resolve(x, y, target, scratch, stats);
      }
  }
}

void Drawing::tell(RenderStats& stats) const {
  if (crowded_) return;  // its windows have reported
  RenderStats own;
  own.pieces = (long long)outlines().pieces.size();
  for (const PicturePart& part : parts()) {
    own.crossings += part.sweep.stats().crossings;
    own.regions += part.sweep.stats().regions;
    own.doubts += (long long)part.sweep.doubts().size();
  }
  stats.add(own);
}

/// The bound adds up: for every piece, its jump times its tolerance along its length and order() along its height;
/// what means by centroids neglect; and the own bound of what was resolved.
void Drawing::draw_strip_with_errors(int strip, const RowTarget& target, StripScratch& scratch,
                                     const ErrorNotes& notes) const {
  const int top = strip * kRows, bottom = std::min(top + kRows, height_);
  const PixelRect& rect = target.rect;
  const int first = std::max(top, rect.y), end = std::min(bottom, rect.y + rect.height);
  if (first >= end) return;
  RenderStats stats;
  if (crowded_) return draw_windows(top, bottom, target, scratch, stats, &notes);
  scratch.painter.note_errors(&notes);
  scratch.errors = &notes;
  draw_strip(strip, target, scratch, stats);
  scratch.errors = nullptr;
  scratch.painter.note_errors(nullptr);
  const PicturePart& part = part_of(strip);
  const auto entry = [&](int look) -> const Palette::Entry& {
    return part.palette.entries[std::size_t(look)];
  };
  for (const Fragment& f : part.of_band(strip)) {
    const Rgba& j = part.jump(f);
    const double from = std::max(f.top, double(first)), to = std::min(f.bottom, double(end));
    if (!(from < to)) continue;
    const bool varies = entry(f.left).varies || entry(f.right).varies;
    const double jump =
        varies ? 1.0
               : double(std::max({std::abs(j.r), std::abs(j.g), std::abs(j.b), std::abs(j.a)}));
    // A mixed colour is encoded no more steeply than the darker one of the two.
    const double steep =
        std::max(format_.steepness(entry(f.left).color), format_.steepness(entry(f.right).color));
    cells_of(part.sweep.piece(f.piece), from, to, width_, [&](const CellStretch& c) {
      if (c.column < rect.x || c.column >= rect.x + rect.width) return;
      const double length = std::hypot(c.xq - c.xp, c.yq - c.yp);
      notes.level(c.column, c.row) +=
          float(255.0 * steep * jump * (tolerance_ * length + order() * (c.yq - c.yp)));
    });
  }
}

}  // namespace mien
