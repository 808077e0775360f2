#include "tools/mien/commands/render_svg.h"
#include <mien/face_model.h>
#include <mien/scene_from_face.h>
#include "lib/base/watch.h"
#include "render/image/file_type.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/commands/render_plan.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/recipe.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/progress_display.h"

namespace mien::command {

Expected<Done> check_svg_options(const RenderArguments& a) {
  const std::pair<const char*, bool> pixels_only[] = {{"--region", bool(a.region)},
                                                      {"--depth", bool(a.depth)},
                                                      {"--dither", bool(a.dither)},
                                                      {"--light", bool(a.light)},
                                                      {"--error-map", bool(a.error_map)},
                                                      {"--stats", bool(a.stats)},
                                                      {"--dpi", bool(a.dpi)}};
  for (const auto& [option, given] : pixels_only)
    if (given) return Error{option, "is for pictures of pixels; an SVG file holds shapes"};
  if (a.blend && *a.blend == "linear")
    return Error{"--blend linear", "SVG viewers mix colours as encoded: --blend srgb"};
  if (a.debug && !is_face_debug(*a.debug))
    return Error{"--debug " + *a.debug, "is a picture of pixels; an SVG file holds shapes"};
  if (!a.effects.empty() && a.effects != std::vector<std::string>{"none"})
    return Error{"--effect", "acts on pixels; an SVG file holds shapes"};
  return Done{};
}

SvgOptions svg_options(const RenderArguments& arguments, const RenderPlan& plan,
                       const Progress& progress) {
  const View& view = plan.view;
  return {.width = double(view.width),
          .height = double(view.height),
          .fit = view.fit,
          .legible = view.legible,
          .background = view.background,
          .recipe = recipe(arguments, view),
          .id_prefix = arguments.id_prefix,
          .progress = progress,
          .limits = {.steps = kWithoutLimits.steps, .memory = plan.picture.limits.memory}};
}

namespace {

void tell_simplified(const std::string& output, const std::vector<Effect>& effects,
                     const std::vector<std::string>& simplified) {
  std::vector<Error> told;
  if (!effects.empty())
    told.push_back({output, "the face's own effects are left out, for they act on pixels"});
  for (const std::string& one : simplified) told.push_back({output, one});
  warn(told);
}

int write_scene(const RenderArguments& arguments, const RenderPlan& plan, const Scene& scene,
                const std::vector<Effect>& effects) {
  ProgressDisplay display;
  const SvgOptions options = svg_options(arguments, plan, display.watch("render"));
  watch_interrupts();
  const auto done = write_svg(scene, arguments.output, options);
  if (!done && interrupted()) throw Stopped{Stopped::Why::cancelled};
  if (!done) return complain(done.error(), kFailed);
  tell_simplified(arguments.output, effects, *done);
  if (interrupted()) die_of_interrupt();
  return kDone;
}

}  // namespace

bool asks_for_svg(const RenderArguments& arguments) {
  return lower_extension(arguments.output) == ".svg";
}

int render_svg(const RenderArguments& arguments) {
  if (auto fits = check_svg_options(arguments); !fits) return complain(fits.error(), kUsedWrongly);
  auto plan = plan_frame(arguments);
  if (!plan) return complain(plan.error(), kUsedWrongly);
  const auto posed = read_posed_face(arguments.posed);
  if (!posed.face) return posed.code;
  const auto drawn = arguments.debug ? read_scene(arguments.posed, arguments.debug)
                                     : SceneOrCode{scene_from_face(*posed.face)};
  if (!drawn.scene) return drawn.code;
  if (auto planned = plan_view(*plan, arguments, drawn.scene->canvas()); !planned)
    return complain(planned.error(), kUsedWrongly);
  const auto effects = read_effects(arguments, *posed.face, plan->view.width);
  if (!effects) return complain(effects.error(), kUsedWrongly);
  return write_scene(arguments, *plan, *drawn.scene, *effects);
}

}  // namespace mien::command
