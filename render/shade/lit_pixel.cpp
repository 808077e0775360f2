#include <mien/render/shade/lit_pixel.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// What the mean by so many cells may be off by, from what its colours do. Seen of kinks, steep outlines and smooth
/// bends: a tenth of how far colours are from a plane with 4 × 4 cells, a quarter of that with twice as many. A ridge
/// is cut in closed form: its own jump does not count, but where it meets another or an outline in a cell.
float error_of(const LitMean& mean, int side) {
  const float finer = float(side * side) / 16;
  const float rough = std::max(mean.rough - 0.3f * mean.jump, 0.0f);
  return 0.1f * rough / finer + 0.15f * mean.unsure;
}

constexpr float kMostTurn = 0.25f;  // of the gradient within a cell

}  // namespace

void LitPixel::find_feet(NearFeet& feet) {
  const std::size_t count = std::size_t((cells_.places() + 15) / 16 * 16);
  feet.at(std::span(cells_.mid_x).first(count), std::span(cells_.mid_y).first(count),
          {cells_.d.data(), cells_.nx.data(), cells_.ny.data(), cells_.bend.data()});
}

void LitPixel::see(const Place& place, const PartForm* form, int side) {
  if (form)
    cells_of_form(*form, side, parts_);
  else
    whole_cells(side, parts_);
  cells_.x = place.at.x, cells_.y = place.at.y;
  cells_.shallow = place.shallow, cells_.deep = place.deep;
  cells_.foot = place.foot;
  cells_.take(parts_, !place.calm);
  if (!place.calm) find_feet(*place.feet);
}

glm::vec3 LitPixel::mean(const Place& place, const PartForm* form) {
  int side = 4;
  LitMean mean;
  for (;;) {
    see(place, form, side);
    mean = mean_of_cells(*place.lamp, cells_);
    if (side == PartCells::kMostSide) break;
    const float error = error_of(mean, side), turn = mean.turn;
    if (error <= place.tolerance && turn <= kMostTurn) break;
    const bool much = error > 4 * place.tolerance || turn > 2 * kMostTurn;
    side = much ? PartCells::kMostSide : 2 * side;
  }
  return {mean.r, mean.g, mean.b};
}

float LitPixel::distance(const Place& place, const PartForm* form) {
  see(place, form, 4);
  float sum = 0.0f, area = 0.0f;
  const float cell = parts_.cell(), spread = cell * cell / 24;
  for (std::size_t k = 0; k < std::size_t(parts_.count()); ++k) {
    const float a = parts_.area[k];
    if (a == 0.0f) continue;
    float d = 0.0f;
    if (place.calm) {
      const FootAt& f = place.foot;
      const float out = f.nx * parts_.x[k] + f.ny * parts_.y[k],
                  aside = f.nx * parts_.y[k] - f.ny * parts_.x[k];
      d = f.d + out + f.bend * (0.5f * aside * aside + spread);
    } else {
      const std::size_t at = (k / 4 + 1) * 6 + k % 4 + 1;
      const float x = parts_.x[k] + place.at.x - cells_.mid_x[at],
                  y = parts_.y[k] + place.at.y - cells_.mid_y[at];
      const float aside = cells_.nx[at] * y - cells_.ny[at] * x;
      d = cells_.d[at] + cells_.nx[at] * x + cells_.ny[at] * y +
          cells_.bend[at] * (0.5f * aside * aside + spread);
    }
    sum += a * d, area += a;
  }
  return area > 0.0f ? sum / area : place.foot.d;
}

}  // namespace mien
