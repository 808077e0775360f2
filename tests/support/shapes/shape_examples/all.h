#pragma once
// Every kind of shape.

#include "tests/support/shapes/shape_examples/band.h"
#include "tests/support/shapes/shape_examples/cut_disc.h"
#include "tests/support/shapes/shape_examples/disc.h"
#include "tests/support/shapes/shape_examples/ellipse.h"
#include "tests/support/shapes/shape_examples/half_plane.h"
#include "tests/support/shapes/shape_examples/line.h"
#include "tests/support/shapes/shape_examples/parabola_side.h"
#include "tests/support/shapes/shape_examples/path.h"
#include "tests/support/shapes/shape_examples/polyline.h"
#include "tests/support/shapes/shape_examples/quad_stroke.h"
#include "tests/support/shapes/shape_examples/tapered_stroke.h"
#include "tests/support/shapes/shape_examples/triangle.h"
