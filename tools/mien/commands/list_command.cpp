// Every name of a face, as columns: what --set takes; then the poses that --pose takes, and the clips
// that --clip takes.

#include <mien/face_model.h>
#include <mien/motion_length.h>
#include <mien/pose.h>
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/list_moves.h"
#include "tools/mien/commands/posed_face.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mien::command {
namespace {

using Row = std::array<std::string, 4>;

std::string bound_text(double bound) {
  return std::isinf(bound) ? (bound < 0 ? "-inf" : "inf") : fmt::format("{:.6g}", bound);
}

std::string value_text(const std::vector<double>& value) {
  std::string text;
  for (double v : value) text += fmt::format("{}{:.6g}", text.empty() ? "" : ",", v);
  return text;
}

Row row_of(const SettableName& name) {
  return {name.name, name.unit, fmt::format("{} … {}", bound_text(name.lo), bound_text(name.hi)),
          value_text(name.value)};
}

/// Characters, for columns: UTF-8 bytes that begin one.
std::size_t width(const std::string& text) {
  return std::size_t(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string table(const std::vector<Row>& rows) {
  std::array<std::size_t, 4> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      text += row[i] + std::string(widths[i] + 2 - width(row[i]), ' ');
    text += row.back() + "\n";
  }
  return text;
}

/// The time until a curve repeats or ends.
double length_of(const Curve& curve) {
  const auto* keys = std::get_if<KeyCurve>(&curve);
  return keys && keys->period == 0 ? keys->keys.back().time : period_of(curve);
}

std::string clip_line(const FaceModel& model, Index<Motion> index) {
  const Motion& clip = index.in(model.clips);
  std::string line = "clip " + clip.name;
  if (index == model.default_clip) line += " (runs with --time)";
  if (clip.additive) line += " (additive)";
  for (const IdleChannel& channel : clip.idle)
    line += fmt::format("  {} by itself", channel.control.in(model.controls).name);
  for (const MotionChannel& channel : clip.channels)
    for (const Curve& curve : channel.curves)
      line += fmt::format("  {} every {:.4g} s", channel.control.in(model.controls).name,
                          length_of(curve));
  return line + "\n";
}

}  // namespace

int list_command(const ListArguments& arguments) {
  if (arguments.moves) return list_moves(*arguments.moves);
  if (arguments.face.empty())
    return complain("list: a FACE is needed, or --moves NAME", kUsedWrongly);
  const auto face = read_face_or_report(arguments.face);
  if (!face) return kFailed;
  const std::vector<SettableName> names = settable_names(*face);
  std::vector<Row> rows{{"NAME", "UNIT", "RANGE", "VALUE"}}, poses;
  for (const SettableName& name : names) (name.pose ? poses : rows).push_back(row_of(name));
  std::string text = table(rows);
  for (const Row& pose : poses) text += "pose " + pose[0] + "  " + pose[2] + "\n";
  for (int i = 0; i < int(face->model->clips.size()); ++i) text += clip_line(*face->model, {i});
  return print(text);
}

}  // namespace mien::command
