#pragma once
// The encoders that are large libraries, loaded when a picture needs them: OpenImageIO takes a third
// of a second to come up.

#include "render/image/image_module.h"

namespace mien::command {

/// Of any type: PNG's is the command's own, the others come out of a module, which is looked for
/// beside the command and where it is installed.
MadeEncoder load_encoder(const EncoderRequest& request);

}  // namespace mien::command
