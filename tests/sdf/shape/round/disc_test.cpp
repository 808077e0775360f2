#include "tests/support/shapes/shape_examples/disc.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Disc, ShapeLaws, Disc);

}  // namespace mien::test
