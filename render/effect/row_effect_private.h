#pragma once
// One effect of a chain.

#include <mien/effect_chain.h>

#include <array>
#include <deque>
#include <memory>
#include <vector>

namespace mien {

class RowEffect {
 public:
  virtual ~RowEffect() = default;
  /// The next row of what `in` gives, with the effect applied.
  virtual bool next(const NextRow& in, float* row) = 0;
};

std::unique_ptr<RowEffect> row_effect(const MosaicEffect& mosaic, int width, int height);
std::unique_ptr<RowEffect> row_effect(const GridEffect& grid, int width, int height);

}  // namespace mien
