#include "tools/mien/output/drawn_picture.h"
#include <mien/effect_chain.h>
#include <mien/face_model.h>
#include "lib/base/watch.h"
#include "render/render_error.h"
#include "tools/mien/output/effected_rows.h"
#include "tools/mien/terminal/interrupt.h"

#include <fmt/format.h>

#include <new>

namespace mien::command {
namespace {

/// What an interrupt ended is no error of the picture's: the command's main function tells it.
void end_if_interrupted() {
  if (interrupted()) throw Stopped{Stopped::Why::cancelled};
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
  return acting_effects(effects, width);
}

Image sheet_picture(const Scene& scene, const View& view) {
  auto image = render(scene, view);
  end_if_interrupted();
  if (!image) throw std::bad_alloc();
  return *std::move(image);
}

Expected<Image> drawn_picture(const Scene& scene, const View& view, const RenderOptions& how,
                              const std::vector<Effect>& effects) {
  if (effects.empty()) {
    auto image = render(scene, view, how);
    end_if_interrupted();
    return image;
  }
  const PixelRect rect = drawn_rect(view);
  try {
    constexpr int kStrip = 16;  // rows
    auto image = EffectedRows(scene, view, how, effects, kStrip).next(rect.height, {});
    end_if_interrupted();
    return image;
  } catch (const std::bad_alloc&) {
    return out_of_memory(rect);
  }
}

}  // namespace mien::command
