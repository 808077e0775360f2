// mien fit: which pulls bring a face's points nearest to where they are wanted.

#include <mien/face_model.h>
#include "lib/base/nearest_name.h"
#include "lib/file/json/frame_file.h"
#include "lib/rig/muscle/fit.h"
#include "lib/rig/pose/expression_setting.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien::command {
namespace {

/// Whether muscles take part in what a control does; for gaze and blink they do not.
bool pulls_muscles(const Face& face, const Setting& setting) {
  const std::string_view name = face.model->controls[std::size_t(setting.index)].name;
  for (const Expression& expression : face.model->expressions)
    if (expression.name == name) return !expression.pulls.empty();
  return false;
}

/// The targets of a frame of ARKit's numbers: the places where its table puts the points.
Expected<std::vector<PointTarget>> targets_of_arkit(const Face& face,
                                                    const std::vector<FrameNumber>& frame) {
  Pose pose;
  for (const FrameNumber& number : frame) {
    auto setting =
        read_expression(face, "arkit", fmt::format("{}={}", number.name, number.values[0]));
    if (!setting) return Error{number.where, setting.error().what};
    if (pulls_muscles(face, *setting)) pose.settings.push_back(*std::move(setting));
  }
  const Face posed = pose_face(face, pose);
  std::vector<PointTarget> targets;
  for (const MusclePoint& point : face.model->muscles.points) {
    const auto begin = std::size_t(face.model->layout[point.slice].begin);
    targets.push_back({point.slice, {posed.vector[begin], posed.vector[begin + 1]}});
  }
  return targets;
}

Expected<std::vector<PointTarget>> targets_of(const Face& face,
                                              const std::vector<FrameNumber>& frame) {
  if (frame.empty()) return Error{"targets", "there are none"};
  if (std::all_of(frame.begin(), frame.end(),
                  [](const FrameNumber& number) { return number.values.size() == 1; }))
    return targets_of_arkit(face, frame);
  std::vector<PointTarget> targets;
  for (const FrameNumber& number : frame) {
    const int slice = face.model->layout.find(number.name);
    if (slice < 0 || face.model->layout[slice].kind != SliceKind::point) {
      std::vector<std::string_view> known;
      for (const Slice& s : face.model->layout.slices())
        if (s.kind == SliceKind::point) known.push_back(s.name);
      return Error{number.where, unknown_name("point", number.name, known)};
    }
    if (number.values.size() != 2)
      return Error{number.where, fmt::format("expected 2 numbers, got {}", number.values.size())};
    targets.push_back({slice, {number.values[0], number.values[1]}});
  }
  return targets;
}

}  // namespace

int fit_command(const FitArguments& arguments) {
  const auto face = read_face_or_report(arguments.face);
  if (!face) return kFailed;
  const FaceModel& model = *face->model;
  if (model.muscles.muscles.empty())
    return complain({arguments.face, "this face has no muscles"}, kFailed);
  const auto frame = read_frame(arguments.targets);
  if (!frame) return complain(frame.error(), kFailed);
  const auto targets = targets_of(*face, *frame);
  if (!targets) return complain(targets.error(), kFailed);
  WatchedWork work("fit");
  const MuscleFit fit = fit_muscles(*face, *targets, [&](double share) { work.at(share); });
  std::string text;
  for (std::size_t m = 0; m < fit.pulls.size(); ++m)
    if (fit.pulls[m] > 5e-7)
      text += fmt::format("{} {:.6f}\n",
                          control_of_side(fmt::format("muscle.{}", model.muscles.muscles[m].name),
                                          model.muscles.muscles[m].side),
                          fit.pulls[m]);
  text +=
      fmt::format("residual: rms {:.6g}, largest {:.6g} {} at {}, over {} points\n", fit.rms,
                  fit.largest, model.canvas.unit, model.layout[fit.farthest].name, targets->size());
  return print(text);
}

}  // namespace mien::command
