#include <mien/image.h>
#include <mien/render/image/descriptor_proxy.h>
#include <mien/render/image/encode.h>
#include <mien/render/image/file_type.h>
#include <mien/render/image/system_error.h>
#include <mien/render/image/target.h>
#include <mien/render/image/whole_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <exception>

namespace mien {
namespace fs = std::filesystem;

namespace {

/// In order, whatever standard output is: behind what a file already holds, too.
Expected<Done> write_stdout(const Image& image, FileType type, const WriteOptions& how) {
  DescriptorProxy out(STDOUT_FILENO, true);
  return encode(image, type, how, out);
}

Expected<Done> write_device(const Image& image, FileType type, const WriteOptions& how,
                            const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return Error{"", "cannot be written: " + system_error(errno)};
  DescriptorProxy out(descriptor, ::lseek(descriptor, 0, SEEK_CUR) < 0);
  auto done = encode(image, type, how, out);
  ::close(descriptor);
  return done;
}

Expected<Done> write_whole(const Image& image, FileType type, const WriteOptions& how,
                           const fs::path& path) {
  auto file = WholeFile::begin(path);
  if (!file) return Error{"", file.error().what};
  DescriptorProxy out(file->descriptor(), false);
  if (auto done = encode(image, type, how, out); !done) return done;
  auto done = file->commit();
  if (!done) return Error{"", done.error().what};
  return done;
}

Expected<Done> write_to(const Image& image, const fs::path& path, const WriteOptions& how) {
  const auto type = chosen_type(path, how);
  if (!type) return type.error();
  if (auto fits = check_fits(image, *type); !fits) return fits;
  if (path == "-") return write_stdout(image, *type, how);
  const auto target = find_target(path);
  if (!target) return target.error();
  return target->stream ? write_device(image, *type, how, target->path)
                        : write_whole(image, *type, how, target->path);
}

}  // namespace

Expected<Done> write_image(const Image& image, const fs::path& path, const WriteOptions& how) {
  const std::string where = path == "-" ? "standard output" : path.string();
  try {
    auto done = write_to(image, path, how);
    if (!done && done.error().where.empty()) return Error{where, done.error().what};
    return done;
  } catch (const std::exception& failure) {
    return Error{where, std::string("cannot be written: ") + failure.what()};
  }
}

}  // namespace mien
