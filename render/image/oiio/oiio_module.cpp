#include "render/image/image_module.h"
#include "render/image/oiio/oiio_encoder.h"
#include "render/image/oiio/oiio_reader.h"

extern "C" __attribute__((visibility("default"))) const mien::ImageModule* mien_image_module() {
  static constexpr mien::ImageModule verbs{&mien::oiio_encoder, &mien::oiio_reader};
  return &verbs;
}
