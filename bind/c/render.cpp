// Pictures: views, pixels, renderers and pieces.

#include <mien/renderer.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "bind/c/view_private.h"
#include "lib/base/one_line.h"
#include "lib/picture/color_text.h"
#include "render/render_error.h"

#include <exception>
#include <functional>
#include <mutex>

namespace mien::c {
namespace {

constexpr mien_view kView{.size = sizeof(mien_view),
                          .width = 512,
                          .height = 512,
                          .fit = MIEN_FIT_MEET,
                          .blend = MIEN_BLEND_LINEAR,
                          .dither = 1,
                          .background = {0, 0, 0, 1},
                          .light = {0, 0, 1}};
constexpr mien_pixels kPixels{.size = sizeof(mien_pixels), .depth = MIEN_U8};
constexpr mien_render_options kOptions{.size = sizeof(mien_render_options)};

int choice(int32_t value, int most, std::string_view argument) {
  if (value < 0 || value > most)
    misuse(argument, "is " + std::to_string(value) + ", not 0 to " + std::to_string(most));
  return value;
}

double share(double value, std::string_view argument) {
  if (!(value >= 0 && value <= 1)) refuse(std::string(argument), "expected a number from 0 to 1");
  return value;
}

/// A job that goes through a C program: what it throws is carried around that.
struct CarriedJob {
  const std::function<void(int)>& job;
  std::mutex mutex = {};
  std::exception_ptr thrown = {};

  static void run(int32_t index, void* data) noexcept {
    auto& carried = *static_cast<CarriedJob*>(data);
    try {
      carried.job(index);
    } catch (...) {
      const std::lock_guard lock(carried.mutex);
      carried.thrown = std::current_exception();
    }
  }
};

}  // namespace

void fail(const Error& error, bool cancelled) {
  throw Refusal{cancelled ? MIEN_CANCELLED : MIEN_REFUSED, error};
}

View view_of(const mien_view* given) {
  const mien_view v = whole_struct(given, kView, "view");
  View view{.width = v.width,
            .height = v.height,
            .fit = Fit(choice(v.fit, MIEN_FIT_SLICE, "view.fit")),
            .blend = Blend(choice(v.blend, MIEN_BLEND_SRGB, "view.blend"))};
  view.dither = v.dither != 0;
  if (!drawable(view)) throw Refusal{MIEN_REFUSED, invalid_size(view)};
  if (v.has_background)
    view.background =
        Color{share(v.background[0], "view.background"), share(v.background[1], "view.background"),
              share(v.background[2], "view.background"), share(v.background[3], "view.background")};
  if (v.has_region) view.region = PixelRect{v.region[0], v.region[1], v.region[2], v.region[3]};
  if (!(v.legible >= 0 && v.legible <= View::kMostLegible))
    refuse("view.legible", "expected a number from 0 to 16");
  view.legible = v.legible;
  if (v.has_light) {
    const glm::dvec3 to{need_finite(v.light[0], "view.light"),
                        need_finite(v.light[1], "view.light"),
                        need_finite(v.light[2], "view.light")};
    if (!(to.z > 0)) refuse("view.light", "expected z > 0: the lamp is before the face");
    view.light = to;
  }
  return view;
}

Depth depth_of(int32_t depth, std::string_view argument) {
  return Depth(choice(depth, MIEN_F32, argument));
}

PixelBuffer buffer_of(const mien_pixels* given, int width, int height) {
  const mien_pixels p = whole_struct(given, kPixels, "pixels");
  const Depth depth = depth_of(p.depth, "pixels.depth");
  const std::size_t channel = bytes_per_channel(depth), row = std::size_t(width) * 4 * channel;
  if (width < 1 || height < 1) refuse("view.region", "has no pixel in the picture");
  if (!p.data) misuse("pixels.data", "is NULL");
  if (reinterpret_cast<std::uintptr_t>(p.data) % channel || p.stride % channel)
    misuse("pixels", "data and stride are multiples of " + std::to_string(channel) + " bytes");
  if (p.stride < row)
    misuse("pixels.stride", "is " + std::to_string(p.stride) + ", and a row needs " +
                                std::to_string(row) + " bytes");
  if (p.bytes < row || (p.bytes - row) / p.stride < std::size_t(height) - 1)
    misuse("pixels.bytes",
           "is " + std::to_string(p.bytes) + ", too few for " + std::to_string(height) + " rows");
  return {p.data, p.stride, depth};
}

RenderOptions options_of(const mien_render_options* given) {
  if (!given) return {};
  const mien_render_options o = whole_struct(given, kOptions, "options");
  if (o.threads < 0) misuse("options.threads", "is " + std::to_string(o.threads));
  if (o.most_steps < 0) misuse("options.most_steps", "is " + std::to_string(o.most_steps));
  RenderOptions options{.threads = {.count = o.threads}};
  if (o.most_steps) options.limits.steps = o.most_steps;
  if (o.most_memory) options.limits.memory = o.most_memory;
  if (o.progress)
    options.progress = [=](double done) { return o.progress(done, o.progress_data) == 0; };
  if (o.executor)
    options.threads.executor = [=](int count, const std::function<void(int)>& job) {
      CarriedJob carried{job};
      o.executor(count, CarriedJob::run, &carried, o.executor_data);
      if (carried.thrown) std::rethrow_exception(carried.thrown);
    };
  return options;
}

}  // namespace mien::c

