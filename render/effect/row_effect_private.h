#pragma once
// One effect of a chain.

#include <mien/render/effect/effect_chain.h>

#include <array>
#include <deque>
#include <memory>
#include <vector>

namespace mien {

class RowEffect {
 public:
  virtual ~RowEffect() = default;
  virtual void push(const float* row, const TakeRows& out) = 0;
};

std::unique_ptr<RowEffect> row_effect(const MosaicEffect& mosaic, int width, int height);
std::unique_ptr<RowEffect> row_effect(const GridEffect& grid, int width, int height);

}  // namespace mien
