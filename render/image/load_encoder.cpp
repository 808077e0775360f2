#include "render/image/load_encoder.h"
#include "render/image/file_type.h"
#include "render/image/png/png_encoder.h"

#include <dlfcn.h>
#include <fmt/format.h>

namespace mien {
namespace {

#ifdef MIEN_FORMATS_PACKAGE
constexpr char kAdvice[] = "; install the package " MIEN_FORMATS_PACKAGE;
#else
constexpr char kAdvice[] = "";
#endif

/// Loads a module by its bare name: the dynamic linker searches the RUNPATH of the program or library that this is
/// in, which the build sets relative to it.
Expected<const ImageModule*> load(const char* file, FileType type) {
  const auto refuse = [&] {
    const char* said = ::dlerror();
    return Error{"", fmt::format("cannot load what writes {}{} ({})", format_of(type).name, kAdvice,
                                 said ? said : file)};
  };
  void* const module = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!module) return refuse();
  const auto entry = reinterpret_cast<ImageModuleEntry>(::dlsym(module, kImageModuleEntry));
  if (!entry) return refuse();
  return entry();
}

}  // namespace

MadeEncoder load_encoder(const EncoderRequest& request) {
  const PictureWriter writer = format_of(request.type).writer;
  if (writer == PictureWriter::png) return png_encoder(request);
  const auto module =
      load(writer == PictureWriter::tiff ? kTiffModuleFile : kOiioModuleFile, request.type);
  if (!module) return module.error();
  return (*module)->make(request);
}

Expected<Done> prepare_to_read() {
  const auto module = load(kOiioModuleFile, FileType::exr);
  if (!module) return module.error();
  return Done{};
}

MadeReader load_reader(const std::filesystem::path& path) {
  const auto module = load(kOiioModuleFile, FileType::exr);
  if (!module) return Error{path.string(), module.error().what};
  return (*module)->read(path);
}

}  // namespace mien
