#include <gtest/gtest.h>

#include "tools/mien/film/finished_frame.h"

#include "tests/support/process/scratch_folder.h"

namespace mien::command {
namespace {

using test::ScratchFolder;

TEST(FinishedFrame, WhatIsNoPngIsNone) {
  const ScratchFolder folder;
  EXPECT_FALSE(is_finished_frame(folder / "none.png", "r"));
  for (const char* text :
       {"", "x", "\x89PNG\r\n\x1a\n", "\x89PNG\r\n\x1a\n\xff\xff\xff\xffIEND1234"}) {
    test::write_text(folder / "a.png", text);
    EXPECT_FALSE(is_finished_frame(folder / "a.png", "r"));
  }
}

}  // namespace
}  // namespace mien::command
