#pragma once
// A test's body on every instruction set of this machine.

#include "sdf/distance/instruction_sets.h"

#include <gtest/gtest.h>

#include <functional>

namespace mien::test {

inline void on_every_set(const std::function<void()>& body) {
  for (const auto& set : batch::instruction_sets()) {
    SCOPED_TRACE(set.name);
    batch::use_instruction_set(set.id);
    body();
  }
  batch::use_instruction_set(0);
}

}  // namespace mien::test
