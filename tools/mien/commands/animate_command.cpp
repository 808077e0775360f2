// mien animate: many moments of a face, as numbered pictures or as a film.
//
// Frames are drawn in parallel, one thread each, and each depends on its own moment alone: any number of
// threads gives the same pictures. Numbered pictures that an earlier run finished are kept.

#include <mien/face_model.h>
#include <mien/motion_length.h>
#include <mien/parallel.h>
#include <mien/scene_from_face.h>
#include "lib/base/monotonic_seconds.h"
#include "lib/base/one_line.h"
#include "render/image/file_type.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/film/film.h"
#include "tools/mien/film/finished_frame.h"
#include "tools/mien/film/frame_names.h"
#include "tools/mien/film/wave_file.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/recipe.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/progress_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

namespace mien::command {
namespace {

constexpr std::uint64_t kMostWaiting = std::uint64_t(512) << 20;  // bytes of frames at once

/// All that a frame needs, shared by all.
struct Animation {
  RenderArguments arguments;  // without a time
  RenderPlan plan;
  Face face;
  Pose pose;
  std::vector<Effect> effects;
  FrameRange range;
  double fps = 30;
  int threads = 1;
  std::optional<FilmSound> sound;
  DrawnFrame drawn;  // where frames come from that are there already

  double time_of(long frame) const { return double(frame) / fps; }
  Scene scene_of(long frame) const {
    Pose at = pose;
    at.time = time_of(frame);
    return scene_from_face(pose_face(face, at));
  }
  Expected<Image> picture_of(const Scene& scene) const {
    const RenderOptions how{.depth = plan.picture.depth.value_or(Depth::u8), .threads = {1, {}}};
    return drawn_picture(scene, plan.view, how, effects);
  }
};

/// FNV-1a.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

/// What made a frame, down to every number in it.
std::string frame_recipe(const Animation& animation, long frame, const Scene& scene) {
  RenderArguments arguments = animation.arguments;
  arguments.posed.time = fmt::format("{}", animation.time_of(frame));
  std::string text = recipe(arguments, animation.plan.view);
  text.pop_back();
  return text + fmt::format(R"(, "depth": {}, "scene": "{:016x}"}})",
                            int(animation.plan.picture.depth.value_or(Depth::u8)),
                            hash_of(scene.text()));
}

int as_pictures(const Animation& animation, const FrameNames& names, bool again,
                ProgressDisplay& display) {
  const Progress progress = display.watch("frames");
  std::mutex mutex;
  std::optional<Error> wrong;
  long done = 0, kept = 0;
  std::atomic<bool> stop = false;
  parallel_for(int(animation.range.count()), {.count = animation.threads}, [&](int i) {
    if (stop) return;
    const long frame = animation.range.first + i;
    const std::string path = names.of(frame);
    const Scene scene = animation.scene_of(frame);
    WriteOptions write = animation.plan.picture.write;
    write.threads.count = 1;
    write.recipe = frame_recipe(animation, frame, scene);
    const bool finished = !again && is_finished_frame(path, write.recipe);
    Expected<Done> written = Done{};
    if (!finished) {
      const auto picture = animation.picture_of(scene);
      written = picture ? write_image_by(load_encoder, *picture, path, write)
                        : Error{path, picture.error().what};
    }
    const std::lock_guard lock(mutex);
    if (!written && !wrong) wrong = written.error();
    if (!written) stop = true;
    kept += finished;
    if (!progress(double(++done) / double(animation.range.count()))) stop = true;
  });
  if (wrong) return complain(*wrong, kFailed);
  if (interrupted()) return complain("interrupted", kFailed);
  return print(fmt::format("{} frames drawn, {} kept\n", done - kept, kept));
}

/// Draws as many frames together as may wait, and adds them in their order.
int draw_film(const FilmPlan& plan, const std::string& output, FilmWriter& film,
              ProgressDisplay& display, double began) {
  const Progress progress = display.watch("frames");
  const std::uint64_t bytes = std::uint64_t(plan.width) * std::uint64_t(plan.height) * 4;
  const long together = std::clamp<long>(long(kMostWaiting / bytes), 1, 2L * plan.threads);
  double drawing = 0;
  std::vector<Expected<Image>> pictures;
  for (long first = 0; first < plan.frames; first += together) {
    pictures.assign(std::size_t(std::min(together, plan.frames - first)), Image{});
    const double start = monotonic_seconds();
    parallel_for(int(pictures.size()), {.count = plan.threads},
                 [&](int i) { pictures[std::size_t(i)] = plan.draw(first + i); });
    drawing += monotonic_seconds() - start;
    for (const auto& picture : pictures) {
      if (!picture) return complain({output, picture.error().what}, kFailed);
      if (const auto added = film.add(*picture); !added) return complain(added.error(), kFailed);
    }
    if (!progress(double(first + long(pictures.size())) / double(plan.frames)))
      return complain("interrupted", kFailed);
  }
  if (const auto finished = film.finish(); !finished) return complain(finished.error(), kFailed);
  const double whole = monotonic_seconds() - began;
  return print(fmt::format("{} frames in {:.1f} s, {:.0f} % of it drawing\n", plan.frames, whole,
                           100 * drawing / whole));
}

int as_film(const Animation& animation, FilmType type, ProgressDisplay& display) {
  const auto& output = animation.arguments.output;
  const double began = monotonic_seconds();
  const PixelRect drawn = drawn_rect(animation.plan.view);
  const bool transparent = animation.plan.view.background
                               ? animation.plan.view.background->a < 1
                               : animation.scene_of(animation.range.first).background().a < 1;
  if (transparent && !holds_transparency(type))
    return complain(
        Error{output,
              "mp4 holds no transparency: take .webm, .webp, .apng or .gif, or --background"},
        kUsedWrongly);
  if (animation.sound && !holds_sound(type))
    return complain(Error{output, "holds no sound: take .mp4 or .webm"}, kUsedWrongly);
  const FilmPlan plan{.type = type,
                      .width = drawn.width,
                      .height = drawn.height,
                      .fps = animation.fps,
                      .transparent = transparent,
                      .sound = animation.sound,
                      .frames = animation.range.count(),
                      .threads = animation.threads,
                      .draw = [&](long frame) {
                        const long at = animation.range.first + frame;
                        return animation.drawn ? animation.drawn(at)
                                               : animation.picture_of(animation.scene_of(at));
                      }};
  const auto begun = begin_film(output, plan);
  if (interrupted()) return complain("interrupted", kFailed);
  if (!begun) return complain(begun.error(), kFailed);
  return draw_film(plan, output, **begun, display, began);
}

/// [s] How long what is played lasts: the longest of motions that end.
double length_of(const Animation& animation) {
  double longest = 0;
  const FaceModel& model = *animation.face.model;
  for (const MotionLayer& layer : animation.pose.motions)
    if (!layer.clip && layer.motion)
      longest = std::max(longest, layer.begin + motion_length(*layer.motion));
    else if (const double length = motion_length(layer.clip.in(model.clips)); std::isfinite(length))
      longest = std::max(longest, layer.begin + length);
  return longest;
}

/// The frames asked for, or all that the motions and the sound last.
int plan_frames(const AnimateArguments& arguments, Animation& animation) {
  double sound = 0;
  if (arguments.sound) {
    const auto seconds = wave_seconds(*arguments.sound);
    if (!seconds) return complain(seconds.error(), kFailed);
    sound = seconds->value_or(0);
  }
  if (arguments.frames) {
    const auto range = read_frames(*arguments.frames);
    if (!range) return complain(range.error(), kUsedWrongly);
    animation.range = *range;
  } else {
    const double seconds = std::max(length_of(animation), sound);
    const auto last =
        read_frames(fmt::format("0-{:.0f}", std::max(std::ceil(seconds * animation.fps) - 1, 0.0)));
    if (!last) return complain(last.error(), kUsedWrongly);
    animation.range = *last;
  }
  if (arguments.sound)
    animation.sound = {*arguments.sound, animation.time_of(animation.range.first),
                       double(animation.range.count()) / animation.fps};
  return kDone;
}

/// Checks everything that can be checked before drawing.
int plan_animation(const AnimateArguments& arguments, Animation& animation) {
  auto plan = plan_frame(arguments.render);
  if (!plan) return complain(plan.error(), kUsedWrongly);
  const PosedFace& asked_for = arguments.render.posed;
  if (!arguments.frames && !asked_for.motion && !asked_for.speech && !arguments.sound)
    return complain("animate: --frames is needed: --frames 0-239", kUsedWrongly);
  const auto fps = read_fps(arguments.fps.value_or("30"));
  if (!fps) return complain(fps.error(), kUsedWrongly);
  if (arguments.render.posed.time)
    return complain("animate: --time is for one picture: say --frames and --fps", kUsedWrongly);
  animation.fps = *fps;
  animation.arguments = arguments.render;
  PosedFace posed = arguments.render.posed;
  posed.time = std::string(1, '0');  // a moment: clips run
  auto read = read_face_and_pose(posed);
  if (!read.face) return read.code;
  animation.face = *std::move(read.face);
  animation.pose = std::move(read.pose);
  if (const int code = plan_frames(arguments, animation); code != kDone) return code;
  const Scene first = animation.scene_of(animation.range.first);
  if (auto planned = plan_view(*plan, arguments.render, first.canvas()); !planned)
    return complain(planned.error(), kUsedWrongly);
  auto effects = read_effects(arguments.render, animation.face, plan->view.width);
  if (!effects) return complain(effects.error(), kUsedWrongly);
  animation.effects = *std::move(effects);
  const int asked = plan->picture.write.threads.count;
  animation.threads = asked > 0 ? asked : int(std::max(1u, std::thread::hardware_concurrency()));
  animation.plan = *std::move(plan);
  return kDone;
}

}  // namespace

int animate_command(const AnimateArguments& arguments, const DrawnFrame& drawn) {
  const std::string& output = arguments.render.output;
  const auto names = read_frame_names(output);
  if (!names) return complain(names.error(), kUsedWrongly);
  const auto film = lower_extension(output) == ".png" ? FilmType::apng : film_type(output);
  if (!*names && !film)
    return complain(Error{fmt::format("-o {}", output),
                          "expected numbered pictures like frames/%05d.png, or a film: .mp4 .webm "
                          ".webp .apng .gif"},
                    kUsedWrongly);
  if (!*names && arguments.render.depth.value_or("8") != "8")
    return complain(Error{"--depth " + one_line(*arguments.render.depth, 60), "films hold 8 bits"},
                    kUsedWrongly);
  if (*names && arguments.sound)
    return complain(Error{"--sound", "numbered pictures hold no sound: take a film, .mp4 or .webm"},
                    kUsedWrongly);
  Animation animation;
  animation.drawn = drawn;
  if (*names) {
    const auto type = file_type((*names)->of(0));
    if (!type) return complain(type.error(), kUsedWrongly);
    animation.plan.picture.write.type = *type;
  }
  const auto write = animation.plan.picture.write;
  if (const int code = plan_animation(arguments, animation); code != kDone) return code;
  animation.plan.picture.write.type = write.type;
  watch_interrupts();
  int code = kDone;
  {
    ProgressDisplay display;
    code = *names ? as_pictures(animation, **names, arguments.again, display)
                  : as_film(animation, *film, display);
  }
  if (code != kDone && interrupted()) die_of_interrupt();
  return code;
}

}  // namespace mien::command
