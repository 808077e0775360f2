#include <mien/render/image/image_module.h>
#include <mien/render/image/tiff_encoder.h>

extern "C" __attribute__((visibility("default"))) const mien::ImageModule* mien_image_module() {
  static constexpr mien::ImageModule verbs{&mien::tiff_encoder};
  return &verbs;
}
