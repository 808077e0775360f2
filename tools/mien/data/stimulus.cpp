#include "tools/mien/data/stimulus.h"
#include <mien/composed_face.h>
#include <mien/face_model.h>
#include <mien/pose.h>
#include <mien/scene_from_face.h>
#include "lib/file/json/json_text.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mien::command {
namespace {

constexpr std::size_t kPixel = 4;  // bytes

void mirror_row(std::byte* row, int width) {
  for (int a = 0, b = width - 1; a < b; ++a, --b)
    std::swap_ranges(row + kPixel * std::size_t(a), row + kPixel * std::size_t(a + 1),
                     row + kPixel * std::size_t(b));
}

/// Makes one half of a row the image of the other.
void double_half(std::byte* row, int width, bool left) {
  for (int a = 0, b = width - 1; a < b; ++a, --b)
    std::memcpy(row + kPixel * std::size_t(left ? b : a), row + kPixel * std::size_t(left ? a : b),
                kPixel);
}

}  // namespace

Expected<Face> composed_stimulus(const Stimulus& stimulus) {
  return face_from_recipe(stimulus.recipe, face_letters());
}

Expected<Face> posed_stimulus(const Face& composed, const Stimulus& stimulus) {
  Pose pose;
  for (const auto& [name, value] : stimulus.controls) {
    const auto setting = read_setting(composed, name + "=" + json_number(value));
    if (!setting) return setting.error();
    pose.settings.push_back(*setting);
  }
  return pose_face(composed, pose);
}

Expected<Image> stimulus_picture(const Face& posed, StimulusPicture picture, int size) {
  const Scene scene = scene_from_face(posed);
  const glm::dvec2 extent = scene.canvas().box.size();
  const auto pixels = read_size(std::to_string(size), extent.x / extent.y);
  if (!pixels) return pixels.error();
  Image image = sheet_picture(scene, {.width = pixels->width, .height = pixels->height});
  if (picture == StimulusPicture::whole) return image;
  for (int y = 0; y < image.height; ++y) {
    std::byte* row = image.bytes.data() + image.stride() * std::size_t(y);
    if (picture == StimulusPicture::mirror)
      mirror_row(row, image.width);
    else
      double_half(row, image.width, picture == StimulusPicture::left);
  }
  return image;
}

double displacement(const Face& one, const Face& other) {
  double sum = 0;
  int points = 0;
  for (const Slice& slice : one.model->layout.slices()) {
    if (slice.kind != SliceKind::point) continue;
    const int found = other.model->layout.find(slice.name);
    if (found < 0) continue;
    const std::size_t a = std::size_t(slice.begin),
                      b = std::size_t(other.model->layout[found].begin);
    const double x = one.vector[a] - other.vector[b], y = one.vector[a + 1] - other.vector[b + 1];
    sum += x * x + y * y;
    ++points;
  }
  return points > 0 ? std::sqrt(sum / points) : 0;
}

}  // namespace mien::command
