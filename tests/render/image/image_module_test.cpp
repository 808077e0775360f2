#include <mien/render/image/image_module.h>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/sample_image.h"
#include "tests/support/scratch_folder.h"

namespace mien {
namespace {

TEST(ImageModule, IsLoadedByNameAndWrites) {
  const std::filesystem::path file = MIEN_IMAGE_MODULE;
  EXPECT_EQ(file.filename(), kImageModuleFile);
  void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(module, nullptr) << ::dlerror();
  const auto entry = reinterpret_cast<ImageModuleEntry>(::dlsym(module, kImageModuleEntry));
  ASSERT_NE(entry, nullptr);

  const test::ScratchFolder folder;
  EXPECT_TRUE(entry()->write(test::sample_image(9, 5, Depth::u8, true), folder / "a.png", {}));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
}

}  // namespace
}  // namespace mien
