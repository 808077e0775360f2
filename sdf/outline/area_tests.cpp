#include "sdf/outline/area_tests.h"

#include "lib/base/watch.h"

#include <utility>

namespace mien {

AreaTests::Start AreaTests::add(std::span<const AreaStep> program) {
  if (program.empty()) return kHolds;
  const int start = int(tests_.size());
  operands_.clear();
  links_.resize(2 * tests_.size());
  for (const AreaStep& step : program) {
    switch (step.kind) {
      case AreaStep::Kind::outline:
        push_outline(step.outline);
        break;
      case AreaStep::Kind::nothing:
        push_outline(0);
        tests_.back().inside = 0;
        operands_.back().outline = false;
        break;
      case AreaStep::Kind::not_:
        std::swap(operands_.back().if_holds, operands_.back().if_fails);
        break;
      case AreaStep::Kind::and_:
      case AreaStep::Kind::or_:
        join(step.kind == AreaStep::Kind::and_);
        break;
    }
  }
  lead(operands_.back().if_holds, kHolds);
  lead(operands_.back().if_fails, kFails);
  return start;
}

bool AreaTests::holds(Start start, const std::uint64_t* inside) const {
  int at = start, passed = 0;
  while (at >= 0) {
    ++passed;
    const Test& test = tests_[std::size_t(at)];
    const std::uint64_t in = inside[test.word];
    // Mostly none holds. As a branch, not as an index, so that the next test is read before this one is done.
    if (((in & test.inside) | (~in & test.outside)) == 0) [[likely]]
      at = test.if_none;
    else
      at = test.if_any;
  }
  worked(passed);
  return at == kHolds;
}

void AreaTests::push_outline(int outline) {
  const int any = 2 * int(tests_.size()), none = any + 1;
  tests_.push_back({std::uint64_t{1} << (outline & 63), 0, outline >> 6, kFails, kFails});
  links_.insert(links_.end(), {-1, -1});
  operands_.push_back({any / 2, {any, any}, {none, none}, true});
}

/// The last two operands become one: where the first does not settle it, the second is asked.
void AreaTests::join(bool all) {
  Operand b = operands_.back();
  operands_.pop_back();
  Operand& a = operands_.back();
  // From the last to the first: a test's neighbours are found by where it stands.
  turn(b, all), turn(a, all);
  if (!share_test(a, b, all)) {
    lead(all ? a.if_holds : a.if_fails, b.first);
    a.if_holds = all ? b.if_holds : together(a.if_holds, b.if_holds);
    a.if_fails = all ? together(a.if_fails, b.if_fails) : b.if_fails;
  }
  a.outline = false;
}

/// Of a union (`all`: an intersection) an outline's test is whether the operand holds (fails), so that it can be shared.
void AreaTests::turn(Operand& operand, bool all) {
  Ways& settled = all ? operand.if_fails : operand.if_holds;
  if (!operand.outline || settled.first % 2 == 0) return;
  std::swap(operand.if_holds, operand.if_fails);
  std::swap(tests_[std::size_t(operand.first)].inside, tests_[std::size_t(operand.first)].outside);
}

/// Whether b's only test was added to a's last. It can be if they ask about one word, any of its outlines settles the
/// whole, and no other way leads on from a to b.
bool AreaTests::share_test(const Operand& a, const Operand& b, bool all) {
  const int only = int(tests_.size()) - 1, last = b.first - 1;
  const Ways on = all ? a.if_holds : a.if_fails, settled = all ? b.if_fails : b.if_holds;
  if (b.first != only || settled.first != 2 * only || on.first != 2 * last + 1 ||
      on.last != on.first)
    return false;
  Test& to = tests_[std::size_t(last)];
  const Test& from = tests_[std::size_t(only)];
  if (to.word != from.word) return false;
  to.inside |= from.inside, to.outside |= from.outside;
  tests_.pop_back();
  links_.resize(2 * tests_.size());
  return true;
}

AreaTests::Ways AreaTests::together(Ways a, Ways b) {
  if (a.first < 0) return b;
  if (b.first < 0) return a;
  links_[std::size_t(a.last)] = b.first;
  return {a.first, b.last};
}

void AreaTests::lead(Ways ways, int to) {
  for (int way = ways.first; way >= 0; way = links_[std::size_t(way)])
    (way % 2 ? tests_[std::size_t(way / 2)].if_none : tests_[std::size_t(way / 2)].if_any) = to;
}

}  // namespace mien
