#include "tools/mien/batch/joined_pieces.h"
#include "render/image/file/written_file.h"
#include "render/image/file_type.h"
#include "render/image/load_encoder.h"
#include "tools/mien/batch/joined_regions.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/data/shown_stimulus.h"
#include "tools/mien/data/stimulus_plan.h"
#include "tools/mien/film/film.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

namespace mien::command {
namespace {

namespace fs = std::filesystem;

/// A frame's file, whole.
Expected<Image> picture_in(const fs::path& path) {
  const auto reader = load_reader(path);
  if (!reader) return reader.error();
  PictureReader& in = **reader;
  Image image{.width = in.width(), .height = in.height(), .depth = in.depth()};
  image.opaque = in.opaque();
  image.bytes.resize(image.stride() * std::size_t(image.height));
  if (auto done = in.next(image.height, image.bytes.data(), image.stride(), interrupted); !done)
    return Error{path.string(), done.error().what};
  return image;
}

int join_film(const OpenedBatch& batch, const BatchItem& item, long first, const fs::path& to) {
  const Variable& frames = item.job->each.back();
  if (!film_type(to.string()) && lower_extension(to.string()) != ".png")
    return complain("frames are joined to a film: .mp4 .webm .webp .apng .gif", kUsedWrongly);
  const CommandLine line = command_of(item, to.string(), true);
  const auto* const given = std::get_if<AnimateArguments>(&line);
  if (!given) return complain("makes no film", kUsedWrongly);
  AnimateArguments arguments = *given;
  arguments.frames = fmt::format("{}-{}", frames.first, frames.first + frames.count - 1);
  return animate_command(arguments, [&](long frame) -> Expected<Image> {
    const BatchItem piece = item_of(batch.plan, first + frame - frames.first);
    return picture_in(batch.folder / piece.name);
  });
}

int join_experiment(const BatchItem& item, long first, const std::vector<std::string>& hashes,
                    const fs::path& to) {
  const std::string& file = item.job->each.back().file;
  std::vector<Error> warnings;  // mien stimuli tells them
  const auto plan = read_stimulus_plan(file, &warnings);
  if (!plan) return complain(plan.error(), kFailed);
  const auto what = stimuli(*plan, &warnings);
  if (!what) return complain(what.error(), kFailed);
  std::vector<Expected<ShownStimulus>> shown(what->size(), Error{});
  watched_for("manifest", int(what->size()), {}, [&](int i) {
    shown[std::size_t(i)] =
        shown_before((*what)[std::size_t(i)], hashes[std::size_t(first) + std::size_t(i)]);
  });
  StimulusManifest manifest{.size = plan->size, .shown = {}};
  for (const auto& one : shown) {
    if (!one) return complain(one.error(), kFailed);
    manifest.shown.push_back(*one);
  }
  const std::string text = manifest_text(manifest);
  const auto done =
      write_file(to.string(), [&](const PutBytes& put) { return put(text.data(), text.size()); });
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace

int join_pieces(const OpenedBatch& batch, long first, const std::vector<std::string>& hashes) {
  const BatchItem item = item_of(batch.plan, first);
  const fs::path to = batch.folder / filled(*item.job->join, item);
  std::error_code failed;
  fs::create_directories(to.parent_path(), failed);
  if (failed)
    return complain({to.parent_path().string(), "cannot be made: " + failed.message()}, kFailed);
  switch (item.job->each.back().kind) {
    case Variable::Kind::regions:
      return join_regions(batch, item, first, to);
    case Variable::Kind::frames:
      return join_film(batch, item, first, to);
    default:
      return join_experiment(item, first, hashes, to);
  }
}

}  // namespace mien::command
