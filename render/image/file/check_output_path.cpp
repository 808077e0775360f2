#include <mien/write.h>
#include "lib/base/memory_ran_out.h"
#include "render/image/file/output_path.h"
#include "render/image/file_type.h"

#include <exception>

namespace mien {

Expected<Done> check_output_path(const std::filesystem::path& path, const WriteOptions& how) try {
  try {
    const auto type = chosen_type(path, how);
    if (!type) return type.error();
    if (path == "-") return Done{};
    const auto target = find_output_path(path);
    if (!target) return target.error();
    return Done{};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return Error{path.string(), std::string("cannot be written: ") + failure.what()};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

}  // namespace mien
