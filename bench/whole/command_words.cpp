#include "bench/whole/command_words.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "sdf/distance/instruction_sets.h"

namespace mien::bench {

bool read_words(int count, char** words, const Words& alone, const WordsWithValue& with_value) {
  for (int i = 1; i < count; ++i) {
    if (const auto word = alone.find(words[i]); word != alone.end()) {
      word->second();
      continue;
    }
    const auto other = with_value.find(words[i]);
    const bool has_value = other != with_value.end() && i + 1 < count;
    if (has_value && other->second(words[i + 1])) {
      ++i;
      continue;
    }
    fmt::print(stderr, "not understood: {}{}{}\n", words[i], has_value ? " " : "",
               has_value ? words[i + 1] : "");
    return false;
  }
  return true;
}

bool choose_instructions(std::string_view name) {
  std::string there;
  for (const batch::InstructionSet& set : batch::instruction_sets()) {
    if (set.name == name) {
      batch::use_instruction_set(set.id);
      return true;
    }
    there += fmt::format(" {}", set.name);
  }
  fmt::print(stderr, "this build has on this machine:{}\n", there);
  return false;
}

}  // namespace mien::bench
