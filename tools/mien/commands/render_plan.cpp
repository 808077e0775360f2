#include "tools/mien/commands/render_plan.h"
#include "render/image/file_type.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/cli/parse_values.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien::command {
namespace {

enum class DepthChoice { eight, sixteen, half, full };  // in kDepths' order

/// "8, 16 or float".
std::string what_it_holds(const PictureFormat& format) {
  std::string text;
  for (const std::string_view& word : format.depths) {
    const bool last = &word == &format.depths.back();
    text += text.empty() ? "" : last ? " or " : ", ";
    text += word;
  }
  return text;
}

Depth drawn_depth(DepthChoice depth) {
  return depth == DepthChoice::eight     ? Depth::u8
         : depth == DepthChoice::sixteen ? Depth::u16
                                         : Depth::f32;
}

Expected<Done> plan_depth(RenderPlan& plan, const RenderArguments& arguments) {
  const PictureFormat& format = format_of(*plan.picture.write.type);
  const std::string word = arguments.depth.value_or(std::string(format.depths.front()));
  const auto chosen = read_choice("--depth", word, kDepths);
  if (!chosen) return chosen.error();
  const auto depth = DepthChoice(*chosen);
  if (std::find(format.depths.begin(), format.depths.end(), word) == format.depths.end())
    return Error{"--depth " + word, fmt::format("{} holds {}", format.name, what_it_holds(format))};
  plan.picture.depth = drawn_depth(depth);
  plan.picture.write.half = depth == DepthChoice::half;
  return Done{};
}

/// Reads a choice, if there is one, into an enumeration that counts in the choices' order.
template <class Enumeration>
Expected<Done> plan_choice(Enumeration& to, std::string_view option,
                           const std::optional<std::string>& text, std::string_view choices) {
  if (!text) return Done{};
  const auto chosen = read_choice(option, *text, choices);
  if (!chosen) return chosen.error();
  to = Enumeration(*chosen);
  return Done{};
}

/// Reads a value, if there is one.
template <class Value, class Read>
Expected<Done> plan_value(Value& to, const std::optional<std::string>& text, const Read& read) {
  if (!text) return Done{};
  const auto value = read(*text);
  if (!value) return value.error();
  to = *value;
  return Done{};
}

Expected<Done> plan_choices(RenderPlan& plan, const RenderArguments& arguments) {
  if (auto done = plan_choice(plan.view.fit, "--fit", arguments.fit, kFits); !done) return done;
  if (auto done = plan_choice(plan.view.blend, "--blend", arguments.blend, kBlends); !done)
    return done;
  bool undithered = !plan.view.dither;
  if (auto done = plan_choice(undithered, "--dither", arguments.dither, kDithers); !done)
    return done;
  plan.view.dither = !undithered;
  int stats = 0;  // the only one
  plan.stats = arguments.stats.has_value();
  return plan_choice(stats, "--stats", arguments.stats, kStats);
}

/// What is drawn instead of the picture, or beside it.
Expected<Done> plan_inspection(RenderPlan& plan, const RenderArguments& arguments) {
  if (arguments.debug && !is_face_debug(*arguments.debug) && *arguments.debug != kMorphDebug) {
    DebugPicture debug{};
    if (auto done = plan_choice(debug, "--debug", arguments.debug, kDebugs); !done) return done;
    if (!arguments.effects.empty() || plan.stats)
      return Error{arguments.effects.empty() ? "--stats" : "--effect",
                   "is of the face's own picture, not of --debug " + *arguments.debug};
    plan.debug = debug;
  }
  plan.error_map = arguments.error_map;
  return plan_value(plan.error_map_write.type, arguments.error_map,
                    [](const std::string& path) { return chosen_type(path, {}); });
}

Expected<Done> plan_values(RenderPlan& plan, const RenderArguments& arguments) {
  if (auto done = plan_value(plan.picture.write.threads.count, arguments.threads, read_threads);
      !done)
    return done;
  if (auto done = plan_value(plan.view.light, arguments.light, read_light); !done) return done;
  const auto read_legible = [](const std::string& text) {
    return read_real("--legible", text, 0, View::kMostLegible);
  };
  if (auto done = plan_value(plan.view.legible, arguments.legible, read_legible); !done)
    return done;
  if (auto done = plan_value(plan.view.background, arguments.background, read_background); !done)
    return done;
  if (auto done = plan_value(plan.picture.memory, arguments.memory, read_memory); !done)
    return done;
  if (arguments.memory) plan.picture.limits.memory = plan.picture.memory;
  if (auto done = plan_value(plan.picture.limits.steps, arguments.most_steps, read_most_steps);
      !done)
    return done;
  // Whether it is a size at all can be checked before the face is read.
  if (!arguments.size) return Done{};
  const auto size = read_size(*arguments.size, 1.0);
  return size ? Expected<Done>(Done{}) : size.error();
}

/// What a picture is and how it is drawn, but for its depth.
Expected<RenderPlan> plan_picture(const RenderArguments& arguments) {
  RenderPlan plan;
  for (const auto& part : {plan_choices, plan_inspection, plan_values})
    if (auto done = part(plan, arguments); !done) return done.error();
  return plan;
}

}  // namespace

Expected<RenderPlan> plan_render(const RenderArguments& arguments) {
  if (arguments.output.empty()) return Error{"--output", "its name is empty"};
  const auto type = chosen_type(arguments.output, {});
  if (!type) return type.error();
  auto plan = plan_picture(arguments);
  if (!plan) return plan;
  plan->picture.write.type = *type;
  if (arguments.dpi) {
    const auto dpi = read_real("--dpi", *arguments.dpi, 1, WriteOptions::kMostDpi);
    if (!dpi) return dpi.error();
    plan->picture.write.dpi = *dpi;
  }
  if (auto done = plan_depth(*plan, arguments); !done) return done.error();
  return plan;
}

Expected<RenderPlan> plan_frame(const RenderArguments& arguments) {
  auto plan = plan_picture(arguments);
  if (!plan || !arguments.depth) return plan;
  const auto chosen = read_choice("--depth", *arguments.depth, kDepths);
  if (!chosen) return chosen.error();
  plan->picture.depth = drawn_depth(DepthChoice(*chosen));
  return plan;
}

Expected<Done> plan_view(RenderPlan& plan, const RenderArguments& arguments, const Canvas& canvas) {
  const double aspect = canvas.box.size().x / canvas.box.size().y;
  const auto size =
      read_size(arguments.size ? *arguments.size : std::to_string(kDefaultSide), aspect);
  if (!size) return size.error();
  plan.view.width = size->width;
  plan.view.height = size->height;
  if (arguments.region) {
    const auto region = read_region(*arguments.region, *size);
    if (!region) return region.error();
    plan.view.region = *region;
  }
  return Done{};
}

}  // namespace mien::command
