// The emotions of a face file, and its tables of standard names.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/face/standard_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace mien {
namespace {

constexpr std::string_view kEmotion = "emotion";

class ExpressionReader {
 public:
  ExpressionReader(Reading& in, FaceDraft& face) : in_(in), face_(face) {
    const std::vector<Muscle>& muscles = face.model.muscles.muscles;
    for (std::size_t m = 0; m < muscles.size(); ++m) muscles_.emplace_back(muscles[m].name, int(m));
    std::sort(muscles_.begin(), muscles_.end());
  }

  /// {NAME: {MUSCLE, CONTROL or EMOTION: amount, …}, …}
  void read_set(const JsonNode& node, std::string_view set) {
    in_.expect(node, JsonKind::object);
    const auto standard = standard_names(set);
    std::vector<std::string> given;
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view key = in_.tree.key(child);
      if (key == "comment") return;
      const std::string name = in_.name(child, key);
      if (!standard.empty() && std::find(standard.begin(), standard.end(), name) == standard.end())
        in_.refuse(child, unknown_name(fmt::format("{} name", set), name,
                                       {standard.begin(), standard.end()}));
      read_expression(child, fmt::format("{}.{}", set, name), names_have_sides(set));
      given.push_back(name);
    });
    resolve(set);
    // Programs send every name of a set: what this face cannot show exists and does nothing.
    for (const std::string_view name : standard)
      if (std::find(given.begin(), given.end(), name) == given.end())
        add_expression(node, {.name = fmt::format("{}.{}", set, name)}, names_have_sides(set));
  }

 private:
  void read_expression(const JsonNode& node, const std::string& name, bool one_number) {
    in_.expect(node, JsonKind::object);
    Expression expression{.name = name};
    if (name.starts_with("vrm.")) expression.group = group_of(name);
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view key = in_.tree.key(child);
      if (key == "comment" || (name.starts_with("vrm.") && read_vrm_key(child, key, expression)))
        return;
      read_part(child, expression);
    });
    add_expression(node, std::move(expression), one_number);
  }

  static ExpressionGroup group_of(std::string_view name) {
    name.remove_prefix(std::string_view("vrm.").size());
    if (name.starts_with("blink")) return ExpressionGroup::blink;
    if (name.starts_with("look")) return ExpressionGroup::look;
    for (const std::string_view sound : {"aa", "ih", "ou", "ee", "oh"})
      if (name == sound) return ExpressionGroup::mouth;
    return ExpressionGroup::none;
  }

  /// The keys that VRM 1.0 has beside what an expression moves.
  bool read_vrm_key(const JsonNode& node, std::string_view key, Expression& expression) const {
    constexpr std::array<std::string_view, 3> kOverrides{"none", "blend", "block"};
    if (key == "isBinary") {
      expression.binary = in_.boolean(node);
      return true;
    }
    for (const auto& [name, group] : {std::pair{"overrideBlink", ExpressionGroup::blink},
                                      {"overrideLookAt", ExpressionGroup::look},
                                      {"overrideMouth", ExpressionGroup::mouth}})
      if (key == name) {
        expression.overrides[std::size_t(group)] = Override(in_.word(node, "override", kOverrides));
        return true;
      }
    return false;
  }

  void add_expression(const JsonNode& node, Expression expression, bool one_number) {
    expression.left = expression.right = add_channel();
    std::vector<SidedChannel> channels{{Side::none, expression.left}};
    if (!one_number) {
      expression.right = add_channel();
      channels = {{Side::left, expression.left}, {Side::right, expression.right}};
    }
    face_.add_control(in_, node, {expression.name, "strength", {}}, channels);
    face_.model.expressions.push_back(std::move(expression));
  }

  Index<Channel> add_channel() { return face_.add_channel({.rest = 0, .lo = 0, .hi = 1}); }

  void read_part(const JsonNode& node, Expression& expression) {
    const std::string_view name = in_.tree.key(node);
    const JsonNode* per = nullptr;
    if (node.kind == JsonKind::object) {
      in_.expect_object(node, {"amount", "per"}, "share");
      per = in_.find(node, "per");
    }
    const double amount =
        in_.number(node.kind == JsonKind::object ? in_.need(node, "amount") : node);
    Side side = Side::none;
    std::string_view bare = name;
    for (const Side s : {Side::left, Side::right})
      if (name.starts_with(side_name(s)) && name.size() > side_name(s).size() &&
          name[side_name(s).size()] == '.')
        side = s, bare = name.substr(side_name(s).size() + 1);
    if (per) return add_quotient(node, name, amount, *per, expression);
    if (add_muscles(node, bare, side, amount, expression)) return;
    if (add_emotion(node, bare, side, amount, expression)) return;
    if (add_control_move(node, name, amount, expression)) return;
    in_.refuse(node, unknown(name));
  }

  /// A move by this expression's strength over another's, which may come later in the set.
  void add_quotient(const JsonNode& node, std::string_view name, double amount, const JsonNode& per,
                    Expression& expression) {
    const std::size_t first = expression.moves.size();
    if (!add_control_move(node, name, amount, expression)) in_.refuse(node, unknown(name));
    for (std::size_t i = first; i < expression.moves.size(); ++i)
      quotients_.push_back({face_.model.expressions.size(), i, &per});
  }

  /// Finds the expressions that quotients of a set are of.
  void resolve(std::string_view set) {
    for (const Quotient& quotient : quotients_) {
      const std::string_view wanted = in_.string(*quotient.per);
      const std::string full = fmt::format("{}.{}", set, wanted);
      const auto found =
          std::find_if(face_.model.expressions.begin(), face_.model.expressions.end(),
                       [&](const Expression& e) { return e.name == full; });
      if (found == face_.model.expressions.end()) {
        std::vector<std::string_view> known;
        for (const Expression& e : face_.model.expressions)
          if (e.name.starts_with(std::string(set) + "."))
            known.push_back(std::string_view(e.name).substr(set.size() + 1));
        in_.refuse(*quotient.per, unknown_name(fmt::format("{} name", set), wanted, known));
      }
      face_.model.expressions[quotient.expression].moves[quotient.move].per = found->left;
    }
    quotients_.clear();
  }

  void check_share(const JsonNode& node, double amount) const {
    if (!(amount >= 0 && amount <= 1))
      in_.refuse(node, fmt::format("a share goes from 0 to 1, got {}", amount));
  }

  bool add_muscles(const JsonNode& node, std::string_view name, Side side, double amount,
                   Expression& expression) const {
    bool found = false;
    for (auto at = std::lower_bound(muscles_.begin(), muscles_.end(), std::pair(name, 0));
         at != muscles_.end() && at->first == name; ++at) {
      const Muscle& muscle = face_.model.muscles.muscles[std::size_t(at->second)];
      if (side != Side::none && muscle.side != side) continue;
      expression.pulls.push_back({{at->second}, amount, muscle.side});
      found = true;
    }
    if (found) check_share(node, amount);
    return found;
  }

  /// What an emotion does, by a share of it.
  bool add_emotion(const JsonNode& node, std::string_view name, Side side, double share,
                   Expression& expression) const {
    const std::string wanted = fmt::format("{}.{}", kEmotion, name);
    for (const Expression& emotion : face_.model.expressions) {
      if (emotion.name != wanted) continue;
      check_share(node, share);
      add_parts(emotion.pulls, side, share, expression.pulls);
      add_parts(emotion.moves, side, share, expression.moves);
      return true;
    }
    return false;
  }

  template <class T>
  static void add_parts(const std::vector<ExpressionPart<T>>& from, Side side, double share,
                        std::vector<ExpressionPart<T>>& to) {
    for (ExpressionPart<T> part : from) {
      if (side != Side::none && part.side != side) continue;
      part.amount *= share;
      to.push_back(part);
    }
  }

  bool add_control_move(const JsonNode& node, std::string_view name, double amount,
                        Expression& expression) const {
    const auto found = face_.control_by_name.find(std::string{name});
    if (found == face_.control_by_name.end()) return false;
    const Control& control = found->second.in(face_.model.controls);
    for (const Index<Channel> channel : control.channels) {
      if (channel.in(face_.model.channels).joins) check_share(node, amount);
      expression.moves.push_back({channel, amount, side_of(channel)});
    }
    return true;
  }

  /// The half of a control that a channel stands for.
  Side side_of(Index<Channel> channel) const {
    const auto i = std::size_t(channel.at);
    return i < face_.channel_sides.size() ? face_.channel_sides[i] : Side::none;
  }

  std::string unknown(std::string_view name) const {
    std::vector<std::string> known;
    for (const Muscle& muscle : face_.model.muscles.muscles) known.push_back(muscle.name);
    for (const Control& control : face_.model.controls) known.push_back(control.name);
    return unknown_name("muscle or control", name, {known.begin(), known.end()});
  }

  Reading& in_;
  FaceDraft& face_;
  std::vector<std::pair<std::string_view, int>> muscles_;  ///< by name, then by index
  struct Quotient {
    std::size_t expression, move;
    const JsonNode* per;
  };
  std::vector<Quotient> quotients_;  ///< of the set that is read
};

}  // namespace

