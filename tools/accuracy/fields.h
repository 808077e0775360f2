#pragma once
// How right is a distance field? Counted in the steps that its bytes have, since nothing finer can be in it.

#include <cstddef>
#include <string>
#include <vector>

#include "tools/accuracy/families.h"
#include "tools/accuracy/methods/freetype_field.h"

namespace mien::accuracy {

/// What a setting did on one family.
struct FieldTally {
  std::string family;
  FieldSetting setting{};
  std::size_t cases = 0;
  std::size_t within =
      0;  ///< whose true distance is two steps or more below the reach; only these are drawn
  std::size_t silent = 0;      ///< of them, without an answer
  double worst = 0, mean = 0;  ///< error in steps; 1/2 is what a byte costs
  double ns = 0;               ///< per pixel of the fields
};

/// The settings of docs/solvers.md: a field that reaches as far as the curve is large, FreeType's default spread, and its
/// least, which is its finest.
std::vector<FieldSetting> field_settings();

/// Families of curves that a field is asked about, quadratic and cubic ones.
std::vector<Family> field_families();

FieldTally judge_field(FreetypeField& field, FieldSetting setting, const Family& family,
                       std::size_t count, uint64_t seed);

std::string field_table(const std::vector<FieldTally>& tallies);
std::string field_csv(const std::vector<FieldTally>& tallies);

}  // namespace mien::accuracy
