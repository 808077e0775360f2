#pragma once
// mien::image as a module: what a program that loads it at run time finds in it.
//
//   void* module = dlopen("mien-image-0.1.0.so", RTLD_NOW);
//   auto verbs = reinterpret_cast<mien::ImageModuleEntry>(dlsym(module,
//   mien::kImageModuleEntry))();

#include <mien/image.h>
#include <mien/version.h>

namespace mien {

/// The verb of image.h. The module's file name carries mien's version: both sides are always of
/// the same one.
struct ImageModule {
  decltype(&write_image) write;
};

using ImageModuleEntry = const ImageModule* (*)();
inline constexpr char kImageModuleEntry[] = "mien_image_module";
inline constexpr char kImageModuleFile[] = "mien-image-" MIEN_VERSION_STRING ".so";

}  // namespace mien
