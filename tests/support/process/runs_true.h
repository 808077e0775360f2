#pragma once
#include "sdf/outline/area_program.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mien::test {

/// Whether the program's area holds a point, by the bits of its outlines: step by step, as the program is written.
inline bool runs_true(std::span<const AreaStep> program, const std::uint64_t* inside) {
  std::vector<char> stack;
  for (const AreaStep& step : program) {
    switch (step.kind) {
      case AreaStep::Kind::outline:
        stack.push_back(char(inside[step.outline >> 6] >> (step.outline & 63) & 1));
        break;
      case AreaStep::Kind::nothing:
        stack.push_back(0);
        break;
      case AreaStep::Kind::not_:
        stack.back() = !stack.back();
        break;
      case AreaStep::Kind::and_:
      case AreaStep::Kind::or_: {
        const char b = stack.back();
        stack.pop_back();
        stack.back() = step.kind == AreaStep::Kind::and_ ? stack.back() & b : stack.back() | b;
        break;
      }
    }
  }
  return program.empty() || stack.back();
}

}  // namespace mien::test
