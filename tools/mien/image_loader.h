#pragma once
// mien::image, loaded while the picture is being drawn: OpenImageIO takes a third of a second to
// come up.

#include <mien/render/image/image_module.h>

#include <future>

namespace mien::command {

class ImageLoader {
 public:
  /// Starts loading on a thread of its own. The module is looked for beside the command and where
  /// it is installed.
  ImageLoader();

  /// Waits for it.
  Expected<const ImageModule*> get();

 private:
  std::future<Expected<const ImageModule*>> loading_;
};

}  // namespace mien::command
