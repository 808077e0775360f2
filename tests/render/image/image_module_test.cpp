#include "render/image/image_module.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

void loads_and_makes(const char* path, const char* name, FileType type) {
  const std::filesystem::path file = path;
  EXPECT_EQ(file.filename(), name);
  void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(module, nullptr) << ::dlerror();
  const auto entry = reinterpret_cast<ImageModuleEntry>(::dlsym(module, kImageModuleEntry));
  ASSERT_NE(entry, nullptr);

  const test::ScratchFolder folder;
  const int descriptor = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  FileOutput out(descriptor, false);
  {
    const WriteOptions how;
    auto made = entry()->make({{9, 5, Depth::u8, true}, type, how, {1, 1 << 30}, out});
    ASSERT_TRUE(made) << made.error().what;
    ASSERT_EQ((*made)->pieces(), 1);
    Image image = test::sample_image(9, 5, Depth::u8, true);
    PreparedPiece piece;
    (*made)->prepare(0, 0, {image.bytes.data(), image.stride(), image.depth}, piece,
                     [] { return false; });
    EXPECT_TRUE((*made)->put(0, piece));
    EXPECT_TRUE((*made)->finish());
  }
  ::close(descriptor);
  EXPECT_GT(std::filesystem::file_size(folder / "a"), 100u);
}

TEST(ImageModule, IsLoadedByNameAndWrites) {
  loads_and_makes(MIEN_OIIO_MODULE, kOiioModuleFile, FileType::exr);
  loads_and_makes(MIEN_TIFF_MODULE, kTiffModuleFile, FileType::tiff);
}

}  // namespace
}  // namespace mien
