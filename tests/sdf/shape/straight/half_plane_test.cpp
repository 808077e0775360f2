#include <mien/shape.h>

#include "tests/support/shapes/shape_examples/half_plane.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(HalfPlane, ShapeLaws, HalfPlane);

}  // namespace mien::test
