#pragma once
// Which planted fault a program of tools/mutants runs with: the number in MIEN_MUTANT, none without it. Only copies of the
// tree that tools/mutants makes include this file.

#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace mien::mutants {

/// At the end of a program, appends the numbers of the faults whose places it came through to the file MIEN_REACHED.
struct Reached {
  unsigned char at[2048] = {};

  ~Reached() {
    const char* path = std::getenv("MIEN_REACHED");
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    if (!file) return;
    for (int number = 0; number < 2048; ++number) {
      if (at[number]) std::fprintf(file, "%d\n", number);
    }
    std::fclose(file);
  }
};

inline Reached reached;
inline const int chosen = std::getenv("MIEN_MUTANT") ? std::atoi(std::getenv("MIEN_MUTANT")) : -1;

inline bool on_now(int number) {
  reached.at[number] = 1;
  return number == chosen;
}

constexpr bool on(int number) {
  return std::is_constant_evaluated() ? false : on_now(number);
}

}  // namespace mien::mutants
