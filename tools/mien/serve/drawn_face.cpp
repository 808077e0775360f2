#include "tools/mien/serve/drawn_face.h"
#include <mien/pose.h>
#include <mien/scene_from_face.h>
#include <mien/svg.h>
#include "lib/base/one_line.h"
#include "lib/base/watch.h"
#include "render/image/png/png_bytes.h"
#include "render/render_error.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/commands/render_plan.h"
#include "tools/mien/commands/render_svg.h"
#include "tools/mien/film/webp_still.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace mien::command {
namespace {

DrawnFace drawn(std::string bytes) {
  return {kOk, std::make_shared<const std::string>(std::move(bytes))};
}

DrawnFace refused(int code, const Error& error) {
  return {code, std::make_shared<const std::string>(
                    one_line(sentence(in_request_words(error)), 500) + "\n")};
}

/// The whole size, where the request has the sides apart. One alone has the canvas's other.
Expected<Done> join_sides(FaceRequest& request, const Canvas& canvas, int most) {
  if (!request.width && !request.height) return Done{};
  int side[2] = {0, 0};
  for (const auto& [key, text, i] :
       {std::tuple{"width", &request.width, 0}, {"height", &request.height, 1}})
    if (*text) {
      const auto read = read_side(key, **text, most);
      if (!read) return read.error();
      side[i] = *read;
    }
  const double aspect = canvas.box.size().x / canvas.box.size().y;
  if (side[0] == 0) side[0] = int(std::lround(side[1] * aspect));
  if (side[1] == 0) side[1] = int(std::lround(side[0] / aspect));
  for (int& one : side) one = std::clamp(one, 1, most);
  request.arguments.size = fmt::format("{}x{}", side[0], side[1]);
  return Done{};
}

class FaceDrawing {
 public:
  FaceDrawing(FaceRequest request, const RequestLimits& limits)
      : request_(std::move(request)), most_side_(limits.most_side) {}

  DrawnFace draw() {
    RenderArguments& asked = request_.arguments;
    const bool svg = request_.format == FaceFormat::svg;
    if (auto fits = check_format(); !fits) return refused(kWrong, fits.error());
    asked.output = "face.png";  // its kind alone counts
    auto plan = svg ? plan_frame(asked) : plan_render(asked);
    if (!plan) return refused(kWrong, plan.error());
    plan->picture.write.threads = {.count = 1};
    const auto code = read_face_code(asked.posed.face);
    const auto recipe = code ? recipe_from_code(*code) : Expected<Recipe>(code.error());
    if (!recipe) return refused(kNotFound, recipe.error());
    const auto face = face_of_recipe(*recipe, asked.posed.style, asked.posed.neutral);
    if (!face) return refused(kWrong, face.error());
    const auto pose = read_pose_options(*face, asked.posed);
    if (!pose) return refused(kWrong, pose.error());
    const Face posed = pose_face(*face, *pose);
    const Scene scene = scene_from_face(posed);
    if (auto joined = join_sides(request_, scene.canvas(), most_side_); !joined)
      return refused(kWrong, joined.error());
    if (auto planned = plan_view(*plan, asked, scene.canvas()); !planned)
      return refused(kWrong, planned.error());
    return svg ? drawn_shapes(*plan, scene) : drawn_pixels(*plan, posed, scene);
  }

 private:
  /// An error about an option that the format has no place for.
  Expected<Done> check_format() const {
    const RenderArguments& asked = request_.arguments;
    if (request_.format == FaceFormat::svg) return check_svg_options(asked);
    if (asked.id_prefix) return Error{"id-prefix", "is for SVG files; pixels have no ids"};
    if (request_.format == FaceFormat::webp && asked.depth.value_or("8") != "8")
      return Error{"depth=" + one_line(*asked.depth, 60), "WebP holds 8"};
    return Done{};
  }

  DrawnFace drawn_shapes(const RenderPlan& plan, const Scene& scene) {
    auto svg = svg_text(scene, svg_options(request_.arguments, plan, {}));
    return svg ? drawn(std::move(svg->text)) : failed(svg.error());
  }

  DrawnFace drawn_pixels(const RenderPlan& plan, const Face& posed, const Scene& scene) {
    const RenderArguments& asked = request_.arguments;
    const auto effects = read_effects(asked, posed, plan.view.width);
    if (!effects) return refused(kWrong, effects.error());
    const RenderOptions how{.depth = plan.picture.depth.value_or(Depth::u8),
                            .threads = plan.picture.write.threads,
                            .limits = plan.picture.limits};
    auto image = drawn_picture(scene, plan.view, how, *effects);
    if (!image) return failed(image.error());
    image->opaque = plan.view.background.value_or(scene.background()).a >= 1.0;
    if (request_.format == FaceFormat::webp) {
      auto webp = webp_still(*image);
      return webp ? drawn(*std::move(webp)) : refused(kBroken, webp.error());
    }
    const auto png =
        png_bytes(*image, {.dpi = plan.picture.write.dpi, .recipe = recipe(asked, plan.view)});
    return drawn({reinterpret_cast<const char*>(png.data()), png.size()});
  }

  static DrawnFace failed(const Error& error) {
    if (error.what == kCancelled) throw Stopped{Stopped::Why::cancelled};
    return refused(kWrong, error);
  }

  FaceRequest request_;
  const int most_side_;
};

}  // namespace

DrawnFace drawn_face(const FaceRequest& request, const RequestLimits& limits,
                     const std::function<bool()>& go_on, std::string_view late) {
  Watch watch(go_on, kWithoutLimits);
  try {
    const Watching here(&watch);
    return FaceDrawing(request, limits).draw();
  } catch (const Stopped&) {
    return refused(kUnavailable, {"", std::string(late)});
  } catch (const std::bad_alloc&) {
    return refused(kUnavailable, {"", "there is not enough memory for it now"});
  } catch (const std::exception& failure) {
    return refused(kBroken, {"", failure.what()});
  }
}

}  // namespace mien::command
