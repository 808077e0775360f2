#pragma once
// A scene on its way to pixels: the outlines, arrangement and looks of a whole picture, made once; then its rows,
// in strips at absolute places.

#include <mien/parallel.h>
#include <mien/render_stats.h>
#include "render/reference/square_resolver.h"
#include "render/rows/changed_bands.h"
#include "render/rows/crowd.h"
#include "render/rows/row_painter.h"
#include "sdf/arrange/sweep.h"
#include "sdf/outline/outline_maker.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace mien {

/// Where drawn pixels go.
struct RowTarget {
  std::byte* data;
  std::size_t stride;  ///< [bytes]
  PixelRect rect;      ///< the part of the picture that `data` holds
};

/// Scratch of one thread that draws strips.
struct StripScratch {
  StripScratch();
  ~StripScratch();
  StripScratch(StripScratch&&) noexcept;

  RowSums sums;
  RowPainter painter;
  std::optional<SquareResolver> resolver;  ///< of the strip at hand, once it was needed
  std::vector<char> resolved;              ///< pixels of the strip's target that doubts have met
  /// A bit for each of the strip drawn last that has pixels resolved by distances: those may depend on what is not seen.
  std::uint32_t odd_rows = 0;
  const ErrorNotes* errors = nullptr;  ///< for the bounds of pixels resolved by distances
  struct Window;
  std::unique_ptr<Window> window;  ///< of a crowd
};

/// Scratch of threads, lent to whichever has strips to draw.
class StripScratches {
 public:
  std::unique_ptr<StripScratch> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<StripScratch>();
    auto scratch = std::move(idle_.back());
    idle_.pop_back();
    return scratch;
  }
  void give_back(std::unique_ptr<StripScratch> scratch) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<StripScratch>> idle_;
};

/// Some of a picture's bands, one below the other, arranged by themselves: parts are arranged in threads, and bands do
/// not depend on how they are parted.
struct PicturePart {
  int first_band = 0;
  int top = 0, bottom = 0;  ///< rows
  Looks looks;
  Regions regions;
  Sweep sweep;
  Palette palette;
  std::vector<Rgba> jumps;  ///< by fragment

  std::span<const Fragment> of_band(int band) const { return sweep.of_band(band - first_band); }
  const Rgba& jump(const Fragment& f) const {
    return jumps[std::size_t(&f - sweep.fragments().data())];
  }
};

class Drawing {
 public:
  /// Does nothing if all but the view's region is as it was, number for number, so the pieces of one picture share
  /// it. A crowd's outlines are left to its windows.
  void make(const Scene& scene, const View& view, Depth depth, const Threads& threads = {1});
  /// The same with all outlines at once, even a crowd's.
  void make_whole(const Scene& scene, const View& view, Depth depth, const Threads& threads = {1});

  /// The same in two steps: first all that does not depend on rows, where outlines that are as they were are copied …
  void prepare(const Scene& scene, const View& view, Depth depth, const Threads& threads) {
    prepare(scene, view, depth, Crowd::is_one(scene), threads);
  }
  /// … then the bands that are to be drawn.
  void arrange(const std::function<bool(int band)>& wanted, const Threads& threads);
  int bands() const { return (height_ + kRows - 1) / kRows; }
  /// Whether a band differs from that of the scene and view prepared before; true unless that is proven, and in crowds.
  bool changed(int band) const { return changed_[band]; }

  /// Strips of kRows rows, the sweep's bands. Draws those rows of a strip that show some of the target.
  static constexpr int kRows = Sweep::kBandRows;
  void draw_strip(int strip, const RowTarget& target, StripScratch& scratch,
                  RenderStats& stats) const;

  /// Bounds on the errors of a strip's pixels, noted for the target's rectangle; the pixels are drawn to `target` on
  /// the way.
  void draw_strip_with_errors(int strip, const RowTarget& target, StripScratch& scratch,
                              const ErrorNotes& notes) const;

  /// Reports the work that all strips share.
  void tell(RenderStats& stats) const;

  /// The scene made last.
  const Scene& scene() const { return now().scene; }
  const Outlines& outlines() const { return now().outlines; }
  const PaintTable& paints() const { return now().paints; }
  /// From the top down.
  std::span<const PicturePart> parts() const { return {parts_.data(), std::size_t(part_count_)}; }

 private:
  void sum_fragments(int strip, int first, int end, RowSums& sums) const;
  void draw_windows(int top, int bottom, const RowTarget& target, StripScratch& scratch,
                    RenderStats& stats, const ErrorNotes* notes) const;
  void resolve_doubts(std::span<const Doubt> doubts, int first, int end, const RowTarget& target,
                      StripScratch& scratch, RenderStats& stats) const;
  Resolved resolve(int x, int y, const RowTarget& target, StripScratch& scratch,
                   RenderStats& stats) const;
  bool is_of(const View& view, Depth depth) const;
  friend class DrawingProbe;  // plants faults, in tests
  void prepare(const Scene& scene, const View& view, Depth depth, bool crowded,
               const Threads& threads);
  void prepare_outlines(bool like_before, const Threads& threads);
  void arrange_all(const Threads& threads) {
    arrange([](int) { return true; }, threads);
  }
  void arrange(PicturePart& part) const;
  void part_bands(int first, int end);
  void forget_order() { part_count_ = 0, part_of_.assign(std::size_t(bands()), -1); }
  const PicturePart& part_of(int strip) const {
    return parts_[std::size_t(part_of_[std::size_t(strip)])];
  }
  PreparedScene& now() { return prepared_[now_]; }
  const PreparedScene& now() const { return prepared_[now_]; }
  void make_outlines(const OutlineFrame& frame, const Threads& threads);
  /// How far neighbours may be out of order [px].
  double order() const { return std::min(kOrder, 0.5 * tolerance_); }

  int width_ = 0, height_ = 0;
  bool dither_ = true;
  double tolerance_ = 0;  ///< of outlines [px]
  bool made_ = false, crowded_ = false;
  Crowd crowd_;
  View view_;
  PreparedScene prepared_[2];  ///< this one, and the one before
  int now_ = 0;
  InCommon common_;
  std::vector<int> same_as_;  ///< by outline: that of the scene before
  ChangedBands changed_;
  struct OutlineGroup {
    OutlineMaker maker;
    Outlines made;  ///< but for the first, which are the picture's
  };
  std::vector<OutlineGroup> groups_;
  PixelFormat format_{Depth::u8, Blend::srgb};
  std::vector<PicturePart> parts_;  ///< the first of them; others are kept for their memory
  int part_count_ = 0;
  std::vector<int> part_of_;  ///< by band; −1: it is not arranged
  int rows_in_part_ = 160;    ///< at least, so that its beginning costs little beside it
};

}  // namespace mien
