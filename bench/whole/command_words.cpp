#include "bench/whole/command_words.h"

#include "sdf/distance/instruction_sets.h"

namespace mien::bench {

bool read_words(int count, char** words, const Words& alone, const WordsWithValue& with_value) {
  for (int i = 1; i < count; ++i) {
    if (const auto word = alone.find(words[i]); word != alone.end()) {
      word->second();
    } else if (const auto other = with_value.find(words[i]); other != with_value.end()) {
      if (++i == count || !other->second(words[i])) return false;
    } else {
      return false;
    }
  }
  return true;
}

bool choose_instructions(std::string_view name) {
  for (const batch::InstructionSet& set : batch::instruction_sets()) {
    if (set.name == name) {
      batch::use_instruction_set(set.id);
      return true;
    }
  }
  return false;
}

}  // namespace mien::bench
