#include <mien/write.h>
#include "lib/base/memory_ran_out.h"
#include "render/image/file/written_file.h"
#include "render/render_error.h"

#include <new>

namespace mien {

Expected<std::vector<std::string>> write_svg(const Scene& scene, const std::filesystem::path& path,
                                             const SvgOptions& options) try {
  const auto told = [&](const std::string& what) {
    return Error{path == "-" ? "standard output" : path.string(), what};
  };
  try {
    auto svg = svg_text(scene, options);
    if (!svg) return told(svg.error().what);
    const auto done = write_file(
        path, [&](const PutBytes& put) { return put(svg->text.data(), svg->text.size()); });
    if (!done) return done.error();
    return std::move(svg->simplified);
  } catch (const std::bad_alloc&) {
    return told(std::string(kMemoryRanOut));
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

}  // namespace mien