using namespace mien::c;

extern "C" {

void mien_view_init(mien_view* view, size_t size) {
  init_struct(view, size, kView);
}
void mien_pixels_init(mien_pixels* pixels, size_t size) {
  init_struct(pixels, size, kPixels);
}
void mien_render_options_init(mien_render_options* options, size_t size) {
  init_struct(options, size, kOptions);
}

mien_status mien_color_from_text(const char* text, size_t length, double color[4],
                                 mien_error** error) {
  return pass("mien_color_from_text", error, [&] {
    need(color, "color");
    const std::string_view said = text_of(text, length, "text");
    const auto c = mien::color_from_text(said);
    if (!c) refuse(mien::one_line(said, 60), "expected a colour like #rrggbb or #rrggbbaa");
    color[0] = c->r, color[1] = c->g, color[2] = c->b, color[3] = c->a;
  });
}

mien_status mien_renderer_new(mien_renderer** out, mien_error** error) {
  return pass("mien_renderer_new", error, [&] {
    mien_renderer*& made = place(out);
    made = new mien_renderer;
  });
}
void mien_renderer_free(mien_renderer* renderer) {
  delete renderer;
}

mien_status mien_drawn_rect(const mien_view* view, int32_t rect[4], mien_error** error) {
  return pass("mien_drawn_rect", error, [&] {
    need(rect, "rect");
    const mien::PixelRect drawn = mien::drawn_rect(view_of(view));
    rect[0] = drawn.x, rect[1] = drawn.y, rect[2] = drawn.width, rect[3] = drawn.height;
  });
}

mien_status mien_render(mien_renderer* renderer, const mien_scene* scene, const mien_view* view,
                        const mien_pixels* pixels, const mien_render_options* options,
                        mien_error** error) {
  return pass("mien_render", error, [&] {
    need(renderer, "renderer"), need(scene, "scene");
    const mien::View seen = view_of(view);
    const mien::PixelRect rect = mien::drawn_rect(seen);
    const mien::PixelBuffer buffer = buffer_of(pixels, rect.width, rect.height);
    const mien::RenderOptions how = options_of(options);
    mien::RenderStats& stats = renderer->last = {};
    const auto done = renderer->renderer.render_into(buffer, scene->scene, seen, how, &stats);
    if (!done) fail(done.error(), stats.cancelled);
  });
}

mien_status mien_renderer_stats(const mien_renderer* renderer, mien_render_stats* out,
                                mien_error** error) {
  return pass("mien_renderer_stats", error, [&] {
    const mien::RenderStats& s = need(renderer, "renderer").last;
    give_struct(out,
                mien_render_stats{0, s.cancelled, s.pixels, s.fill_pixels, s.varied_pixels,
                                  s.edge_pixels, s.resolved_pixels, s.recalled_pixels, s.pieces,
                                  s.crossings, s.regions, s.doubts, s.roots, s.distances,
                                  s.root_seconds, s.distance_seconds, s.steps, s.memory});
  });
}

mien_status mien_face_from_pixel(const mien_scene* scene, const mien_view* view, double x, double y,
                                 double out[2], mien_error** error) {
  return pass("mien_face_from_pixel", error, [&] {
    need(out, "out");
    const mien::View seen = view_of(view);
    const auto map = inverse(mien::pixel_from_face(need(scene, "scene").scene.canvas(), seen));
    const glm::dvec2 p =
        map({need_finite(x, "x") - 0.5 * seen.width, need_finite(y, "y") - 0.5 * seen.height});
    out[0] = p.x, out[1] = p.y;
  });
}

mien_status mien_pixel_from_face(const mien_scene* scene, const mien_view* view, double x, double y,
                                 double out[2], mien_error** error) {
  return pass("mien_pixel_from_face", error, [&] {
    need(out, "out");
    const mien::View seen = view_of(view);
    const auto map = mien::pixel_from_face(need(scene, "scene").scene.canvas(), seen);
    const glm::dvec2 p = map({need_finite(x, "x"), need_finite(y, "y")});
    out[0] = p.x + 0.5 * seen.width, out[1] = p.y + 0.5 * seen.height;
  });
}

mien_status mien_pieces_new(const mien_scene* scene, const mien_view* view, int32_t depth,
                            const mien_render_options* options, mien_pieces** out,
                            mien_error** error) {
  return pass("mien_pieces_new", error, [&] {
    mien_pieces*& made = place(out);
    const mien::View seen = view_of(view);
    const mien::Depth drawn = depth_of(depth, "depth");
    const mien::RenderOptions how = options_of(options);
    bool cancelled = false;
    std::function<bool()> stop;
    if (how.progress) stop = [&] { return cancelled = !how.progress(0.0); };
    auto drawer = mien::PieceDrawer::of(need(scene, "scene").scene, seen, drawn, how.limits, stop);
    if (!drawer) fail(drawer.error(), cancelled);
    made = new mien_pieces{*std::move(drawer), {0, 0, seen.width, seen.height}, drawn};
  });
}
void mien_pieces_free(mien_pieces* pieces) {
  delete pieces;
}

mien_status mien_pieces_draw(mien_pieces* pieces, const int32_t piece[4], const mien_pixels* pixels,
                             int32_t (*stop)(void* data), void* data, mien_error** error) {
  return pass("mien_pieces_draw", error, [&] {
    need(pieces, "pieces"), need(piece, "piece");
    const mien::PixelRect rect{piece[0], piece[1], piece[2], piece[3]}, whole = pieces->whole;
    if (rect.x < 0 || rect.y < 0 || rect.width < 1 || rect.height < 1 ||
        rect.x > whole.width - rect.width || rect.y > whole.height - rect.height)
      refuse("piece", "is not in the picture");
    const mien::PixelBuffer buffer = buffer_of(pixels, rect.width, rect.height);
    if (buffer.depth != pieces->depth) misuse("pixels.depth", "is not that of the pieces");
    std::function<bool()> asked;
    if (stop) asked = [&] { return stop(data) != 0; };
    mien::RenderStats stats;
    const auto done = pieces->drawer.draw(buffer, rect, asked, &stats);
    if (!done) fail(done.error(), stats.cancelled);
  });
}
}
