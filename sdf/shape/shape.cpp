#include <mien/sdf/shape/shape.h>
