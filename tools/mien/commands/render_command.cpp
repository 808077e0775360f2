// mien render: read, pose, draw, write; and stop in between when asked to.

#include <mien/error_map.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/morph_heat.h>
#include <mien/scene_from_face.h>
#include "lib/base/monotonic_seconds.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/commands/render_plan.h"
#include "tools/mien/commands/render_svg.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/effected_rows.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/output/recipe.h"
#include "tools/mien/output/write_strips.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/progress_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace mien::command {
namespace {

/// [s] that each part took. Drawing and writing overlap: `picture` is the time of both together; their own
/// times are summed over all threads.
struct Times {
  double read = 0, scene = 0, picture = 0;
};

std::string stats_text(const PictureStats& stats, const PixelRect& drawn, const Times& times) {
  return fmt::format(
      "{{\"width\": {}, \"height\": {}, \"pixels\": {}, \"fill_pixels\": {}, "
      "\"varied_pixels\": {}, \"edge_pixels\": {}, \"resolved_pixels\": {}, \"pieces\": {}, "
      "\"crossings\": {}, \"regions\": {}, \"doubts\": {}, \"roots\": {}, \"distances\": {}, "
      "\"steps\": {}, \"memory\": {}, "
      "\"seconds\": {{\"read\": {:.6f}, \"scene\": {:.6f}, "
      "\"picture\": {:.6f}, \"draw\": {:.6f}, \"encode\": {:.6f}, \"roots\": {:.6f}, "
      "\"distances\": {:.6f}, \"write\": {:.6f}}}, \"solving_share\": {:.3f}}}\n",
      drawn.width, drawn.height, stats.render.pixels, stats.render.fill_pixels,
      stats.render.varied_pixels, stats.render.edge_pixels, stats.render.resolved_pixels,
      stats.render.pieces, stats.render.crossings, stats.render.regions, stats.render.doubts,
      stats.render.roots, stats.render.distances, stats.render.steps, stats.render.memory,
      times.read, times.scene, times.picture, stats.draw, stats.encode, stats.render.root_seconds,
      stats.render.distance_seconds, stats.put,
      std::min(
          (stats.render.root_seconds + stats.render.distance_seconds) / std::max(stats.draw, 1e-9),
          1.0));
}

/// Prints to standard output, unless a picture goes there.
int print_stats(const std::string& text, const std::string& output) {
  if (output != "-") return print(text);
  std::fwrite(text.data(), 1, text.size(), stderr);
  return kDone;
}

/// The rows of a strip of about so many pixels: a multiple of the renderer's own strips.
int rows_of(int pixels, int width) {
  return std::max(pixels / width / 16, 1) * 16;
}

PictureFrame frame_of(const RenderPlan& plan, Depth depth, bool opaque) {
  const PixelRect rect = drawn_rect(plan.view);
  return {rect.width, rect.height, depth, opaque};
}

/// The part of the view that is a strip of what it shows.
View strip_of(const View& view, int y, int rows) {
  const PixelRect rect = drawn_rect(view);
  View strip = view;
  strip.region = PixelRect{rect.x, rect.y + y, rect.width, rows};
  return strip;
}

Expected<PictureStats> write_with_effects(const std::string& output, const RenderPlan& plan,
                                          const Scene& scene, const std::vector<Effect>& effects) {
  constexpr int kPixels = 1 << 22;
  const RenderOptions how{.depth = plan.picture.depth.value_or(Depth::u8),
                          .threads = plan.picture.write.threads,
                          .limits = plan.picture.limits};
  const bool opaque = plan.view.background.value_or(scene.background()).a >= 1.0;
  std::optional<EffectedRows> rows;
  auto stats = write_strips(
      {frame_of(plan, how.depth, opaque), EffectedRows::row_bytes(plan.view, how.depth),
       rows_of(kPixels, plan.view.width),
       [&](int, int count, const Progress& progress) {
         if (!rows) rows.emplace(scene, plan.view, how, effects, count);
         return rows->next(count, progress);
       }},
      output, plan.picture);
  if (stats) stats->render = rows->stats();
  return stats;
}

/// Only an interrupt ends it, and too much memory.
RenderOptions patient(const RenderPlan& plan, const Progress& progress) {
  return {.depth = plan.picture.depth.value_or(Depth::u8),
          .threads = plan.picture.write.threads,
          .progress = progress,
          .limits = {.steps = kWithoutLimits.steps, .memory = plan.picture.limits.memory}};
}

/// Writes a debug picture instead of the face's own.
Expected<PictureStats> write_debug(const std::string& output, const RenderPlan& plan,
                                   const Scene& scene) {
  const bool slow = *plan.debug == DebugPicture::distance || *plan.debug == DebugPicture::normals;
  const std::uint64_t pixel = 2 * 4;  // as it is made and as it waits
  return write_strips(
      {frame_of(plan, Depth::u8, true), pixel * std::uint64_t(drawn_rect(plan.view).width),
       slow ? 4 : rows_of(1 << 20, drawn_rect(plan.view).width),
       [&](int y, int rows, const Progress& progress) {
         return debug_picture(scene, strip_of(plan.view, y, rows), *plan.debug,
                              patient(plan, progress));
       }},
      output, plan.picture);
}

/// A cancelled picture's error, or another.
int complain_of(const Error& error) {
  return interrupted() ? complain("interrupted", kFailed) : complain(error, kFailed);
}

int draw_and_write(const RenderArguments& arguments, RenderPlan& plan, const Scene& scene,
                   const std::vector<Effect>& effects, Times times) {
  Expected<PictureStats> done = PictureStats{};
  {
    ProgressDisplay display;
    plan.picture.write.recipe = recipe(arguments, plan.view);
    plan.picture.write.progress = display.watch("render");
    const double began = monotonic_seconds();
    if (plan.debug)
      done = write_debug(arguments.output, plan, scene);
    else if (!effects.empty())
      done = write_with_effects(arguments.output, plan, scene, effects);
    else
      done = write_picture_by(load_encoder, scene, plan.view, arguments.output, plan.picture);
    times.picture = monotonic_seconds() - began;
  }
  if (!done) return complain_of(done.error());
  return plan.stats ? print_stats(stats_text(*done, drawn_rect(plan.view), times), arguments.output)
                    : kDone;
}

/// The bounds of the picture's errors as grey levels, in strips. White is the largest bound, so all strips
/// are looked through before the first is given, and computed a second time unless there is only one.
class ErrorStrips {
 public:
  ErrorStrips(const RenderPlan& plan, const Scene& scene)
      : plan_(plan), scene_(scene), height_(drawn_rect(plan.view).height) {}

