#include "bench/whole/options.h"

#include <mien/sdf/batch/instruction_sets.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <string_view>

namespace mien::bench {
namespace {

constexpr std::string_view kHelp =
    R"(frames [--scenes LETTERS] [--most PIXELS] [--threads N] [--instructions NAME]
       [--rounds N] [--seconds S] [--json] [--reuse]

Whole frames beside Cairo and beside the floor, in turns in one process: medians and ratios.
Scenes: A seed0, B male, C toon, D bruno, E clay, F bruno without reliefs.

Frames are cold: each is of a face whose points and lengths are all a hundred-thousandth smaller
than in the frame before, so nothing made for one is of use for the next. `mien bench` does so, too.

  --scenes LETTERS     these scenes only
  --most PIXELS        no picture larger than that
  --threads N          threads that mien draws with (1); Cairo has one
  --instructions NAME  AVX3, AVX2, SSE4, …: instead of the best there is
  --rounds N           rounds of a case, instead of 201 to 7 by size
  --seconds S          no further round of a case after that time (20), three rounds aside
  --json               a line of JSON for each case
  --reuse              instead: a frame like the one before, and one in which the eyes alone have
                       moved, beside a cold one
)";

bool choose_instructions(std::string_view name) {
  for (const batch::InstructionSet& set : batch::instruction_sets()) {
    if (set.name == name) {
      batch::use_instruction_set(set.id);
      return true;
    }
  }
  return false;
}

using Words = std::map<std::string_view, std::function<void()>>;
using WordsWithValue = std::map<std::string_view, std::function<bool(const char*)>>;

Words words_of(Options& options, bool& help) {
  return {{"--json", [&] { options.json = true; }},
          {"--reuse", [&] { options.reuse = true; }},
          {"--help", [&] { help = true; }}};
}

WordsWithValue words_with_value_of(Options& options) {
  return {{"--threads", [&](const char* v) { return (options.threads = std::atoi(v)) >= 0; }},
          {"--rounds", [&](const char* v) { return (options.rounds = std::atoi(v)) > 0; }},
          {"--seconds", [&](const char* v) { return (options.seconds = std::atof(v)) > 0; }},
          {"--most", [&](const char* v) { return (options.most = std::atoll(v)) > 0; }},
          {"--scenes", [&](const char* v) { return !(options.scenes = v).empty(); }},
          {"--instructions", choose_instructions}};
}

}  // namespace

std::optional<Options> read_options(int count, char** words, bool& help) {
  Options options;
  const Words alone = words_of(options, help);
  const WordsWithValue with_value = words_with_value_of(options);
  for (int i = 1; i < count; ++i) {
    if (const auto word = alone.find(words[i]); word != alone.end()) {
      word->second();
    } else if (const auto other = with_value.find(words[i]); other != with_value.end()) {
      if (++i == count || !other->second(words[i])) return {};
    } else {
      return {};
    }
  }
  return options;
}

std::string help_text() {
  return std::string(kHelp);
}

}  // namespace mien::bench
