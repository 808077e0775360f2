// mien render: read, pose, draw, write; and stop in between when asked to.

#include <mien/lib/base/monotonic_seconds.h>
#include <mien/lib/face/face_model.h>
#include <mien/lib/file/face_file.h>
#include <mien/render/error_map.h>
#include <mien/render/image/write_pieces.h>
#include <mien/sdf/from_face/morph_heat.h>
#include <mien/sdf/from_face/scene_from_face.h>
#include <mien/tools/mien/choices.h>
#include <mien/tools/mien/commands.h>
#include <mien/tools/mien/drawn_picture.h>
#include <mien/tools/mien/image_loader.h>
#include <mien/tools/mien/interrupt.h>
#include <mien/tools/mien/posed_face.h>
#include <mien/tools/mien/recipe.h>
#include <mien/tools/mien/render_plan.h>
#include <mien/tools/mien/values.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace mien::command {
namespace {

/// [s] that each part took; of drawing and writing, which go hand in hand, `picture` is the time
/// together, the others are those of all threads.
struct Times {
  double read = 0, scene = 0, picture = 0;
};

std::string stats_text(const PictureStats& stats, const PixelRect& drawn, const Times& times) {
  return fmt::format(
      "{{\"width\": {}, \"height\": {}, \"pixels\": {}, \"fill_pixels\": {}, "
      "\"varied_pixels\": {}, \"edge_pixels\": {}, \"resolved_pixels\": {}, \"pieces\": {}, "
      "\"crossings\": {}, \"regions\": {}, \"doubts\": {}, \"roots\": {}, \"distances\": {}, "
      "\"seconds\": {{\"read\": {:.6f}, \"scene\": {:.6f}, "
      "\"picture\": {:.6f}, \"draw\": {:.6f}, \"encode\": {:.6f}, \"roots\": {:.6f}, "
      "\"distances\": {:.6f}, \"write\": {:.6f}}}, \"solving_share\": {:.3f}}}\n",
      drawn.width, drawn.height, stats.render.pixels, stats.render.fill_pixels,
      stats.render.varied_pixels, stats.render.edge_pixels, stats.render.resolved_pixels,
      stats.render.pieces, stats.render.crossings, stats.render.regions, stats.render.doubts,
      stats.render.roots, stats.render.distances, times.read, times.scene, times.picture,
      stats.draw, stats.encode, stats.render.root_seconds, stats.render.distance_seconds, stats.put,
      (stats.render.root_seconds + stats.render.distance_seconds) / std::max(stats.draw, 1e-9));
}

/// On standard output, unless a picture is there.
int print_stats(const std::string& text, const std::string& output) {
  if (output != "-") return print(text);
  std::fwrite(text.data(), 1, text.size(), stderr);
  return kDone;
}

Expected<Done> check_output(const std::string& output, const WriteOptions& write) {
  if (output == "-" && ::isatty(STDOUT_FILENO)) {
    return Error{"-o -", "will not write a picture to a terminal; redirect it or name a file"};
  }
  return check_target(output, write);
}

/// Effects look at the whole picture: it is drawn in memory.
Expected<PictureStats> write_with_effects(const std::string& output, RenderPlan& plan,
                                          const Scene& scene, const std::vector<Effect>& effects) {
  PictureStats stats;
  const RenderOptions how{.depth = plan.picture.depth.value_or(Depth::u8),
                          .threads = plan.picture.write.threads,
                          .progress = plan.picture.write.progress};
  const Image image = drawn_picture(scene, plan.view, how, effects, &stats.render);
  if (stats.render.cancelled) return Error{output, "cancelled"};
  const auto done = write_image_by(load_encoder, image, output, plan.picture.write);
  if (!done) return done.error();
  return stats;
}

int draw_and_write(const RenderArguments& arguments, RenderPlan& plan, const Scene& scene,
                   const std::vector<Effect>& effects, Times times) {
  Expected<PictureStats> done = PictureStats{};
  {
    ProgressDisplay display(plan.progress);
    plan.picture.write.recipe = recipe(arguments, plan.view);
    plan.picture.write.progress = display.watch("render");
    const double began = monotonic_seconds();
    done = effects.empty()
               ? write_picture_by(load_encoder, scene, plan.view, arguments.output, plan.picture)
               : write_with_effects(arguments.output, plan, scene, effects);
    times.picture = monotonic_seconds() - began;
  }
  if (interrupted() && !done) return complain("interrupted", kFailed);
  if (!done) return complain(done.error(), kFailed);
  return plan.stats ? print_stats(stats_text(*done, drawn_rect(plan.view), times), arguments.output)
                    : kDone;
}

/// A debug picture, instead of the face's own.
int write_debug(const RenderArguments& arguments, const RenderPlan& plan, const Scene& scene) {
  WriteOptions write = plan.picture.write;
  write.recipe = recipe(arguments, plan.view);
  const Image image = debug_picture(scene, plan.view, *plan.debug, write.threads);
  const auto done = write_image_by(load_encoder, image, arguments.output, write);
  return done ? kDone : complain(done.error(), kFailed);
}

/// The certified bounds as grey, and the largest of them in words.
int write_error_map(const RenderArguments& arguments, RenderPlan& plan, const Scene& scene) {
  const ErrorMap map = error_map(scene, plan.view, plan.picture.depth.value_or(Depth::u8),
                                 plan.picture.write.threads);
  plan.error_map_write.recipe = recipe(arguments, plan.view);
  const auto done =
      write_image_by(load_encoder, map.image(), *plan.error_map, plan.error_map_write);
  if (!done) return complain(done.error(), kFailed);
  return print_stats(
      fmt::format(
          "no channel is off by more than {:.3f} of 255, rounding left out{}\n", map.worst,
          map.unproven ? "; light and gradients along a distance are estimated, not proven" : ""),
      *plan.error_map == "-" ? *plan.error_map : arguments.output);
}

constexpr std::string_view kMorphDebug = "morph";  // of kDebugs: a scene of its own

/// The face, or how far its points have gone.
Expected<Scene> scene_to_draw(const RenderArguments& arguments, const Face& posed) {
  if (arguments.debug != kMorphDebug) return scene_from_face(posed);
  const auto rest = read_face(arguments.posed.face);
  if (!rest) return rest.error();
  const MorphHeat heat = morph_heat(*rest, posed);
  if (arguments.output != "-")
    print(fmt::format("largest displacement {:.6g} {}\n", heat.largest, posed.model->canvas.unit));
  return heat.scene;
}

}  // namespace

