#pragma once
// Any text made safe to stand in an XML file, and names made ids.

#include <string>
#include <string_view>
#include <unordered_map>

namespace mien {

/// With & < > and quotes escaped. What is no UTF-8, or what XML forbids, becomes U+FFFD.
std::string xml_escaped(std::string_view text);

/// Names as ids that occur once in a file.
class XmlIds {
 public:
  explicit XmlIds(std::string_view prefix);

  /// The name with '_' for all but letters, digits, '.', '-' and '_' of ASCII; where it is taken already, with a
  /// number behind it.
  std::string unique(std::string_view name);

 private:
  std::string prefix_;
  std::unordered_map<std::string, int> taken_;  ///< and the last number given to that name
};

}  // namespace mien
