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

void move_channels(const FaceModel& model, std::span<double> values) {
  for (const Expression& expression : model.expressions)
    if (const Strengths strength(expression, values); strength.act())
      for (const ExpressionPart<Channel>& part : expression.moves)
        values[std::size_t(part.index.at)] += part.amount * strength.of(part.side);
}

}  // namespace mien
