#pragma once
// A strict reader of the XML that SVG files are: one root, tags that close, attributes in quotes, known entities.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mien::test {

struct SvgElement {
  std::string tag;
  std::map<std::string, std::string> attributes;  ///< entities replaced
  std::string text;                               ///< of its own, entities replaced
  std::vector<SvgElement> children;

  std::string get(const std::string& name, const std::string& otherwise = {}) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? otherwise : found->second;
  }
  double number(const std::string& name, double otherwise = 0) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? otherwise : std::stod(found->second);
  }
};

/// Throws std::runtime_error with the place of what is not well-formed, of a character that XML forbids, and of an
/// id that occurs twice.
SvgElement read_svg_tree(std::string_view text);

}  // namespace mien::test
