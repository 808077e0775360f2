#include "lib/rig/muscle/pulls.h"

#include <algorithm>

namespace mien {
namespace {

/// The strengths of an expression's halves, in [0, 1].
struct Strengths {
  double left, right;

  Strengths(const Expression& expression, std::span<const double> values)
      : left(std::clamp(values[std::size_t(expression.left.at)], 0.0, 1.0)),
        right(std::clamp(values[std::size_t(expression.right.at)], 0.0, 1.0)) {}

  bool act() const { return left != 0 || right != 0; }
  double of(Side side) const {
    return side == Side::left ? left : side == Side::right ? right : 0.5 * (left + right);
  }
};

double amount_of(const ExpressionPart<Channel>& part, const Strengths& strength,
                 std::span<const double> values) {
  const double amount = part.amount * strength.of(part.side);
  if (!part.per) return amount;
  constexpr double kLeast = 0.1;  // below it, noise of the other would count
  return std::min(1.0, amount / std::max(values[std::size_t(part.per.at)], kLeast));
}

void move(const Channel& channel, double amount, double& value) {
  value = channel.joins ? 1 - (1 - value) * (1 - amount) : value + amount;
}

}  // namespace

void muscle_pulls(const FaceModel& model, std::span<const double> values,
                  std::span<const char> held, std::vector<double>& pulls) {
  const std::vector<Muscle>& muscles = model.muscles.muscles;
  pulls.assign(muscles.size(), 1);
  for (const Expression& expression : model.expressions)
    if (const Strengths strength(expression, values); strength.act())
      for (const ExpressionPart<Muscle>& part : expression.pulls)
        pulls[std::size_t(part.index.at)] *= 1 - part.amount * strength.of(part.side);
  for (std::size_t m = 0; m < pulls.size(); ++m) {
    const auto own = std::size_t(muscles[m].channel.at);
    pulls[m] = std::clamp(held[own] ? values[own] : 1 - pulls[m], 0.0, 1.0);
  }
}

void settle_expressions(const FaceModel& model, std::span<double> values) {
  std::array<double, kExpressionGroups> left;
  left.fill(1);
  bool any = false;
  for (const Expression& one : model.expressions) {
    double& value = values[std::size_t(one.left.at)];
    if (one.binary) value = value > 0.5 ? 1 : 0;
    if (value == 0) continue;
    for (std::size_t g = 0; g < kExpressionGroups; ++g) {
      if (one.overrides[g] == Override::none || ExpressionGroup(g) == one.group) continue;
      left[g] = one.overrides[g] == Override::block ? 0 : std::max(left[g] - value, 0.0);
      any = true;
    }
  }
  if (!any) return;
  for (const Expression& one : model.expressions)
    if (one.group != ExpressionGroup::none)
      values[std::size_t(one.left.at)] *= left[std::size_t(one.group)];
}

void move_channels(const FaceModel& model, std::span<double> values) {
  for (const Expression& expression : model.expressions)
    if (const Strengths strength(expression, values); strength.act())
      for (const ExpressionPart<Channel>& part : expression.moves)
        move(part.index.in(model.channels), amount_of(part, strength, values),
             values[std::size_t(part.index.at)]);
}

}  // namespace mien
