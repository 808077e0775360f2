#include <mien/tools/mien/image_loader.h>

#include <dlfcn.h>

namespace mien::command {
namespace {

/// By its bare name: the dynamic linker looks along the command's own RUNPATH, which the build sets
/// relative to it.
Expected<const ImageModule*> load() {
  const auto refuse = [] {
    const char* said = ::dlerror();
    return Error{
        "", std::string("cannot load what writes pictures: ") + (said ? said : kImageModuleFile)};
  };
  void* const module = ::dlopen(kImageModuleFile, RTLD_NOW | RTLD_LOCAL);
  if (!module) return refuse();
  const auto entry = reinterpret_cast<ImageModuleEntry>(::dlsym(module, kImageModuleEntry));
  if (!entry) return refuse();
  return entry();
}

}  // namespace

ImageLoader::ImageLoader() : loading_(std::async(std::launch::async, load)) {}

Expected<const ImageModule*> ImageLoader::get() {
  return loading_.get();
}

}  // namespace mien::command
