// The names of a face that can be set, and the reading of settings: the second half of pose.h.

#include <mien/face_model.h>
#include <mien/pose.h>
#include "lib/base/memory_ran_out.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/face/standard_names.h"
#include "lib/picture/color_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include "lib/base/from_chars.h"

namespace mien {
namespace {

/// What a setting can set: a control, a slice or one number of a slice.
struct Target {
  bool control;
  int index;  ///< Setting::index
  int size;
  const Slice* slice;  ///< null: a control
};

std::optional<Target> find_target(const FaceModel& model, std::string_view given) {
  const std::size_t dot = std::min(given.find('.'), given.size());
  const std::string_view set = given.substr(0, dot);
  const std::string spelt =
      standard_names(set).empty()
          ? std::string(given)
          : std::string(set) + "." +
                standard_spelling(set, given.substr(std::min(dot + 1, given.size())));
  const std::string_view name = spelt;
  for (std::size_t c = 0; c < model.controls.size(); ++c)
    if (model.controls[c].name == name) return Target{true, int(c), 1, nullptr};
  if (const int found = model.layout.find(name); found >= 0) {
    const Slice& slice = model.layout[found];
    return Target{false, slice.begin, slice.size, &slice};
  }
  const std::size_t slash = name.rfind('/');
  if (slash == std::string_view::npos) return {};
  const int found = model.layout.find(name.substr(0, slash));
  if (found < 0) return {};
  const Slice& slice = model.layout[found];
  for (int i = 0; i < slice.size; ++i)
    if (component_name(slice.kind, i) == name.substr(slash + 1))
      return Target{false, slice.begin + i, 1, &slice};
  return {};
}

std::vector<std::string_view> all_names(const FaceModel& model) {
  std::vector<std::string_view> names;
  for (const Control& control : model.controls) names.push_back(control.name);
  for (const Slice& slice : model.layout.slices()) names.push_back(slice.name);
  return names;
}

/// The numbers of "1,2.5,-3"; an error for anything else.
Expected<std::vector<double>> read_numbers(std::string_view text, const std::string& where) {
  std::vector<double> numbers;
  for (;;) {
    const std::size_t comma = text.find(',');
    std::string_view word = text.substr(0, comma);
    if (word.starts_with('+')) word.remove_prefix(1);  // from_chars takes no plus
    double number = 0;
    const auto [end, status] = from_chars(word.data(), word.data() + word.size(), number);
    if (status == std::errc::result_out_of_range)
      return Error{where,
                   fmt::format("{} is too large or too small for a number", in_quotes(word))};
    if (status != std::errc{} || end != word.data() + word.size() || word.empty())
      return Error{where, fmt::format("expected a number, got {}", in_quotes(word))};
    if (!std::isfinite(number))
      return Error{where, fmt::format("expected a finite number, got {}", in_quotes(word))};
    numbers.push_back(number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

Expected<double> read_number(std::string_view text, const std::string& where) {
  const auto numbers = read_numbers(text, where);
  if (!numbers) return numbers.error();
  if (numbers->size() != 1)
    return Error{where, fmt::format("expected a number, got {}", in_quotes(text))};
  return (*numbers)[0];
}

Expected<std::vector<double>> read_values(const Target& target, std::string_view text,
                                          const std::string& where) {
  const bool color = target.slice && target.slice->kind == SliceKind::color && target.size == 4;
  if (color && text.find_first_of("+-.0123456789") != 0) {
    const std::optional<Color> c = color_from_text(text);
    if (!c)
      return Error{where, fmt::format("expected a colour like #rrggbb, got {}", in_quotes(text))};
    return std::vector<double>{c->r, c->g, c->b, c->a};
  }
  Expected<std::vector<double>> numbers = read_numbers(text, where);
  if (numbers && color && numbers->size() == 3) numbers->push_back(1);
  if (numbers && int(numbers->size()) != target.size)
    return Error{where, fmt::format("expected {} number{}, got {}", target.size,
                                    target.size == 1 ? "" : "s", numbers->size())};
  return numbers;
}

/// The range of the numbers: a channel's, or a slice's if its rule is to clamp.
struct Range {
  double lo, hi;
};

Range range_of(const FaceModel& model, const Target& target) {
  if (target.control) {
    const Control& control = model.controls[std::size_t(target.index)];
    const Channel& channel = control.channels[0].in(model.channels);
    return {channel.lo, channel.hi};
  }
  const double largest = model.layout.largest;
  const SliceRange range = target.slice->range();
  if (range.rule != Rule::clamp) return {-largest, largest};
  return {range.lo, std::fmin(range.hi, largest)};
}

}  // namespace

Expected<Setting> read_setting(const Face& face, std::string_view text) try {
  const FaceModel& model = *face.model;
  const std::string where = one_line(text, 80);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return Error{where, "expected NAME=VALUE"};
  const std::string_view name = text.substr(0, equals);
  const std::optional<Target> target = find_target(model, name);
  if (!target) return Error{where, unknown_name("control or number", name, all_names(model))};
  const auto values = read_values(*target, text.substr(equals + 1), where);
  if (!values) return values.error();
  const Range range = range_of(model, *target);
  for (const double value : *values)
    if (!(value >= range.lo && value <= range.hi))
      return Error{where, fmt::format("{} goes from {} to {}, got {}", in_quotes(name), range.lo,
                                      range.hi, value)};
  return Setting{target->control, target->index, *values};
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<Setting> read_pose(const Face& face, std::string_view text) try {
  const FaceModel& model = *face.model;
  const std::string_view name = text.substr(0, text.find('='));
  std::vector<std::string_view> poses;
  for (const Control& control : model.controls)
    if (control.pose) poses.push_back(control.name);
  if (std::find(poses.begin(), poses.end(), name) == poses.end())
    return Error{one_line(text, 80), unknown_name("pose", name, poses)};
  return read_setting(face, name == text ? std::string(text) + "=1" : std::string(text));
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<MotionLayer> read_clip_layer(const Face& face, std::string_view text) try {
  const std::vector<Motion>& clips = face.model->clips;
  const std::string where = one_line(text, 80);
  const std::string_view name = text.substr(0, text.find('='));
  std::vector<std::string_view> known;
  for (const Motion& clip : clips) known.push_back(clip.name);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end()) return Error{where, unknown_name("clip", name, known)};
  MotionLayer layer{.clip = {int(found - known.begin())}};
  if (name == text) return layer;
  const std::string_view numbers = text.substr(name.size() + 1);
  const auto weight = read_number(numbers.substr(0, numbers.find('@')), where);
  if (!weight) return weight.error();
  layer.weight = *weight;
  if (numbers.find('@') == std::string_view::npos) return layer;
  const auto begin = read_number(numbers.substr(numbers.find('@') + 1), where);
  if (!begin) return begin.error();
  layer.begin = *begin;
  return layer;
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<glm::dvec3> read_look_at(const Face& face, std::string_view text) try {
  const std::string where = one_line(text, 80);
  const std::vector<Eye>& eyes = face.model->eyes;
  if (std::none_of(eyes.begin(), eyes.end(),
                   [](const Eye& eye) { return eye.gaze_x || eye.gaze_y; }))
    return Error{where, "this face has no eyes that look: its file says none under \"eyes\""};
  const auto numbers = read_numbers(text, where);
  if (!numbers) return numbers.error();
  if (numbers->size() != 3)
    return Error{where, fmt::format("expected 3 numbers X,Y,Z, got {}", numbers->size())};
  return glm::dvec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

std::vector<SettableName> settable_names(const Face& face) {
  const FaceModel& model = *face.model;
  std::vector<SettableName> names;
  for (const Control& control : model.controls) {
    const Channel& channel = control.channels[0].in(model.channels);
    names.push_back({std::string(control.name),
                     std::string(control.unit),
                     channel.lo,
                     channel.hi,
                     {channel.rest},
                     true,
                     control.pose});
  }
  for (const Slice& slice : model.layout.slices()) {
    const auto first = face.vector.begin() + slice.begin;
    const SliceRange range = slice.range();
    names.push_back({std::string(slice.name), unit_name(slice.kind, model.canvas.unit), range.lo,
                     range.hi, FaceVector(first, first + slice.size), false, false});
  }
  return names;
}

}  // namespace mien
