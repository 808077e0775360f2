#include "tools/mien/output/recipe.h"
#include <mien/version.h>
#include "lib/file/json/json_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace mien::command {

std::string recipe(const RenderArguments& arguments, const View& view) {
  const std::string face = std::filesystem::path(arguments.posed.face).filename().string();
  std::string text = fmt::format(R"({{"mien": "{}", "face": {}, "size": "{}x{}")",
                                 MIEN_VERSION_STRING, json_string(face), view.width, view.height);
  const auto add = [&](const char* name, const std::optional<std::string>& value) {
    if (value) text += fmt::format(R"(, "{}": {})", name, json_string(*value));
  };
  add("time", arguments.posed.time);
  add("fit", arguments.fit);
  add("region", arguments.region);
  add("background", arguments.background);
  add("blend", arguments.blend);
  add("light", arguments.light);
  add("legible", arguments.legible);
  add("dither", arguments.dither);
  add("debug", arguments.debug);
  const auto add_all = [&](const char* name, const std::vector<std::string>& values) {
    std::string list;
    for (const std::string& value : values) list += (list.empty() ? "" : ", ") + json_string(value);
    if (!values.empty()) text += fmt::format(R"(, "{}": [{}])", name, list);
  };
  add_all("clip", arguments.posed.clips);
  add("seed", arguments.posed.seed);
  add("liveliness", arguments.posed.liveliness);
  add("gestures", arguments.posed.gestures);
  add_all("pose", arguments.posed.poses);
  add("look_at", arguments.posed.look_at);
  add("blink", arguments.posed.blink);
  add("bias", arguments.posed.bias);
  add("unwrap", arguments.posed.unwrap);
  add("unwrap_mode", arguments.posed.unwrap_mode);
  add_all("emotion", arguments.posed.emotions);
  add_all("muscle", arguments.posed.muscles);
  if (arguments.posed.arkit)
    add("arkit", std::filesystem::path(*arguments.posed.arkit).filename().string());
  for (const auto& [name, file] :
       {std::pair{"motion", arguments.posed.motion}, {"speech", arguments.posed.speech}})
    if (file) add(name, std::filesystem::path(*file).filename().string());
  if (arguments.posed.clamp) text += R"(, "clamp": true)";
  add_all("set", arguments.posed.settings);
  add_all("morphs", arguments.posed.morphs);
  add("basis", arguments.posed.basis);
  add("weights", arguments.posed.weights);
  add_all("effect", arguments.effects);
  return text + "}";
}

}  // namespace mien::command
