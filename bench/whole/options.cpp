#include "bench/whole/options.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "bench/whole/command_words.h"

namespace mien::bench {
namespace {

constexpr std::string_view kHelp =
    R"(frames [--scenes LETTERS] [--most PIXELS] [--threads N] [--instructions NAME]
       [--rounds N] [--seconds S] [--json]
       [--reuse | --old PROGRAM | --blend linear --depth 16|float | --thumbnails]

Whole frames beside Cairo and beside the floor, in turns in one process: medians and ratios.
Scenes: A seed0, B male, C toon, D bruno, E clay, F bruno without reliefs, all of faces/compat/.

Cairo is given two things that mien's frame makes: the posed scene, and the outlines of tapered
strokes, fitted by mien to 1/100 px. "given" is the time in which mien makes them, and "equal work"
is the frame beside Cairo's time and that one; "frame/Cairo" leaves it out.

Frames are cold: each is of a face whose points and lengths are all a hundred-thousandth smaller
than in the frame before, so nothing made for one is of use for the next, and the renderer keeps no
rows. `mien bench` does so, too. --reuse alone looks at what a renderer keeps.

  --scenes LETTERS     these scenes only
  --most PIXELS        no picture of more pixels (640 x 360 has 230400)
  --threads N          threads that mien draws with (1); Cairo has one
  --instructions NAME  AVX3, AVX2, SSE4, …: instead of the best there is
  --rounds N           rounds of a case, instead of 201 to 7 by size
  --seconds S          no further round of a case after that time (20), three rounds aside
  --json               a line of JSON for each case

Instead of the table beside Cairo:
  --reuse              what a renderer gains from the frame before, all five faces at 640 x 360: a
                       frame like the one before, one in which the eyes alone have moved, and one in
                       which the lids have, beside cold ones of the same poses
  --old PROGRAM        another build's `mien` command, run by its own `mien bench` in turns with
                       this build's frames, out of the same face files; --rounds: frames of a
                       run. It chooses its own instructions: --instructions does not go with it
  --blend linear, --depth 16, --depth float
                       frames mixed or stored like that beside the same frames mixed as encoded and
                       stored in 8 bits
  --thumbnails         1000 thumbnails of toon, 128 x 72, at 1000 poses, on --threads threads:
                       seconds in all
)";

bool choose_depth(Options& options, std::string_view name) {
  options.table = Table::mode;
  options.depth = name == "16" ? Depth::u16 : name == "float" ? Depth::f32 : Depth::u8;
  return name == "8" || name == "16" || name == "float";
}

bool choose_blend(Options& options, std::string_view name) {
  options.table = Table::mode;
  options.blend = name == "linear" ? Blend::linear : Blend::srgb;
  return name == "linear" || name == "srgb";
}

Words words_of(Options& options, bool& help) {
  return {{"--json", [&] { options.json = true; }},
          {"--reuse", [&] { options.table = Table::reuse; }},
          {"--thumbnails", [&] { options.table = Table::thumbnails; }},
          {"--help", [&] { help = true; }}};
}

WordsWithValue words_with_value_of(Options& options) {
  return {{"--threads", [&](const char* v) { return (options.threads = std::atoi(v)) >= 0; }},
          {"--rounds", [&](const char* v) { return (options.rounds = std::atoi(v)) > 0; }},
          {"--seconds", [&](const char* v) { return (options.seconds = std::atof(v)) > 0; }},
          {"--most", [&](const char* v) { return (options.most = std::atoll(v)) > 0; }},
          {"--scenes", [&](const char* v) { return !(options.scenes = v).empty(); }},
          {"--blend", [&](const char* v) { return choose_blend(options, v); }},
          {"--depth", [&](const char* v) { return choose_depth(options, v); }},
          {"--old",
           [&](const char* v) {
             options.table = Table::old;
             return !(options.old = v).empty();
           }},
          {"--instructions", [&](const char* v) {
             options.best_instructions = false;
             return choose_instructions(v);
           }}};
}

}  // namespace

std::optional<Options> read_options(int count, char** words, bool& help) {
  Options options;
  if (!read_words(count, words, words_of(options, help), words_with_value_of(options))) return {};
  if (options.table == Table::old && !options.best_instructions) {
    fmt::print(stderr, "--instructions does not go with --old\n");
    return {};
  }
  return options;
}

std::string help_text() {
  return std::string(kHelp);
}

}  // namespace mien::bench
