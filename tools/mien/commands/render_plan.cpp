#include "tools/mien/commands/render_plan.h"
#include "render/image/file_type.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/cli/parse_values.h"

#include <fmt/format.h>

namespace mien::command {
namespace {

enum class DepthChoice { eight, sixteen, half, full };  // in kDepths' order

bool holds(FileType type, DepthChoice depth) {
  switch (type) {
    case FileType::png:
      return depth == DepthChoice::eight || depth == DepthChoice::sixteen;
    case FileType::tiff:
      return depth != DepthChoice::half;
    case FileType::exr:
      return depth == DepthChoice::half || depth == DepthChoice::full;
    case FileType::jpeg:
      return depth == DepthChoice::eight;
  }
  return false;
}

const char* what_it_holds(FileType type) {
  switch (type) {
    case FileType::png:
      return "8 or 16";
    case FileType::tiff:
      return "8, 16 or float";
    case FileType::exr:
      return "half or float";
    case FileType::jpeg:
      return "8";
  }
  return "";
}

Depth drawn_depth(DepthChoice depth) {
  return depth == DepthChoice::eight     ? Depth::u8
         : depth == DepthChoice::sixteen ? Depth::u16
                                         : Depth::f32;
}

Expected<Done> plan_depth(RenderPlan& plan, const RenderArguments& arguments) {
  DepthChoice depth =
      *plan.picture.write.type == FileType::exr ? DepthChoice::half : DepthChoice::eight;
  if (arguments.depth) {
    const auto chosen = read_choice("--depth", *arguments.depth, kDepths);
    if (!chosen) return chosen.error();
    depth = DepthChoice(*chosen);
    if (!holds(*plan.picture.write.type, depth)) {
      return Error{"--depth " + *arguments.depth,
                   fmt::format("{} holds {}", type_name(*plan.picture.write.type),
                               what_it_holds(*plan.picture.write.type))};
    }
  }
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

}  // namespace

namespace {

/// What a picture is and how it is drawn, but for its depth.
Expected<RenderPlan> plan_picture(const RenderArguments& arguments) {
  RenderPlan plan;
  if (auto done = plan_choice(plan.view.fit, "--fit", arguments.fit, kFits); !done)
    return done.error();
  if (auto done = plan_choice(plan.view.blend, "--blend", arguments.blend, kBlends); !done)
    return done.error();
  if (auto done = plan_choice(plan.progress, "--progress", arguments.progress, kProgress); !done)
    return done.error();
  if (arguments.stats) {
    const auto chosen = read_choice("--stats", *arguments.stats, kStats);
    if (!chosen) return chosen.error();
    plan.stats = true;
  }
  if (arguments.threads) {
    const auto threads = read_threads(*arguments.threads);
    if (!threads) return threads.error();
    plan.picture.write.threads.count = *threads;
  }
  bool undithered = !plan.view.dither;
  if (auto done = plan_choice(undithered, "--dither", arguments.dither, kDithers); !done)
    return done.error();
  plan.view.dither = !undithered;
  if (arguments.debug && !is_face_debug(*arguments.debug) && *arguments.debug != kMorphDebug) {
    DebugPicture debug{};
    if (auto done = plan_choice(debug, "--debug", arguments.debug, kDebugs); !done)
      return done.error();
    if (!arguments.effects.empty() || plan.stats)
      return Error{arguments.effects.empty() ? "--stats" : "--effect",
                   "is of the face's own picture, not of --debug " + *arguments.debug};
    plan.debug = debug;
  }
  if (arguments.error_map) {
    const auto type = chosen_type(*arguments.error_map, {});
    if (!type) return type.error();
    plan.error_map = arguments.error_map;
    plan.error_map_write.type = *type;
  }
  if (arguments.light) {
    const auto light = read_light(*arguments.light);
    if (!light) return light.error();
    plan.view.light = *light;
  }
  if (arguments.background) {
    const auto color = read_background(*arguments.background);
    if (!color) return color.error();
    plan.view.background = *color;
  }
  if (arguments.memory) {
    const auto memory = read_memory(*arguments.memory);
    if (!memory) return memory.error();
    plan.picture.memory = *memory;
  }
  // Whether it is a size at all can be said before the face is read.
  if (arguments.size) {
    if (const auto size = read_size(*arguments.size, 1.0); !size) return size.error();
  }
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
