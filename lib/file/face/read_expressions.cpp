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

constexpr std::string_view kEmotion = "emotion", kEmotions = "emotion.";

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
    const bool one_number = names_have_sides(set);
    std::vector<char> given(standard.size());
    std::size_t next = 0;  // files have the names in the order of the standard, mostly
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view key = in_.tree.key(child);
      if (key == "comment") return;
      const std::string_view name = in_.checked_name(child, key);
      if (!standard.empty()) {
        if (next >= standard.size() || standard[next] != name)
          next = std::size_t(std::find(standard.begin(), standard.end(), name) - standard.begin());
        if (next == standard.size())
          in_.refuse(child, unknown_name(fmt::format("{} name", set), name,
                                         {standard.begin(), standard.end()}));
        given[next++] = 1;
      }
      read_expression(child, full_name(set, name), one_number);
    });
    resolve(set);
    // Programs send every name of a set: what this face cannot show exists and does nothing.
    for (std::size_t i = 0; i < standard.size(); ++i)
      if (!given[i]) add_expression(node, {.name = full_name(set, standard[i])}, one_number);
  }

 private:
  std::string_view full_name(std::string_view set, std::string_view name) {
    return face_.model.names.keep({set, ".", name});
  }

  void read_expression(const JsonNode& node, std::string_view name, bool one_number) {
    in_.expect(node, JsonKind::object);
    Expression expression{.name = name};
    pulls_.clear(), moves_.clear();
    if (name.starts_with("vrm.")) expression.group = group_of(name);
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view key = in_.tree.key(child);
      if (key == "comment" || (name.starts_with("vrm.") && read_vrm_key(child, key, expression)))
        return;
      read_part(child);
    });
    expression.pulls.assign(pulls_.begin(), pulls_.end());
    expression.moves.assign(moves_.begin(), moves_.end());
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
    const Control control{expression.name, "strength", {}};
    if (one_number) {
      face_.add_control(in_, node, control, std::array{SidedChannel{Side::none, expression.left}});
    } else {
      expression.right = add_channel();
      face_.add_control(in_, node, control,
                        std::array{SidedChannel{Side::left, expression.left},
                                   SidedChannel{Side::right, expression.right}});
    }
    face_.model.expressions.push_back(std::move(expression));
  }

  Index<Channel> add_channel() { return face_.add_channel({.rest = 0, .lo = 0, .hi = 1}); }

  void read_part(const JsonNode& node) {
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
    if (per) return add_quotient(node, name, amount, *per);
    if (add_muscles(node, bare, side, amount)) return;
    if (add_emotion(node, bare, side, amount)) return;
    if (add_control_move(node, name, amount)) return;
    in_.refuse(node, unknown(name));
  }

  /// A move by this expression's strength over another's, which may come later in the set.
  void add_quotient(const JsonNode& node, std::string_view name, double amount,
                    const JsonNode& per) {
    const std::size_t first = moves_.size();
    if (!add_control_move(node, name, amount)) in_.refuse(node, unknown(name));
    for (std::size_t i = first; i < moves_.size(); ++i)
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
            known.push_back(e.name.substr(set.size() + 1));
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

  bool add_muscles(const JsonNode& node, std::string_view name, Side side, double amount) {
    bool found = false;
    for (auto at = std::lower_bound(muscles_.begin(), muscles_.end(), std::pair(name, 0));
         at != muscles_.end() && at->first == name; ++at) {
      const Muscle& muscle = face_.model.muscles.muscles[std::size_t(at->second)];
      if (side != Side::none && muscle.side != side) continue;
      pulls_.push_back({{at->second}, amount, muscle.side});
      found = true;
    }
    if (found) check_share(node, amount);
    return found;
  }

  /// What an emotion does, by a share of it.
  bool add_emotion(const JsonNode& node, std::string_view name, Side side, double share) {
    for (const Expression& emotion : face_.model.expressions) {  // emotions come first
      if (!emotion.name.starts_with(kEmotions)) return false;
      if (emotion.name.substr(kEmotions.size()) != name) continue;
      check_share(node, share);
      add_parts(emotion.pulls, side, share, pulls_);
      add_parts(emotion.moves, side, share, moves_);
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

  bool add_control_move(const JsonNode& node, std::string_view name, double amount) {
    const Index<Control> found = face_.find_control(name);
    if (!found) return false;
    for (const Index<Channel> channel : found.in(face_.model.controls).channels) {
      if (channel.in(face_.model.channels).joins) check_share(node, amount);
      moves_.push_back({channel, amount, side_of(channel)});
    }
    return true;
  }

  /// The half of a control that a channel stands for.
  Side side_of(Index<Channel> channel) const {
    const auto i = std::size_t(channel.at);
    return i < face_.channel_sides.size() ? face_.channel_sides[i] : Side::none;
  }

  std::string unknown(std::string_view name) const {
    std::vector<std::string_view> known;
    for (const Muscle& muscle : face_.model.muscles.muscles) known.push_back(muscle.name);
    for (const Control& control : face_.model.controls) known.push_back(control.name);
    return unknown_name("muscle or control", name, known);
  }

  Reading& in_;
  FaceDraft& face_;
  std::vector<std::pair<std::string_view, int>> muscles_;  ///< by name, then by index
  struct Quotient {
    std::size_t expression, move;
    const JsonNode* per;
  };
  std::vector<Quotient> quotients_;            ///< of the set that is read
  std::vector<ExpressionPart<Muscle>> pulls_;  ///< of the expression that is read
  std::vector<ExpressionPart<Channel>> moves_;
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
