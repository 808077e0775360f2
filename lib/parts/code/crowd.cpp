#include <mien/crowd.h>
#include <mien/recipe.h>
#include "lib/parts/code/appearance.h"
#include "lib/parts/recipe/sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace mien {
namespace {

constexpr int kTried = 64;
constexpr std::size_t kCompared = 200;  // who stands farther away on a sheet is not compared
constexpr double kDifferent = 3.5;

/// The least difference to those before, as far as it matters: above `enough` it may be too large.
double least_difference(std::span<const Appearance> before, const Appearance& one, double enough) {
  double least = enough;
  for (const Appearance& other : before.last(std::min(before.size(), kCompared)))
    least = std::min(least, difference(other, one));
  return least;
}

}  // namespace

std::vector<FaceCode> crowd(std::string_view word, int count) {
  const auto library = PartLibrary::shipped_or_why();
  if (!library) return {};
  std::vector<FaceCode> codes;
  std::vector<Appearance> seen;
  for (int place = 0; place < count; ++place) {
    FaceCode best;
    Appearance best_seen{};
    double most = -1.0;
    for (int k = 0; k < kTried && most < kDifferent; ++k) {
      const FaceCode tried{.seed = seed_from_word(fmt::format("{}/{}/{}", word, place, k)),
                           .held = {}};
      const Appearance look = appearance_of(sampled_recipe(**library, tried));
      if (const double least = least_difference(seen, look, kDifferent); least > most)
        best = tried, best_seen = look, most = least;
    }
    codes.push_back(best);
    seen.push_back(best_seen);
  }
  return codes;
}

}  // namespace mien
