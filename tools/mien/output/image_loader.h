#pragma once
// Encoders that are large libraries. They are loaded when a picture needs them, because OpenImageIO takes a
// third of a second to start.

#include "render/image/image_module.h"

namespace mien::command {

/// An encoder of any type. PNG's is the command's own; the others come from a module, which is looked for
/// beside the command and where it is installed.
MadeEncoder load_encoder(const EncoderRequest& request);

}  // namespace mien::command
