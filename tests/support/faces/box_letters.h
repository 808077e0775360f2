#pragma once
// Letters without a font: every sign is a box as high as a capital, half as wide; "?" is lacking.

#include <mien/letters.h>

namespace mien::test {

inline Letters box_letters() {
  return [](std::string_view text) -> Expected<TextOutline> {
    if (text.find('?') != std::string_view::npos)
      return Error{{}, "the font has no letter for \"?\" (U+003F)"};
    TextOutline made{.loops = {}, .width = 0.7 * double(text.size())};
    const auto side = [](glm::dvec2 a, glm::dvec2 b) { return QuadBezier{a, 0.5 * (a + b), b}; };
    for (std::size_t i = 0; i < text.size(); ++i) {
      const double left = 0.7 * double(i) + 0.1 - 0.5 * made.width, right = left + 0.5;
      const glm::dvec2 corners[] = {{left, -0.5}, {right, -0.5}, {right, 0.5}, {left, 0.5}};
      std::vector<QuadBezier>& loop = made.loops.emplace_back();
      for (int k = 0; k < 4; ++k) loop.push_back(side(corners[k], corners[(k + 1) % 4]));
    }
    return made;
  };
}

}  // namespace mien::test