  Expected<Image> at(int y, int rows, const Progress& progress) {
    for (int from = 0; y == 0 && from < height_; from += rows) {
      if (auto done = find(from, std::min(rows, height_ - from), progress); !done)
        return done.error();
      worst_ = std::max(worst_, map_.worst), estimated_ += map_.estimated_pixels();
    }
    if (auto done = find(y, rows, progress); !done) return done.error();
    map_.worst = worst_;
    return map_.image();
  }

  /// To be asked once all strips have been looked through.
  std::string verdict() const {
    const std::string light =
        estimated_ > 0
            ? fmt::format(
                  "; {} pixels are lit, or shaded along a distance: their means are not proven",
                  estimated_)
            : "";
    return fmt::format("no channel is off by more than {:.3f} of 255, rounding left out{}\n",
                       worst_, light);
  }

 private:
  Expected<Done> find(int y, int rows, const Progress& progress) {
    if (y == y_ && rows == map_.height) return Done{};
    auto found = error_map(scene_, strip_of(plan_.view, y, rows), patient(plan_, progress));
    if (!found) return found.error();
    map_ = *std::move(found), y_ = y;
    return Done{};
  }

  const RenderPlan& plan_;
  const Scene& scene_;
  const int height_;
  int y_ = -1;
  ErrorMap map_;
  long long estimated_ = 0;
  float worst_ = 0;
};

int write_error_map(const RenderArguments& arguments, const RenderPlan& plan, const Scene& scene) {
  constexpr int kPixels = 1 << 22;
  const auto width = drawn_rect(plan.view).width;
  // Per pixel: the picture's, which is passed on, then its bound, and the bound as grey, twice: being made
  // and waiting.
  const std::size_t pixel = 4 * bytes_per_channel(plan.picture.depth.value_or(Depth::u8)) + 3 * 4;
  ErrorStrips strips(plan, scene);
  Expected<PictureStats> done = PictureStats{};
  {
    ProgressDisplay display;
    PictureOptions how{.write = plan.error_map_write, .memory = plan.picture.memory};
    how.write.recipe = recipe(arguments, plan.view);
    how.write.progress = display.watch("error map");
    done = write_strips(
        {frame_of(plan, Depth::u8, true), pixel * std::uint64_t(width), rows_of(kPixels, width),
         [&](int y, int rows, const Progress& progress) { return strips.at(y, rows, progress); }},
        *plan.error_map, how);
  }
  if (!done) return complain_of(done.error());
  return print_stats(strips.verdict(), *plan.error_map == "-" ? *plan.error_map : arguments.output);
}

/// The scene of the face, or of how far its points have moved, which `said` tells then.
Expected<Scene> scene_to_draw(const RenderArguments& arguments, const Face& posed,
                              std::string& said) {
  if (arguments.debug != kMorphDebug) return scene_from_face(posed);
  const auto rest = read_face_or_code(arguments.posed.face, arguments.posed.style);
  if (!rest) return rest.error();
  const MorphHeat heat = morph_heat(*rest, posed, letters());
  if (arguments.output != "-")
    said = fmt::format("largest displacement {:.6g} {}\n", heat.largest, posed.model->canvas.unit);
  return heat.scene;
}

}  // namespace

