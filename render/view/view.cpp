#include <mien/render/view/view.h>
