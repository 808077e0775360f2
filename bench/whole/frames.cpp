// Whole frames beside Cairo and beside the floor, in turns in one process: see `frames --help`.
//
// A frame of mien is pose, scene and draw into a warm RGBA8 buffer, mixed as encoded, as Cairo
// mixes; a frame of Cairo is clear and every figure, paths built anew, into a warm surface of the
// same kind of memory. That Cairo has ready what mien's frame makes, the posed scene and the
// outlines of tapered strokes, is told: "equal work" adds mien's time for these to Cairo's. The
// floor is the faster of filling that buffer with ordinary and with streaming stores. Every round
// takes each once; medians of the rounds are told, and their ratios.
// Frames are cold: two faces in a row have no point or length in common (Subject::face). Cairo
// remembers nothing, so it draws the same scene each time. Exit 1 if the pictures are not of the
// same thing.

#include <fmt/format.h>

#include <cstdio>

#include "bench/whole/beside_cairo.h"
#include "bench/whole/modes.h"
#include "bench/whole/old_command.h"
#include "bench/whole/reuse.h"
#include "bench/whole/thumbnails.h"

namespace mien::bench {
namespace {

std::vector<FrameCase> wanted_cases(const Options& options) {
  std::vector<FrameCase> wanted;
  for (const FrameCase& c : options.table == Table::reuse ? reuse_cases() : frame_cases()) {
    if ((long long)c.width * c.height <= options.most &&
        options.scenes.find(c.scene) != std::string::npos)
      wanted.push_back(c);
  }
  return wanted;
}

bool tell(const Options& options, const FrameCase& c) {
  if (options.table == Table::cairo) return beside_cairo(options, c);
  if (options.table == Table::old) return beside_old(options, c);
  if (options.table == Table::reuse) reuse(options, c);
  if (options.table == Table::mode) beside_encoded(options, c);
  return true;
}

std::string head(const Options& options) {
  if (options.json) return {};
  switch (options.table) {
    case Table::reuse:
      return reuse_head();
    case Table::old:
      return beside_old_head();
    case Table::mode:
      return beside_encoded_head(options);
    default:
      return beside_cairo_head();
  }
}

int main_of(int count, char** words) {
  bool help = false;
  const auto options = read_options(count, words, help);
  if (!options || help) {
    fmt::print(options ? stdout : stderr, "{}", help_text());
    return options ? 0 : 2;
  }
  if (options->table == Table::thumbnails) {
    thumbnails(*options);
    return 0;
  }
  const std::vector<FrameCase> wanted = wanted_cases(*options);
  if (wanted.empty()) {
    fmt::print(stderr, "nothing to measure: no scene of '{}' has at most {} pixels\n",
               options->scenes, options->most);
    return 2;
  }
  fmt::print("{}", head(*options));
  bool same = true;
  for (const FrameCase& c : wanted) {
    same &= tell(*options, c);
    std::fflush(stdout);
  }
  return same ? 0 : 1;
}

}  // namespace
}  // namespace mien::bench

int main(int count, char** words) {
  return mien::bench::main_of(count, words);
}
