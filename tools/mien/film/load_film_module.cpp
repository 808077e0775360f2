#include "tools/mien/film/load_film_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

namespace mien::command {

Expected<const FilmModule*> film_module() {
  // By its bare name: the dynamic linker searches the RUNPATH of the program.
  void* const module = ::dlopen(kFilmModuleFile, RTLD_NOW | RTLD_LOCAL);
  const auto entry =
      module ? reinterpret_cast<FilmModuleEntry>(::dlsym(module, kFilmModuleEntry)) : nullptr;
  if (entry) return entry();
  const char* const said = ::dlerror();
  return Error{
      "", fmt::format("cannot load what writes WebP and GIF ({})", said ? said : kFilmModuleFile)};
}

}  // namespace mien::command
