#pragma once
// Encoders that are large libraries. They are loaded when a picture needs them, because OpenImageIO takes a
// third of a second to start.

#include "render/image/image_module.h"

namespace mien {

/// An encoder of any type. PNG's is at hand; the others come from a module, which is looked for where the program
/// or library with this function says: beside it, and where modules are installed.
MadeEncoder load_encoder(const EncoderRequest& request);

/// A picture that mien wrote, to be read again. It comes from the module that writes EXR and JPEG.
MadeReader load_reader(const std::filesystem::path& path);
/// Loads what it needs, which takes a third of a second that nothing ends: before interrupts are watched.
Expected<Done> prepare_to_read();

}  // namespace mien
