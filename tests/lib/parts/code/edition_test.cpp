#include "lib/parts/code/edition.h"

#include <mien/face_code.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Edition, IsTheFirstSignOfCodesAndOthersAreRefusedInASentence) {
  constexpr std::string_view kSigns = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  EXPECT_EQ(face_code_text({.seed = 5, .held = {}})[0], kEdition);
  for (const char sign : kSigns) {
    int known = 0, refused = 0;
    for (const char check : kSigns) {  // one of them fits
      const auto read = read_face_code(std::string(1, sign) + "0000000005" + check);
      known += read ? 1 : 0;
      refused += !read && read.error().what == unknown_edition({&sign, 1});
    }
    EXPECT_EQ(known, sign == kEdition) << sign;
    EXPECT_EQ(refused, sign != kEdition) << sign;
  }
  EXPECT_EQ(unknown_edition("Q"), "edition Q is not known to this version, which has A");
  EXPECT_EQ(unknown_edition("\n").find('\n'), std::string::npos);
}

}  // namespace
}  // namespace mien
