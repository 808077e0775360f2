#include "tools/mien/batch/joined_regions.h"
#include <mien/parallel.h>
#include "render/image/file_type.h"
#include "render/image/load_encoder.h"
#include "tools/mien/batch/whole_picture.h"
#include "tools/mien/output/recipe.h"
#include "tools/mien/output/write_strips.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/progress_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace mien::command {
namespace {

constexpr int kStripRows = 256;  // as many as TIFF's tiles have

/// Regions of one picture, read from its top down; those of one row of regions are open at a time.
class RegionRows {
 public:
  RegionRows(const OpenedBatch& batch, const Variable& regions, long first)
      : batch_(batch), regions_(regions), first_(first) {}

  /// Whether the first region's pixels are opaque; and of which depth.
  Expected<PictureFrame> frame(int width, int height) {
    if (auto opened = open(0); !opened) return opened.error();
    return PictureFrame{width, height, readers_[0]->depth(), readers_[0]->opaque()};
  }

  Expected<Image> next(const PictureFrame& frame, int rows) {
    Image strip{.width = frame.width, .height = rows, .depth = frame.depth};
    strip.opaque = frame.opaque;
    strip.bytes.resize(strip.stride() * std::size_t(rows));
    for (int done = 0; done < rows;) {
      if (y_ == end_of(row_))
        if (auto opened = open(row_ + 1); !opened) return opened.error();
      const int now = std::min(rows - done, end_of(row_) - y_);
      if (auto got = read(strip, done, now); !got) return got.error();
      done += now, y_ += now;
    }
    return strip;
  }

 private:
  const PixelRect& rect(int row, int column) const {
    return regions_.rects[std::size_t(row * regions_.columns + column)];
  }
  int end_of(int row) const { return rect(row, 0).y + rect(row, 0).height; }

  Expected<Done> open(int row) {
    row_ = row;
    readers_.clear();
    names_.clear();
    for (int column = 0; column < regions_.columns; ++column) {
      const auto item = item_of(batch_.plan, first_ + long(row) * regions_.columns + column);
      names_.push_back((batch_.folder / item.name).string());
      auto reader = load_reader(names_.back());
      if (!reader) return reader.error();
      const PixelRect& piece = rect(row, column);
      if ((*reader)->width() != piece.width || (*reader)->height() != piece.height)
        return Error{names_.back(),
                     fmt::format("has {} x {} pixels, not {} x {}", (*reader)->width(),
                                 (*reader)->height(), piece.width, piece.height)};
      readers_.push_back(*std::move(reader));
    }
    return Done{};
  }

  Expected<Done> read(Image& strip, int from, int rows) {
    std::vector<std::optional<Error>> wrong(readers_.size());
    const std::size_t pixel = 4 * bytes_per_channel(strip.depth);
    parallel_for(int(readers_.size()), {}, [&](int column) {
      PictureReader& reader = *readers_[std::size_t(column)];
      std::byte* const to = strip.bytes.data() + strip.stride() * std::size_t(from) +
                            pixel * std::size_t(rect(row_, column).x);
      if (reader.depth() != strip.depth || reader.opaque() != strip.opaque)
        wrong[std::size_t(column)] = Error{"", "has other channels than the first region"};
      else if (const auto done = reader.next(rows, to, strip.stride(), interrupted); !done)
        wrong[std::size_t(column)] = done.error();
    });
    for (std::size_t i = 0; i < wrong.size(); ++i)
      if (wrong[i]) return Error{"", names_[i] + " " + wrong[i]->what};
    return Done{};
  }

  const OpenedBatch& batch_;
  const Variable& regions_;
  const long first_;
  std::vector<std::unique_ptr<PictureReader>> readers_;  // of a row of regions
  std::vector<std::string> names_;
  int row_ = 0, y_ = 0;
};

/// Pieces lose nothing, and have the depth of the whole.
Expected<Done> check_types(const BatchItem& item, const RenderPlan& whole) {
  const auto type = file_type(item.name);
  if (!type) return type.error();
  const PictureWriter writer = format_of(*type).writer;
  if (writer != PictureWriter::png && writer != PictureWriter::tiff)
    return Error{"", "regions that are joined are .png or .tif"};
  if (whole.debug || whole.error_map) return Error{"", "debug pictures are not joined"};
  return Done{};
}

}  // namespace

int join_regions(const OpenedBatch& batch, const BatchItem& item, long first,
                 const std::filesystem::path& to) {
  const CommandLine line = command_of(item, to.string(), true);
  const auto* const arguments = std::get_if<RenderArguments>(&line);
  if (!arguments) return complain("makes no picture", kUsedWrongly);
  auto plan = whole_picture(*arguments);
  if (!plan) return complain(plan.error(), kUsedWrongly);
  if (const auto fits = check_types(item, *plan); !fits)
    return complain(fits.error(), kUsedWrongly);
  RegionRows rows(batch, item.job->each.back(), first);
  const auto frame = rows.frame(plan->view.width, plan->view.height);
  if (!frame) return complain(frame.error(), kFailed);
  if (frame->depth != plan->picture.depth.value_or(Depth::u8))
    return complain({to.string(), "its regions have another depth"}, kFailed);
  ProgressDisplay display;
  plan->picture.write.recipe = recipe(*arguments, plan->view);
  plan->picture.write.progress = display.watch("join");
  const std::uint64_t row = 4 * bytes_per_channel(frame->depth) * std::uint64_t(frame->width);
  const auto done = write_strips(
      // As it is read, and a row of tiles of each region beside it.
      {*frame, 3 * row, kStripRows,
       [&](int, int count, const Progress&) { return rows.next(*frame, count); }},
      to.string(), plan->picture);
  if (done) return kDone;
  return interrupted() ? complain("interrupted", kFailed) : complain(done.error(), kFailed);
}

}  // namespace mien::command
