// Lines of text: letters become outlines here, once.

#include "figure_reader_private.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace mien {
namespace {

/// Characters of UTF-8.
std::size_t signs_in(std::string_view text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

}  // namespace

std::shared_ptr<const TextOutline> FigureReader::text_outline(const JsonNode& node) {
  const std::string_view text = in_.string(node);
  const std::size_t signs = signs_in(text);
  if (signs < 1 || signs > std::size_t(kMostSignsOfText))
    in_.refuse(node, fmt::format("a text has 1 to {} signs, got {}", kMostSignsOfText, signs));
  face_.text_signs += int(signs);
  if (face_.text_signs > kMostSignsOfFace)
    in_.refuse(node, fmt::format("the texts of a face have at most {} signs in all, left and right "
                                 "counted; with this one it is {}",
                                 kMostSignsOfFace, face_.text_signs));
  if (!face_.letters || !*face_.letters)
    in_.refuse(node,
               fmt::format(
                   "the text {} needs letters, which the reader was not given: mien::text has them",
                   in_quotes(text)));
  auto outline = (*face_.letters)(text);
  if (!outline) in_.refuse(node, outline.error().what);
  return std::make_shared<const TextOutline>(*std::move(outline));
}

TextFigure FigureReader::text() {
  TextFigure figure{.center = slice("center", SliceKind::point, 2),
                    .height = slice("height", SliceKind::length, 1),
                    .tilt = optional_tilt(),
                    .text = {},
                    .outline = {}};
  if (figure.tilt < 0)
    figure.tilt = face_.add_slice(in_, node_, {name_, "/tilt"}, SliceKind::angle, std::array{0.0},
                                  Written::nowhere);
  const JsonNode& text = *need("text").node;
  figure.text = in_.string(text);
  figure.outline = text_outline(text);
  return figure;
}

}  // namespace mien
