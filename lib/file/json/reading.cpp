#include "lib/file/json/reading.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

constexpr std::size_t kMostWarnings = 100;
constexpr std::size_t kLongestName = 100;  ///< bytes

std::string_view with_article(JsonKind kind) {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return "true or false";
    case JsonKind::number:
      return "a number";
    case JsonKind::string:
      return "a string";
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "";
}

/// "1 number", "2 numbers", "2 to 4 numbers".
std::string amount(int least, int most) {
  if (least == most) return fmt::format("{} number{}", least, least == 1 ? "" : "s");
  return fmt::format("{} {} {} numbers", least, most == least + 1 ? "or" : "to", most);
}

}  // namespace

void Reading::refuse(const JsonNode& node, std::string what) const {
  throw Refusal{{tree.where(node), std::move(what)}};
}

bool Reading::may_warn() const {
  return warnings_ && warnings_->size() < kMostWarnings;
}

void Reading::warn(const JsonNode& node, std::string what, bool at_key) {
  if (may_warn()) warnings_->push_back({tree.where(node, at_key), std::move(what)});
}

const JsonNode& Reading::need(const JsonNode& object, std::string_view key) const {
  const JsonNode* found = find(object, key);
  if (!found) refuse(object, fmt::format("\"{}\" is missing", key));
  return *found;
}

void Reading::expect(const JsonNode& node, JsonKind kind) const {
  if (node.kind != kind)
    refuse(node, fmt::format("expected {}, got {}", with_article(kind), with_article(node.kind)));
}

void Reading::expect_object(const JsonNode& node, std::span<const std::string_view> known,
                            std::string_view whose) {
  expect(node, JsonKind::object);
  for (const JsonNode* child = tree.first(node); child && may_warn(); child = tree.next(*child)) {
    const std::string_view key = tree.key(*child);
    if (key == "comment" || std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string_view near = nearest_name(key, {known.begin(), known.end()});
    warn(*child,
         fmt::format("unknown key {}{}{}, ignored{}", in_quotes(key), whose.empty() ? "" : " of a ",
                     whose, near.empty() ? "" : fmt::format("; did you mean {}?", in_quotes(near))),
         true);
  }
}

void Reading::expect_only(const JsonNode& node, std::initializer_list<std::string_view> known,
                          std::string_view whose) const {
  expect(node, JsonKind::object);
  const std::string what = whose.empty() ? "key" : fmt::format("key of a {}", whose);
  for_each(node, [&](const JsonNode& child, int) {
    const std::string_view key = tree.key(child);
    if (key != "comment" && std::find(known.begin(), known.end(), key) == known.end())
      throw Refusal{{tree.where(child, true), unknown_name(what, key, known)}};
  });
}

std::string_view Reading::string(const JsonNode& node) const {
  expect(node, JsonKind::string);
  return tree.string(node);
}

double Reading::number(const JsonNode& node) const {
  expect(node, JsonKind::number);
  return node.number;
}

bool Reading::boolean(const JsonNode& node) const {
  expect(node, JsonKind::boolean);
  return node.number != 0;
}

std::pair<double, double> Reading::range(const JsonNode& node) const {
  expect(node, JsonKind::array);
  const glm::dvec2 ends = pair(node);
  if (!(ends.x < ends.y))
    refuse(node, fmt::format("expected two rising numbers, got {} and {}", ends.x, ends.y));
  return {ends.x, ends.y};
}

std::vector<double> Reading::numbers(const JsonNode& node, int least, int most) const {
  std::vector<double> values;
  numbers(node, least, most, values);
  return values;
}

void Reading::numbers(const JsonNode& node, int least, int most, std::vector<double>& to) const {
  if (least == 1 && node.kind == JsonKind::number) return to.assign(1, node.number);
  if (node.kind != JsonKind::array)
    refuse(node, fmt::format("expected {}, got {}", amount(least, most), with_article(node.kind)));
  if (node.count < least || node.count > most)
    refuse(node, fmt::format("expected {}, got {}", amount(least, most), node.count));
  to.clear();
  to.reserve(std::size_t(node.count));
  for_each(node, [&](const JsonNode& child, int) { to.push_back(number(child)); });
}

std::array<double, 3> Reading::three(const JsonNode& node) const {
  if (node.kind != JsonKind::array || node.count != 3) numbers(node, 3, 3);  // refuses
  std::array<double, 3> values{};
  for_each(node, [&](const JsonNode& child, int i) { values[std::size_t(i)] = number(child); });
  return values;
}

glm::dvec2 Reading::pair(const JsonNode& node) const {
  const JsonNode* first = node.kind == JsonKind::array ? tree.first(node) : nullptr;
  const JsonNode* second = first ? tree.next(*first) : nullptr;
  if (!second || node.count != 2) numbers(node, 2, 2);  // refuses
  return {number(*first), number(*second)};
}

std::size_t Reading::word(const JsonNode& node, std::string_view what,
                          std::span<const std::string_view> words) const {
  const std::string_view got = string(node);
  const auto found = std::find(words.begin(), words.end(), got);
  if (found == words.end()) refuse(node, unknown_name(what, got, {words.begin(), words.end()}));
  return std::size_t(found - words.begin());
}

std::string_view Reading::checked_name(const JsonNode& node, std::string_view text) const {
  if (text.empty()) refuse(node, "a name must not be empty");
  if (text.size() > kLongestName)
    refuse(node, fmt::format("a name must not be longer than {} bytes", kLongestName));
  for (const char c : text)
    if (static_cast<unsigned char>(c) <= ' ' || c == 0x7F ||
        std::string_view{"/@=,\"\\"}.find(c) != std::string_view::npos)
      refuse(node, fmt::format("the name {} must have no spaces and none of / @ = , \" \\",
                               in_quotes(text)));
  return text;
}

}  // namespace mien
