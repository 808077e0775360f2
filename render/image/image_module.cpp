#include <mien/render/image/image_module.h>

extern "C" __attribute__((visibility("default"))) const mien::ImageModule* mien_image_module() {
  static constexpr mien::ImageModule verbs{&mien::write_image};
  return &verbs;
}
