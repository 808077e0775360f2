#pragma once
// Reading a bench's command line.

#include <functional>
#include <map>
#include <string_view>

namespace mien::bench {

/// "--json": what it does.
using Words = std::map<std::string_view, std::function<void()>>;
/// "--threads 2": what it does with "2", and whether that made sense.
using WordsWithValue = std::map<std::string_view, std::function<bool(const char*)>>;

/// False at the first word that makes no sense, which standard error names.
bool read_words(int count, char** words, const Words& alone, const WordsWithValue& with_value);

/// Draws with the instruction set of that name from now on. False if there is none here: standard
/// error names those that there are.
bool choose_instructions(std::string_view name);

}  // namespace mien::bench