int render_command(const RenderArguments& arguments) {
  auto plan = plan_render(arguments);
  if (!plan) return complain(plan.error(), kUsedWrongly);
  if (auto writable = check_output(arguments.output, plan->picture.write); !writable) {
    return complain(writable.error(), kFailed);
  }
  if (plan->error_map) {
    if (*plan->error_map == arguments.output)
      return complain({"--error-map " + *plan->error_map, "is the picture's own name"},
                      kUsedWrongly);
    if (auto writable = check_target(*plan->error_map, plan->error_map_write); !writable)
      return complain(writable.error(), kFailed);
  }
  Times times;
  double began = monotonic_seconds();
  const bool face_debug = arguments.debug && is_face_debug(*arguments.debug);
  const auto posed = read_posed_face(arguments.posed);
  if (!posed.face) return posed.code;
  times.read = monotonic_seconds() - began;

  began = monotonic_seconds();
  const auto over = face_debug ? read_scene(arguments.posed, arguments.debug) : SceneOrCode{};
  const auto drawn =
      over.scene ? Expected<Scene>(*over.scene) : scene_to_draw(arguments, *posed.face);
  if (!drawn) return complain(drawn.error(), kUsedWrongly);
  const Scene& scene = *drawn;
  times.scene = monotonic_seconds() - began;
  if (auto planned = plan_view(*plan, arguments, scene.canvas()); !planned) {
    return complain(planned.error(), kUsedWrongly);
  }
  const auto effects = read_effects(arguments, *posed.face, plan->view.width);
  if (!effects) return complain(effects.error(), kUsedWrongly);
  watch_interrupts();
  int code = plan->debug && arguments.debug != kMorphDebug
                 ? write_debug(arguments, *plan, scene)
                 : draw_and_write(arguments, *plan, scene, *effects, times);
  if (code == kDone && plan->error_map) code = write_error_map(arguments, *plan, scene);
  if (code != kDone && interrupted()) die_of_interrupt();
  return code;
}

}  // namespace mien::command
