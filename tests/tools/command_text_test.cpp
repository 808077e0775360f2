// Man page and completion say what the command takes.

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::run_mien;
using test::ScratchFolder;

/// The long options in the help of `mien render`.
std::set<std::string> render_options() {
  const std::string help = run_mien({"render", "-h"}).out;
  const std::regex option("\n  (?:-\\w,)?(--[a-z-]+)");
  std::set<std::string> found;
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

TEST(Manual, NamesEveryOption) {
  std::string manual = run_mien({"manual"}).out;
  EXPECT_EQ(manual.find(".TH MIEN 1"), 0u);
  manual = std::regex_replace(manual, std::regex("\\\\-"), "-");
  ASSERT_GE(render_options().size(), 13u);
  for (const std::string& option : render_options()) {
    const bool named = manual.find(option + "\\fR") != std::string::npos ||
                       manual.find(option + ", --") != std::string::npos;  // of several names
    EXPECT_TRUE(named) << option;
  }
}

TEST(Completion, NamesEveryOptionForEveryShell) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string text = run_mien({"completion", shell}).out;
    for (const std::string& option : render_options()) {
      const std::string wanted = std::string(shell) == "fish" ? " -l " + option.substr(2) : option;
      EXPECT_NE(text.find(wanted), std::string::npos) << shell << " " << option;
    }
  }
}

/// Renewed by: build/release/mien manual --markdown >docs/command.md
TEST(CommandPage, IsWhatTheCommandWrites) {
  EXPECT_EQ(run_mien({"manual", "--markdown"}).out,
            test::read_text(MIEN_SOURCE_DIR "/docs/command.md"));
}

/// What bash offers for the words typed so far, the last one unfinished.
std::string offered(const std::string& words, int last) {
  const ScratchFolder folder;
  test::write_text(folder / "mien", run_mien({"completion", "bash"}).out);
  const std::string script = "source " + (folder / "mien").string() + "; COMP_WORDS=(" + words +
                             "); COMP_CWORD=" + std::to_string(last) +
                             "; _mien; echo ${COMPREPLY[@]}";
  return test::Process({"/bin/bash", "-c", script}).wait().out;
}

TEST(Completion, WorksInBash) {
  EXPECT_EQ(offered("mien re", 1), "render\n");
  EXPECT_EQ(offered("mien render --si", 2), "--size\n");
  EXPECT_EQ(offered("mien render face --fit sl", 4), "slice\n");
  EXPECT_EQ(offered("mien render face --depth = ''", 5), "8 16 half float\n");
}

}  // namespace
}  // namespace mien
