#include "render/image/image_module.h"
#include "render/image/tiff/tiff_encoder.h"

extern "C" __attribute__((visibility("default"))) const mien::ImageModule* mien_image_module() {
  static constexpr mien::ImageModule verbs{&mien::tiff_encoder, nullptr};
  return &verbs;
}
