#include "tools/mien/pca/frames.h"
#include <mien/basis.h>
#include <mien/face_model.h>
#include <mien/pose.h>
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <algorithm>

namespace mien::command {
namespace {

constexpr std::uint64_t kMostClipBytes = std::uint64_t(2) << 30;

Expected<PcaFrames> of_file(const PcaArguments& arguments) {
  if (arguments.frames || arguments.fps || !arguments.settings.empty())
    return Error{arguments.input, "--frames, --fps and --set are for faces"};
  const auto file = FrameFile::open(arguments.input);
  if (!file) return file.error();
  PcaFrames frames;
  frames.vertices = file->vertices();
  frames.dimensions = file->dimensions();
  frames.single = file->header().type == NpyType::float32;
  frames.groups = equal_vertices(frames.vertices, frames.dimensions);
  frames.source = file->source();
  return frames;
}

/// The vectors of a posed face, row after row.
std::vector<double> posed_rows(const PcaFrames& frames, const Pose& pose) {
  constexpr std::size_t kAtOnce = 16;
  const auto count = std::size_t(frames.range.count());
  WatchedWork work("pose");
  std::vector<double> rows;
  rows.reserve(count * frames.vertices);
  for (std::size_t f = 0; f < count; f += kAtOnce) {
    const std::size_t some = std::min(kAtOnce, count - f);
    const auto next =
        frames_of_face(*frames.face, pose, frames.range.first + long(f), some, frames.fps);
    rows.insert(rows.end(), next.begin(), next.end());
    work.at(double(f + some) / double(count));
  }
  return rows;
}

PcaFramesOrCode of_face(const PcaArguments& arguments) {
  PcaFrames frames;
  const auto range = read_frames(arguments.frames.value_or("0-239"));
  if (!range) return {{}, complain(range.error(), kUsedWrongly)};
  const auto fps = read_fps(arguments.fps.value_or("30"));
  if (!fps) return {{}, complain(fps.error(), kUsedWrongly)};
  double side = 0;
  if (arguments.size && arguments.verb == PcaArguments::Verb::fit) {
    const auto size = read_whole("--size", *arguments.size, 1, View::kMaxSide);
    if (!size) return {{}, complain(size.error(), kUsedWrongly)};
    side = double(*size);
  }
  frames.face = read_face_or_report(arguments.input);
  if (!frames.face) return {{}, kFailed};
  Pose pose;
  for (const std::string& text : arguments.settings) {
    auto setting = read_setting(*frames.face, text);
    if (!setting) return {{}, complain(setting.error(), kUsedWrongly)};
    pose.settings.push_back(*std::move(setting));
  }
  frames.range = *range;
  frames.fps = *fps;
  frames.vertices = frames.face->vector.size();
  const auto count = std::size_t(range->count());
  if (count * frames.vertices * 8 > kMostClipBytes)
    return {{}, complain("--frames: so many frames of a face take more than 2 GiB", kUsedWrongly)};
  const FaceModel& model = *frames.face->model;
  const glm::dvec2 canvas = model.canvas.box.size();
  frames.groups = face_vertices(model.layout, side > 0 ? side / std::max(canvas.x, canvas.y) : 1.0);
  frames.rows = std::make_shared<std::vector<double>>(posed_rows(frames, pose));
  frames.source = matrix_in_memory(*frames.rows, count, frames.vertices);
  return {std::move(frames), kDone};
}

}  // namespace

PcaFramesOrCode read_pca_frames(const PcaArguments& arguments) {
  if (arguments.input.ends_with(".json")) return of_face(arguments);
  auto frames = of_file(arguments);
  if (!frames) return {{}, complain(frames.error(), kFailed)};
  return {*std::move(frames), kDone};
}

}  // namespace mien::command
