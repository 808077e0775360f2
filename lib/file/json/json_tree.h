#pragma once
// A tree of JSON values that remembers where each one stands in the text.
//
// The parser is nlohmann-json's; positions are found by walking through the text along with its events.
// Neither the parser nor anything here recurses, and everything that a hostile text could make large has a
// limit.

#include <mien/expected.h>
#include <mien/face_limits.h>
#include <mien/names.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

/// One value. Children are linked: first, then next, next …; −1 ends.
struct JsonNode {
  double number = 0;  ///< of a number
  std::int32_t parent = -1, first = -1, next = -1;
  std::int32_t text = -1;  ///< of a string: index in strings
  std::int32_t key = -1;   ///< of an object's member: index in strings
  std::uint32_t key_offset = 0;
  std::uint32_t offset = 0;    ///< of its first byte in the text
  std::int32_t count = 0;      ///< children
  std::uint32_t key_sign = 0;  ///< of an object's member: key_sign() of its key
  JsonKind kind = JsonKind::null;
};

/// Length and three letters of a key. Keys that differ mostly have other signs, so looking for one seldom reads
/// another.
constexpr std::uint32_t key_sign(std::string_view key) {
  const auto letter = [&](std::size_t i) {
    return std::uint32_t(static_cast<unsigned char>(key[i]));
  };
  if (key.empty()) return 0;
  const std::size_t last = key.size() - 1;
  return std::uint32_t(key.size()) << 24 ^ letter(0) << 16 ^ letter(last / 2) << 8 ^ letter(last);
}

/// The keys that an object may have, for JsonTree::members.
template <std::size_t N>
struct KnownKeys {
  std::array<std::string_view, N> names;
  std::array<std::uint32_t, N> signs{};

  constexpr explicit KnownKeys(std::array<std::string_view, N> keys) : names(keys) {
    for (std::size_t i = 0; i < N; ++i) signs[i] = key_sign(names[i]);
  }
  /// Where a key of that sign is among them; N: nowhere.
  std::size_t find(std::uint32_t sign, std::string_view key) const {
    std::size_t i = 0;
    while (i < N && !(signs[i] == sign && names[i] == key)) ++i;
    return i;
  }
};

class JsonTree {
 public:
  /// Reads `text`, which must outlive the tree and begins on that line of its file. The error's `where` is "NAME:LINE:COLUMN:
  /// /pointer".
  static Expected<JsonTree> read(std::string_view text, std::string_view name,
                                 const FaceLimits& limits, std::size_t first_line = 1);

  /// A tree without nodes, for other readers of such trees.
  JsonTree(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}
  /// One that never was text: places in it are "NAME: /pointer".
  explicit JsonTree(std::string name) : name_(std::move(name)), has_text_(false) {}
  JsonTree(JsonTree&&) = default;  // its strings stay where they are
  JsonTree& operator=(JsonTree&&) = default;
  JsonTree(const JsonTree&) = delete;

  const JsonNode& root() const { return nodes[0]; }
  const JsonNode* at(std::int32_t index) const {
    return index < 0 ? nullptr : &nodes[std::size_t(index)];
  }
  std::int32_t index(const JsonNode& node) const { return std::int32_t(&node - nodes.data()); }
  const JsonNode* first(const JsonNode& node) const { return at(node.first); }
  const JsonNode* next(const JsonNode& node) const { return at(node.next); }
  const JsonNode* member(const JsonNode& object, std::string_view key) const;
  /// The members of those keys, all in one go; null: not there. `other` is the first of another key, or null.
  template <std::size_t N>
  std::array<const JsonNode*, N> members(const JsonNode& object, const KnownKeys<N>& keys,
                                         const JsonNode** other = nullptr) const {
    std::array<const JsonNode*, N> found{};
    if (object.kind != JsonKind::object) return found;
    for (const JsonNode* child = first(object); child; child = next(*child)) {
      const std::size_t i = keys.find(child->key_sign, key(*child));
      if (i < N)
        found[i] = child;
      else if (other && !*other)
        *other = child;
    }
    return found;
  }
  /// Says what a node that was just made is called in its object.
  void name(JsonNode& node, std::int32_t text) const {
    node.key = text;
    node.key_sign = key_sign(strings_[std::size_t(text)]);
  }
  std::string_view key(const JsonNode& node) const { return strings_[std::size_t(node.key)]; }
  std::string_view string(const JsonNode& node) const { return strings_[std::size_t(node.text)]; }

  /// Takes a string in; gives its index.
  std::int32_t keep(std::string_view text) { return refer(kept_.keep(text)); }
  /// Takes a string in that is given in parts. It stays where it is as long as the tree does.
  std::string_view kept(std::initializer_list<std::string_view> parts) { return kept_.keep(parts); }
  /// The same for one that outlives the tree.
  std::int32_t refer(std::string_view text) {
    strings_.push_back(text);
    return std::int32_t(strings_.size() - 1);
  }

  /// "NAME:LINE:COLUMN: /pointer" of a value; `at_key`: of its key.
  std::string where(const JsonNode& node, bool at_key = false) const;
  /// "NAME:LINE:COLUMN" of a byte; columns count characters.
  std::string where(std::size_t offset) const;
  /// RFC 6901; "" for the root. `longest`: keys of more characters are cut, for people.
  std::string pointer(const JsonNode& node, std::optional<std::size_t> longest = {}) const;

  /// Says that a value was made from one of another tree, which must outlive this one: the places of what is in it are
  /// that one's.
  void stems_from(std::int32_t node, const JsonTree& tree, const JsonNode& from) {
    origins_.push_back({node, &tree, &from});
  }

  /// What a reader of its text would have refused because of the limits.
  std::optional<Error> beyond(const FaceLimits& limits) const;

  std::vector<JsonNode> nodes;

 private:
  struct Origin {
    std::int32_t node;
    const JsonTree* tree;
    const JsonNode* from;
  };
  const Origin* origin_of(const JsonNode& node) const;
  std::string where_in(const Origin& origin, const JsonNode& node) const;

  std::vector<Origin> origins_;
  std::vector<std::string_view> strings_;
  Names kept_;
  std::string_view text_;
  std::string name_;
  std::size_t first_line_ = 1;
  bool has_text_ = true;
};

}  // namespace mien
