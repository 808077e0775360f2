#include "render/shade/looks.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cstring>
#include "lib/base/bit_cast.h"

namespace mien {
namespace {

using Kind = LookStep::Kind;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9e3779b97f4a7c15ull;
  return hash ^ (hash >> 29);
}

std::uint64_t hash_of(const LookStep& step) {
  std::uint64_t hash = mixed(std::uint64_t(step.kind) + 1, std::uint64_t(step.varied + 1));
  hash = mixed(hash, std::uint64_t(step.segment) << 32 | std::uint32_t(step.zone));
  hash = mixed(hash, std::uint64_t(step.mode));
  for (int i = 0; i < 4; ++i) hash = mixed(hash, mien::bit_cast<std::uint64_t>(step.mix[i] + 0.0));
  return hash;
}

bool same(const LookStep& a, const LookStep& b) {
  return a.kind == b.kind && a.varied == b.varied && a.segment == b.segment && a.zone == b.zone &&
         a.mode == b.mode && a.mix == b.mix;
}

}  // namespace

void Looks::begin(const PaintTable& paints) {
  paints_ = &paints;
  words_ = int(paints.layers.size() + 63) / 64;
  looks_.clear(), steps_.clear();
  table_.assign(std::max<std::size_t>(table_.size(), 256), -1);
  opaque_.assign(std::size_t(words_), 0);
  tests_.clear();
  starts_.assign(paints.programs.steps().size() + 1, {});
  for (std::size_t i = 0; i < paints.layers.size(); ++i) {
    const PaintedLayer& layer = paints.layers[i];
    const double opacity = layer.varied < 0
                               ? layer.mix.a
                               : paints.varied[std::size_t(layer.varied)].paint.least_opacity();
    if (opacity >= 1.0 && layer.group < 0) opaque_[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  note_outlines();
  make_segments();
}

void Looks::note_test(const AreaProgram& program) {
  auto& start = starts_[std::size_t(program.first)];
  if (!start && program.count > 0) start = tests_.add(paints_->programs.steps(program));
}

void Looks::note_outlines() {
  const PaintTable& paints = *paints_;
  const std::size_t outlines = paints.programs.outlines().size();
  kink_.assign(outlines, 0);
  reading_.clear();
  const auto note = [&](const AreaProgram& program, int layer, bool kink) {
    note_test(program);
    for (const AreaStep& step : paints.programs.steps(program)) {
      if (step.kind != AreaStep::Kind::outline) continue;
      reading_.emplace_back(step.outline, layer);
      if (kink) kink_[std::size_t(step.outline)] = 1;
    }
  };
  for (std::size_t i = 0; i < paints.layers.size(); ++i) {
    const PaintedLayer& layer = paints.layers[i];
    note(layer.program, int(i), false);
    if (layer.varied < 0) continue;
    const VariedPaint& varied = paints.varied[std::size_t(layer.varied)];
    for (const PaintKink& kink : varied.kinks) note(kink.program, int(i), true);
    for (const AreaProgram& level : varied.levels) note(level, int(i), true);
    for (const AreaProgram& dome : varied.domes) note(dome, int(i), true);
  }
  std::sort(reading_.begin(), reading_.end());
  reading_.erase(std::unique(reading_.begin(), reading_.end()), reading_.end());
  first_reader_.assign(outlines + 1, 0);
  readers_.clear();
  for (const auto& [outline, layer] : reading_) {
    ++first_reader_[std::size_t(outline) + 1];
    readers_.push_back(layer);
  }
  for (std::size_t i = 0; i < outlines; ++i) first_reader_[i + 1] += first_reader_[i];
}

/// A ramp is linear between kinks: two of its places say how. One that has an integral is so beyond its ends. Along a
/// distance each stretch has an integral of its own.
void Looks::make_segments() {
  first_segment_.clear(), segments_.clear();
  for (const VariedPaint& varied : paints_->varied) {
    first_segment_.push_back(int(segments_.size()));
    if (!varied.paint.ramp) continue;
    for (std::size_t k = 0; k <= varied.kinks.size(); ++k) {
      RampSegment s;
      s.from = k > 0 ? varied.kinks[k - 1].at : varied.lowest;
      s.to = k < varied.kinks.size() ? varied.kinks[k].at : varied.highest;
      const double length = s.to - s.from;
      if (length > 0.0) {
        const double t = s.from + 0.25 * length, u = s.from + 0.75 * length;
        const Mix a = varied.paint.ramp->color(t), b = varied.paint.ramp->color(u);
        s.slope = a == b ? Mix{0.0} : (b - a) / (u - t);
        s.at = a == b ? a : a - t * s.slope;
      } else {
        s.at = varied.paint.ramp->color(s.from);
      }
      if (!varied.by_integral && varied.paint.field.kind == PaintField::Kind::distance) {
        if (along_.size() <= segments_.size()) along_.resize(segments_.size() + 1);
        along_[segments_.size()].make(s.from, s.to, s.at + s.from * s.slope, s.at + s.to * s.slope);
      }
      segments_.push_back(s);
    }
  }
}

bool Looks::holds(const AreaProgram& program, const std::uint64_t* inside) const {
  return program.count == 0 || tests_.holds(*starts_[std::size_t(program.first)], inside);
}

/// How many kinks lie before the region.
int Looks::segment_of(int varied, const std::uint64_t* inside) {
  const std::vector<PaintKink>& kinks = paints_->varied[std::size_t(varied)].kinks;
  int passed = 0;
  for (const PaintKink& kink : kinks) passed += holds(kink.program, inside) == kink.after;
  return passed;
}

int Looks::first_look(std::uint64_t* state) {
  nothing_.assign(paints_->programs.outlines().size() / 64 + 1, 0);
  std::fill(state, state + words_, 0);
  for (std::size_t i = 0; i < paints_->layers.size(); ++i)
    if (holds(paints_->layers[i].program, nothing_.data()))
      state[i / 64] |= std::uint64_t{1} << (i % 64);
  return compose(nothing_.data(), state);
}

int Looks::look(const std::uint64_t* inside, int outline, const std::uint64_t* before,
                int look_before, std::uint64_t* state) {
  const int first = first_reader_[std::size_t(outline)],
            end = first_reader_[std::size_t(outline) + 1];
  for (int i = first; i < end; ++i) {
    const int layer = readers_[std::size_t(i)];
    const std::uint64_t bit = std::uint64_t{1} << (layer & 63);
    if (holds(paints_->layers[std::size_t(layer)].program, inside))
      state[layer >> 6] |= bit;
    else
      state[layer >> 6] &= ~bit;
  }
  if (!kink_[std::size_t(outline)] && std::equal(state, state + words_, before)) return look_before;
  return compose(inside, state);
}

int Looks::compose(const std::uint64_t* inside, const std::uint64_t* covered) {
  int bottom = -1;  // the topmost opaque layer
  for (int w = words_ - 1; w >= 0 && bottom < 0; --w)
    if (const std::uint64_t both = covered[w] & opaque_[std::size_t(w)])
      bottom = 64 * w + 63 - std::countl_zero(both);
  const std::size_t first_step = steps_.size();
  levels_.assign(1, {});
  levels_[0].mix = paints_->background;
  open_.clear();
  for (int w = std::max(bottom, 0) >> 6; w < words_; ++w) {
    std::uint64_t bits = covered[w];
    if (bottom >> 6 == w) bits &= ~std::uint64_t{0} << (bottom & 63);
    for (; bits; bits &= bits - 1) {
      const int i = 64 * w + std::countr_zero(bits);
      const PaintedLayer& layer = paints_->layers[std::size_t(i)];
      if (layer.group != (open_.empty() ? -1 : open_.back())) enter_group(layer.group);
      if (i == bottom) levels_[0].mix = Mix{0.0};
      if (layer.varied < 0)
        lay_over(layer.mix);
      else
        lay_paint(layer.varied, inside);
    }
  }
  leave_groups(0);
  write_pending(levels_[0], true);
  return known_or_new(first_step);
}

/// Closes and opens groups until `group` is the innermost open one.
void Looks::enter_group(int group) {
  chain_.clear();
  for (int g = group; g >= 0; g = paints_->groups[std::size_t(g)].parent) chain_.push_back(g);
  std::reverse(chain_.begin(), chain_.end());
  std::size_t same_so_far = 0;
  while (same_so_far < chain_.size() && same_so_far < open_.size() &&
         chain_[same_so_far] == open_[same_so_far])
    ++same_so_far;
  leave_groups(same_so_far);
  for (std::size_t i = same_so_far; i < chain_.size(); ++i) {
    open_.push_back(chain_[i]);
    levels_.emplace_back();
  }
}

void Looks::leave_groups(std::size_t depth) {
  while (open_.size() > depth) {
    const auto& [parent, opacity, mode] = paints_->groups[std::size_t(open_.back())];
    open_.pop_back();
    Level level = levels_.back();
    if (level.varies) write_pending(level, false);
    levels_.pop_back();
    if (level.varies)
      steps_.push_back({.kind = Kind::close, .mode = mode, .mix = {0.0, 0.0, 0.0, opacity}});
    else
      lay_group(opacity * level.mix, mode);
  }
}

/// Constant colours laid over each other are one colour, wherever it is laid; a mode asks for what is below.
void Looks::lay_group(const Mix& mix, MixMode mode) {
  Level& below = levels_.back();
  if (mode == MixMode::normal) return lay_over(mix);
  if (!below.varies) {
    below.mix = blended(mode, mix, below.mix);
    return;
  }
  write_pending(below, false);
  if (mix != Mix{0.0}) steps_.push_back({.kind = Kind::over, .mode = mode, .mix = mix});
}

void Looks::lay_over(const Mix& mix) {
  levels_.back().mix = over(mix, levels_.back().mix);
}

/// Writes what is constant so far as a step: the level's ground, or something over what is there.
void Looks::write_pending(Level& level, bool ground) {
  if (!level.varies) {
    if (ground) steps_.push_back({.kind = Kind::open, .mix = level.mix});
  } else if (level.mix != Mix{0.0}) {
    steps_.push_back({.kind = Kind::over, .mix = level.mix});
  }
  level.mix = Mix{0.0};
}

/// In which zone of its profile a paint lies, and whether its surface slopes there.
Looks::Lie Looks::lie_of(const VariedPaint& paint, const std::uint64_t* inside) {
  if (paint.lit < 0) return {};
  const auto holds = [&](const AreaProgram& program) { return this->holds(program, inside); };
  Lie lie;
  for (const AreaProgram& level : paint.levels) lie.zone += holds(level);
  lie.slopes = !paints_->lit[std::size_t(paint.lit)].flat(lie.zone) ||
               std::any_of(paint.domes.begin(), paint.domes.end(), holds);
  return lie;
}

void Looks::lay_paint(int varied, const std::uint64_t* inside) {
  const VariedPaint& paint = paints_->varied[std::size_t(varied)];
  const Lie lie = lie_of(paint, inside);
  LookStep step{.kind = Kind::paint, .varied = varied};
  if (!paint.paint.ramp) {
    if (!lie.slopes) return lay_over(paint.paint.color);
    step.zone = lie.zone;
  } else {
    step.segment = segment_of(varied, inside);
    const RampSegment& s = segment(step);
    if (paint.by_integral && !paint.paint.ramp->beyond(s.from, s.to))
      step.segment = -1;
    else if (s.slope == Mix{0.0} && (!lie.slopes || s.at.a == 0.0))
      return lay_over(s.at);
    if (lie.slopes) step.zone = lie.zone;
  }
  for (Level& level : levels_) {  // the grounds of the levels below come first
    const bool opens = !level.varies;
    write_pending(level, opens);
    level.varies = true;
  }
  steps_.push_back(step);
}

int Looks::known_or_new(std::size_t first_step) {
  std::uint64_t hash = steps_.size() - first_step;
  for (std::size_t i = first_step; i < steps_.size(); ++i) hash = mixed(hash, hash_of(steps_[i]));
  if (2 * looks_.size() > table_.size()) {
    table_.assign(2 * table_.size(), -1);
    for (std::size_t k = 0; k < looks_.size(); ++k) {
      std::size_t i = looks_[k].hash & (table_.size() - 1);
      while (table_[i] >= 0) i = (i + 1) & (table_.size() - 1);
      table_[i] = int(k);
    }
  }
  std::size_t i = hash & (table_.size() - 1);
  for (; table_[i] >= 0; i = (i + 1) & (table_.size() - 1)) {
    const Look& known = looks_[std::size_t(table_[i])];
    if (known.hash == hash &&
        std::equal(steps_.begin() + known.first, steps_.begin() + known.first + known.count,
                   steps_.begin() + std::ptrdiff_t(first_step), steps_.end(), same)) {
      steps_.resize(first_step);
      return table_[i];
    }
  }
  const bool constant = steps_.size() == first_step + 1;
  table_[i] = int(looks_.size());
  const auto steps = std::span(steps_).subspan(first_step);
  looks_.push_back({.mix = constant ? steps_[first_step].mix : Mix{0.0},
                    .neglected = neglected_by(steps),
                    .open = open_by(steps),
                    .products = products_of(steps),
                    .first = int(first_step),
                    .count = int(steps.size()),
                    .hash = hash});
  return table_[i];
}

}  // namespace mien
