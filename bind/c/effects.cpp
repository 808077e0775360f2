// Effects on finished pictures.

#include <mien/effect_chain.h>
#include <mien/face_model.h>
#include <mien/renderer.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "bind/c/view_private.h"

#include <algorithm>
#include <cstring>

namespace mien::c {
namespace {

void check_possible(const std::vector<Effect>& effects, int width) {
  for (const Effect& effect : effects) must(check_effect(effect, width), MIEN_REFUSED);
}

std::byte* row_of(const PixelBuffer& buffer, int y) {
  return static_cast<std::byte*>(buffer.data) + buffer.stride * std::size_t(y);
}

/// A row of linear floats, from its pixel `first` on, into a row of the buffer.
void put_row(const float* row, int first, int width, const PixelBuffer& buffer, int y) {
  Image one{.width = width, .height = 1, .depth = Depth::f32};
  one.bytes.resize(one.stride());
  std::memcpy(one.bytes.data(), row + 4 * std::size_t(first), one.stride());
  const Image rounded = at_depth(one, buffer.depth);
  std::memcpy(row_of(buffer, y), rounded.bytes.data(), rounded.stride());
}

/// The rows of a picture of linear floats, from the top, drawn in strips.
class DrawnRows {
 public:
  DrawnRows(mien_renderer& renderer, const Scene& scene, View view, RenderOptions how, int last)
      : renderer_(renderer), scene_(scene), view_(view), how_(std::move(how)), last_(last) {
    const std::size_t row = 16 * std::size_t(view.width);
    strip_ = int(std::clamp<std::size_t>((std::size_t(16) << 20) / row, 16, 1024));
    if (how_.progress)
      how_.progress = [this, asked = how_.progress](double done) {
        return asked(std::min(1.0, (drawn_ + done * rows_) / last_));
      };
  }

  bool next(float* row) {
    const std::size_t numbers = 4 * std::size_t(view_.width);
    if (given_ == view_.height) return false;
    if (given_ == drawn_) draw();
    const std::size_t in_strip = std::size_t(given_++ - (drawn_ - rows_));
    std::memcpy(row, &pixels_[numbers * in_strip], numbers * sizeof(float));
    return true;
  }

 private:
  void draw() {
    rows_ = std::min(strip_, view_.height - drawn_);
    const std::size_t numbers = 4 * std::size_t(view_.width);
    pixels_.resize(numbers * std::size_t(rows_));
    view_.region = PixelRect{0, drawn_, view_.width, rows_};
    const PixelBuffer buffer{pixels_.data(), numbers * sizeof(float), Depth::f32};
    RenderStats took;
    const auto done = renderer_.renderer.render_into(buffer, scene_, view_, how_, &took);
    renderer_.last.add(took);
    if (!done) fail(done.error(), took.cancelled);
    drawn_ += rows_;
  }

  mien_renderer& renderer_;
  const Scene& scene_;
  View view_;
  RenderOptions how_;
  int last_, strip_ = 0;
  int drawn_ = 0, given_ = 0, rows_ = 0;  ///< rows; of the strip that is held
  std::vector<float> pixels_;
};

}  // namespace
}  // namespace mien::c

using namespace mien::c;

extern "C" {

mien_status mien_effects_new(mien_effects** out, mien_error** error) {
  return pass("mien_effects_new", error, [&] {
    mien_effects*& made = place(out);
    made = new mien_effects;
  });
}

mien_status mien_effects_of_face(const mien_face* face, mien_effects** out, mien_error** error) {
  return pass("mien_effects_of_face", error, [&] {
    mien_effects*& made = place(out);
    made = new mien_effects{need(face, "face").face.model->effects};
  });
}

void mien_effects_free(mien_effects* effects) {
  delete effects;
}

mien_status mien_effects_add(mien_effects* effects, const char* text, size_t length,
                             mien_error** error) {
  return pass("mien_effects_add", error, [&] {
    auto& all = need(effects, "effects").all;
    all.push_back(must(mien::read_effect(text_of(text, length, "text")), MIEN_REFUSED));
  });
}

int32_t mien_effects_count(const mien_effects* effects) {
  return effects ? int32_t(effects->all.size()) : 0;
}

mien_status mien_render_with_effects(mien_renderer* renderer, const mien_scene* scene,
                                     const mien_view* view, const mien_effects* effects,
                                     const mien_pixels* pixels, const mien_render_options* options,
                                     mien_error** error) {
  return pass("mien_render_with_effects", error, [&] {
    need(renderer, "renderer"), need(scene, "scene");
    const auto& asked = need(effects, "effects").all;
    const mien::View seen = view_of(view);
    const mien::PixelRect rect = mien::drawn_rect(seen);
    const mien::PixelBuffer buffer = buffer_of(pixels, rect.width, rect.height);
    check_possible(asked, seen.width);
    const auto all = mien::acting_effects(asked, seen.width);
    mien::RenderStats& stats = renderer->last = {};
    if (all.empty()) {
      const auto done =
          renderer->renderer.render_into(buffer, scene->scene, seen, options_of(options), &stats);
      if (!done) fail(done.error(), stats.cancelled);
      return;
    }
    DrawnRows rows(*renderer, scene->scene, seen, options_of(options), rect.y + rect.height);
    mien::EffectChain chain(all, seen.width, seen.height,
                            [&](float* row) { return rows.next(row); });
    std::vector<float> row(4 * std::size_t(seen.width));
    for (int y = 0; y < rect.y + rect.height; ++y) {
      chain.next(row.data());
      if (y >= rect.y) put_row(row.data(), rect.x, rect.width, buffer, y - rect.y);
    }
  });
}

mien_status mien_apply_effects(const mien_effects* effects, const mien_pixels* from,
                               const mien_pixels* to, int32_t width, int32_t height,
                               mien_error** error) {
  return pass("mien_apply_effects", error, [&] {
    const auto& all = need(effects, "effects").all;
    if (width < 1 || height < 1 || std::max(width, height) > mien::View::kMaxSide)
      refuse("width and height", "a picture's sides are 1 to 1048576 pixels");
    const mien::PixelBuffer in = buffer_of(from, width, height);
    const mien::PixelBuffer out = buffer_of(to, width, height);
    if (in.depth != mien::Depth::f32) misuse("from.depth", "is not MIEN_F32");
    if (in.data == out.data) misuse("to", "is `from`");
    check_possible(all, width);
    int read = 0;
    mien::EffectChain chain(all, width, height, [&](float* row) {
      if (read == height) return false;
      std::memcpy(row, row_of(in, read++), 16 * std::size_t(width));
      return true;
    });
    std::vector<float> row(4 * std::size_t(width));
    for (int y = 0; y < height; ++y) chain.next(row.data()), put_row(row.data(), 0, width, out, y);
  });
}
}