void read_emotions(Reading& in, const JsonNode& node, FaceDraft& face) {
  ExpressionReader(in, face).read_set(node, kEmotion);
}

void read_expressions(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  ExpressionReader reader(in, face);
  in.for_each(node, [&](const JsonNode& set, int) {
    const std::string_view name = in.tree.key(set);
    if (name == "comment") return;
    if (name == kEmotion || name == "muscle" || name.find('.') != std::string_view::npos)
      in.refuse(set, fmt::format("no set of expressions may be called {}", in_quotes(name)));
    reader.read_set(set, in.name(set, name));
  });
  if (face.model.mouth)
    for (const Expression& one : face.model.expressions)
      if (one.name.starts_with("viseme.") || one.name.starts_with("azure."))
        face.model.mouth->speech.push_back(one.left);
}

bool read_mood(Reading& in, const JsonNode* node, FaceDraft& face) {
  if (!node) return false;
  in.expect(*node, JsonKind::object);
  bool any = false;
  in.for_each(*node, [&](const JsonNode& child, int) {
    const std::string_view name = in.tree.key(child);
    if (name == "comment") return;
    std::vector<std::string_view> known;
    for (const Expression& expression : face.model.expressions)
      if (const std::string_view full = expression.name; full.starts_with("emotion."))
        known.push_back(full.substr(std::string_view("emotion.").size()));
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) in.refuse(child, unknown_name("emotion", name, known));
    const double strength = in.number(child);
    if (!(strength >= 0 && strength <= 1))
      in.refuse(child, fmt::format("a mood goes from 0 to 1, got {}", strength));
    // Emotions come first among expressions.
    const Expression& emotion = face.model.expressions[std::size_t(found - known.begin())];
    for (const Index<Channel> c : {emotion.left, emotion.right})
      face.model.channels[std::size_t(c.at)].rest = strength;
    any |= strength > 0;
  });
  return any;
}

}  // namespace mien
