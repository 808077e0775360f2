#include <mien/lib/face/face_model.h>
#include <mien/render/effect/effect_chain.h>
#include <mien/tools/mien/drawn_picture.h>

#include <cstring>

namespace mien::command {
namespace {

Image cut_out(const Image& image, const PixelRect& part) {
  Image out{
      .width = part.width, .height = part.height, .depth = image.depth, .opaque = image.opaque};
  out.bytes.resize(out.stride() * std::size_t(out.height));
  const std::size_t skip = 4 * bytes_per_channel(image.depth) * std::size_t(part.x);
  for (int y = 0; y < part.height; ++y)
    std::memcpy(out.bytes.data() + out.stride() * std::size_t(y), image.row(part.y + y) + skip,
                out.stride());
  return out;
}

}  // namespace

Expected<std::vector<Effect>> read_effects(const RenderArguments& arguments, const Face& face,
                                           int width) {
  std::vector<Effect> effects;
  if (arguments.effects.empty()) {
    effects = face.model->effects;
  } else if (arguments.effects != std::vector<std::string>{"none"}) {
    for (const std::string& text : arguments.effects) {
      const auto effect = read_effect(text);
      if (!effect) return Error{"--effect " + effect.error().where, effect.error().what};
      effects.push_back(*effect);
    }
  }
  for (const Effect& effect : effects)
    if (const auto fits = check_effect(effect, width); !fits)
      return Error{arguments.effects.empty() ? arguments.posed.face : "--effect",
                   fits.error().what};
  return effects;
}

Image drawn_picture(const Scene& scene, const View& view, const RenderOptions& how,
                    const std::vector<Effect>& effects, RenderStats* stats) {
  if (effects.empty()) return render(scene, view, how, stats);
  View whole = view;
  whole.region.reset();
  RenderOptions light = how;
  light.depth = Depth::f32;
  const Image image = with_effects(render(scene, whole, light, stats), effects);
  return at_depth(view.region ? cut_out(image, drawn_rect(view)) : image, how.depth);
}

}  // namespace mien::command
