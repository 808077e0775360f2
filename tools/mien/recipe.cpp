#include <mien/tools/mien/json_text.h>
#include <mien/tools/mien/recipe.h>
#include <mien/version.h>

#include <fmt/format.h>

#include <filesystem>

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
  if (!arguments.posed.settings.empty()) {
    std::string list;
    for (const std::string& setting : arguments.posed.settings) {
      list += (list.empty() ? "" : ", ") + json_string(setting);
    }
    text += fmt::format(R"(, "set": [{}])", list);
  }
  return text + "}";
}

}  // namespace mien::command