int render_command(const RenderArguments& arguments) {
  if (asks_for_svg(arguments)) return render_svg(arguments);
  if (arguments.id_prefix)
    return complain(Error{"--id-prefix", "is for SVG files; pixels have no ids"}, kUsedWrongly);
  auto plan = plan_render(arguments);
  if (!plan) return complain(plan.error(), kUsedWrongly);
  Times times;
  double began = monotonic_seconds();
  const bool face_debug = arguments.debug && is_face_debug(*arguments.debug);
  const auto posed = read_posed_face(arguments.posed);
  if (!posed.face) return posed.code;
  times.read = monotonic_seconds() - began;

  began = monotonic_seconds();
  const auto over = face_debug ? read_scene(arguments.posed, arguments.debug) : SceneOrCode{};
  if (over.code != kDone) return over.code;
  std::string said;
  const auto drawn =
      over.scene ? Expected<Scene>(*over.scene) : scene_to_draw(arguments, *posed.face, said);
  if (!drawn) return complain(drawn.error(), kUsedWrongly);
  if (!said.empty())
    if (const int told = print(said); told != kDone) return told;
  const Scene& scene = *drawn;
  times.scene = monotonic_seconds() - began;
  if (auto planned = plan_view(*plan, arguments, scene.canvas()); !planned) {
    return complain(planned.error(), kUsedWrongly);
  }
  const auto effects = read_effects(arguments, *posed.face, plan->view.width);
  if (!effects) return complain(effects.error(), kUsedWrongly);
  watch_interrupts();
  int code = draw_and_write(arguments, *plan, scene, *effects, times);
  if (code == kDone && plan->error_map) code = write_error_map(arguments, *plan, scene);
  if (code != kDone && interrupted()) die_of_interrupt();
  return code;
}

}  // namespace mien::command
