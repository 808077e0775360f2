// The command starts at once: no image library comes with it.

#include <mien/version.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

TEST(Start, VersionIsOneLine) {
  const test::Ran ran = test::run_mien({"--version"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out, "mien " MIEN_VERSION_STRING "\n");
  EXPECT_EQ(ran.err, "");
}

TEST(Start, LinksNoImageLibrary) {
  // What the dynamic linker would map before main.
  const test::Ran ran = test::run_mien({}, {}, {"LD_TRACE_LOADED_OBJECTS=1"});
  ASSERT_NE(ran.out.find("libc.so"), std::string::npos)
      << "the linker lists nothing here: " << ran.out;
  for (const char* library : {"OpenImageIO", "libtiff", "libgif", "libwebp", "espeak"})
    EXPECT_EQ(ran.out.find(library), std::string::npos) << ran.out;
  // Two of them are the sanitizers', where there are some; the image library would bring fifty.
  constexpr int kMost = 22;
  EXPECT_LT(std::count(ran.out.begin(), ran.out.end(), '\n'), kMost) << ran.out;
}

TEST(Start, HelpGoesToStandardOutput) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"-h"},
                                             {"--help"},
                                             {"render", "-h"},
                                             {"check", "--help"},
                                             {"scene", "-h"},
                                             {"list", "-h"}}) {
    const test::Ran ran = test::run_mien(words);
    EXPECT_EQ(ran.code, 0);
    EXPECT_NE(ran.out.find("Usage: mien"), std::string::npos);
    EXPECT_EQ(ran.err, "");
  }
}

}  // namespace
}  // namespace mien
