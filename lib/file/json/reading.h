#pragma once
// Typed access to a JSON tree. Anything wrong ends the reading with a Refusal. It never leaves lib/file:
// read_face_text turns it into the Error it holds.

#include "lib/file/json/json_tree.h"

#include <array>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// Thrown inside the reader only.
struct Refusal {
  Error error;
};

class Reading {
 public:
  Reading(const JsonTree& json, const FaceLimits& most, std::vector<Error>* warnings)
      : tree(json), limits(most), warnings_(warnings) {}

  const JsonTree& tree;
  const FaceLimits& limits;
  std::vector<Error>* warnings() const { return warnings_; }

  [[noreturn]] void refuse(const JsonNode& node, std::string what) const;
  void warn(const JsonNode& node, std::string what, bool at_key = false);

  /// A member that must be there.
  const JsonNode& need(const JsonNode& object, std::string_view key) const;
  const JsonNode* find(const JsonNode& object, std::string_view key) const {
    return tree.member(object, key);
  }

  void expect(const JsonNode& node, JsonKind kind) const;
  /// Checks that it is an object and warns of keys that are not among `known` ("comment" always
  /// is); `whose` names the kind of object.
  void expect_object(const JsonNode& node, std::span<const std::string_view> known,
                     std::string_view whose = {});
  void expect_object(const JsonNode& node, std::initializer_list<std::string_view> known,
                     std::string_view whose = {}) {
    expect_object(node, std::span(known.begin(), known.size()), whose);
  }
  /// The same, but refuses such keys: for plans, of which a slip would cost more than a picture.
  void expect_only(const JsonNode& node, std::initializer_list<std::string_view> known,
                   std::string_view whose = {}) const;
  /// Whether warnings are wanted, and there are not too many yet.
  bool may_warn() const;

  std::string_view string(const JsonNode& node) const;
  double number(const JsonNode& node) const;
  bool boolean(const JsonNode& node) const;
  /// Two numbers lo < hi.
  std::pair<double, double> range(const JsonNode& node) const;
  /// `least` … `most` numbers; if least is 1 a single number may stand without brackets.
  std::vector<double> numbers(const JsonNode& node, int least, int most) const;
  /// The same into memory that is used again.
  void numbers(const JsonNode& node, int least, int most, std::vector<double>& to) const;
  /// Three numbers.
  std::array<double, 3> three(const JsonNode& node) const;
  /// Two numbers.
  glm::dvec2 pair(const JsonNode& node) const;
  /// One of `words`, as its index; `what` names their kind.
  std::size_t word(const JsonNode& node, std::string_view what,
                   std::span<const std::string_view> words) const;
  /// A name that can be part of a slice's or control's name.
  std::string name(const JsonNode& node) const { return name(node, string(node)); }
  std::string name(const JsonNode& node, std::string_view text) const {
    return std::string(checked_name(node, text));
  }
  /// The same name where it stands.
  std::string_view checked_name(const JsonNode& node, std::string_view text) const;

  /// Calls each(child, index) for the children of an array or object.
  template <class Each>
  void for_each(const JsonNode& container, Each&& each) const {
    int index = 0;
    for (const JsonNode* child = tree.first(container); child; child = tree.next(*child))
      each(*child, index++);
  }

 private:
  std::vector<Error>* warnings_;
};

}  // namespace mien
