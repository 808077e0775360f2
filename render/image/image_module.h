#pragma once
// Encoders as modules: what a program finds in them when it loads them at run time. They need large libraries, and
// linking those would slow the start of every process.
//
//   void* module = dlopen("mien-exr-jpeg-0.1.0.so", RTLD_NOW);
//   auto verbs = reinterpret_cast<mien::ImageModuleEntry>(dlsym(module,
//   mien::kImageModuleEntry))();

#include <mien/version.h>
#include "render/image/oiio/oiio_reader.h"
#include "render/image/picture_encoder.h"

namespace mien {

/// The module's file name carries mien's version: both sides are always of the same one.
struct ImageModule {
  MadeEncoder (*make)(const EncoderRequest& request);
  MadeReader (*read)(const std::filesystem::path& path);  ///< null: it only writes
};

using ImageModuleEntry = const ImageModule* (*)();
inline constexpr char kImageModuleEntry[] = "mien_image_module";
inline constexpr char kOiioModuleFile[] = "mien-exr-jpeg-" MIEN_VERSION_STRING ".so";
inline constexpr char kTiffModuleFile[] = "mien-tiff-" MIEN_VERSION_STRING ".so";

}  // namespace mien
