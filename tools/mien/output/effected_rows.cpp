#include "tools/mien/output/effected_rows.h"

#include <algorithm>
#include <cstring>

namespace mien::command {

EffectedRows::EffectedRows(const Scene& scene, const View& view, const RenderOptions& how,
                           const std::vector<Effect>& effects, int strip)
    : scene_(scene),
      view_(view),
      how_(how),
      depth_(how.depth),
      strip_(strip),
      chain_(effects, view.width, view.height, [this](float* row) { return draw_row(row); }) {}

Expected<Image> EffectedRows::next(int rows, const Progress& progress) {
  how_.progress = progress;
  const PixelRect rect = drawn_rect(view_);
  row_.resize(4 * std::size_t(view_.width));
  for (; given_ < rect.y; ++given_)
    if (!chain_.next(row_.data())) return error_;
  Image strip{.width = rect.width, .height = rows, .depth = Depth::f32};
  strip.opaque = view_.background.value_or(scene_.background()).a >= 1.0;
  strip.bytes.resize(strip.stride() * std::size_t(rows));
  for (int y = 0; y < rows; ++y, ++given_) {
    if (!chain_.next(row_.data())) return error_;
    std::memcpy(strip.bytes.data() + strip.stride() * std::size_t(y),
                &row_[4 * std::size_t(rect.x)], strip.stride());
  }
  return at_depth(strip, depth_);
}

std::uint64_t EffectedRows::row_bytes(const View& view, Depth depth) {
  const auto pixel = [](Depth d) { return 4 * std::uint64_t(bytes_per_channel(d)); };
  return pixel(Depth::f32) * std::uint64_t(view.width) +
         (pixel(Depth::f32) + 2 * pixel(depth)) * std::uint64_t(drawn_rect(view).width);
}

bool EffectedRows::draw_row(float* row) {
  if (taken_ == drawn_ && !draw_strip()) return false;
  const std::size_t stride = 4 * std::size_t(view_.width);
  const int in_strip = int(drawn_rows_.size() / stride) - (drawn_ - taken_++);
  std::memcpy(row, &drawn_rows_[stride * std::size_t(in_strip)], stride * sizeof(float));
  return true;
}

bool EffectedRows::draw_strip() {
  const int rows = std::min(strip_, view_.height - drawn_);
  if (rows <= 0) return false;
  const std::size_t stride = 4 * std::size_t(view_.width);
  drawn_rows_.resize(stride * std::size_t(rows));
  View part = view_;
  part.region = PixelRect{0, drawn_, view_.width, rows};
  RenderStats took;
  if (const auto done = renderer_.render_into(
          {drawn_rows_.data(), stride * sizeof(float), Depth::f32}, scene_, part, how_, &took);
      !done) {
    error_ = done.error();
    return false;
  }
  stats_.add(took);
  drawn_ += rows;
  return true;
}

}  // namespace mien::command
