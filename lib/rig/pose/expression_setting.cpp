#include "lib/rig/pose/expression_setting.h"

#include <mien/face_model.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/face/standard_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include "lib/base/from_chars.h"

namespace mien {
namespace {

/// "emotion.left.joy" as it is typed after --emotion: "left.joy".
std::string_view typed_name(const Control& control, const std::string& prefix) {
  return control.name.substr(prefix.size());
}

bool is_one_sided(std::string_view name) {
  return name.starts_with("left.") || name.starts_with("right.");
}

std::string none_of(const std::vector<Control>& controls, std::string_view set) {
  if (set == "emotion" || set == "muscle") return fmt::format("this face has no {}s", set);
  if (!standard_names(set).empty()) return fmt::format("this face has no table of {} names", set);
  std::vector<std::string_view> sets;
  for (const Control& control : controls)
    for (const std::string_view known :
         {"emotion", "muscle", "arkit", "facs", "vrm", "viseme", "azure"})
      if (control.name.starts_with(std::string(known) + ".")) sets.push_back(known);
  return unknown_name("set", set, sets);
}

}  // namespace

Expected<Setting> read_expression(const Face& face, std::string_view set, std::string_view text,
                                  OutOfRange out) {
  const std::string where = one_line(text, 80), prefix = std::string{set} + ".";
  const std::size_t equals = text.find('=');
  const std::string spelt = standard_spelling(set, text.substr(0, equals));
  const std::string_view name = spelt;
  double value = 1;
  if (equals != std::string_view::npos) {
    std::string_view word = text.substr(equals + 1);
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, status] = from_chars(word.data(), word.data() + word.size(), value);
    if (status != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      return Error{where, fmt::format("expected a finite number, got {}", in_quotes(word))};
  }
  const std::vector<Control>& controls = face.model->controls;
  std::vector<std::string_view> known;
  for (std::size_t c = 0; c < controls.size(); ++c) {
    if (!controls[c].name.starts_with(prefix)) continue;
    known.push_back(typed_name(controls[c], prefix));
    if (known.back() != name) continue;
    if (out == OutOfRange::clamp) value = std::clamp(value, 0.0, 1.0);
    if (!(value >= 0 && value <= 1))
      return Error{where, fmt::format("{} goes from 0 to 1, got {}", in_quotes(name), value)};
    return Setting{true, int(c), {value}};
  }
  if (known.empty()) return Error{where, none_of(controls, set)};
  if (const std::size_t dot = name.find('.'); dot != std::string_view::npos && is_one_sided(name))
    if (const auto bare = name.substr(dot + 1);
        std::find(known.begin(), known.end(), bare) != known.end())
      return Error{where, fmt::format("{} has no left and right: it is one", in_quotes(bare))};
  const bool standard = !standard_names(set).empty();
  if (name.find('.') == std::string_view::npos) std::erase_if(known, is_one_sided);
  return Error{
      where, unknown_name(standard ? fmt::format("{} name", set) : std::string{set}, name, known)};
}

}  // namespace mien
