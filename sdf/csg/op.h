#pragma once
// Operators that combine areas. sdf/csg/combine.h defines the distances of the results.

namespace mien {

enum class Op : unsigned char {
  shape,       ///< leaf: one of the scene's shapes
  unite,       ///< union: min(a, b)
  intersect,   ///< intersection: max(a, b)
  subtract,    ///< difference: max(a, −b)
  complement,  ///< −a
  offset,      ///< a − amount: grown by amount, shrunk if negative
  shell        ///< |a| − amount: the ribbon of half-width amount along the outline
};

}  // namespace mien
