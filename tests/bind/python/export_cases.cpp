// Stands for `mien-accuracy --export FILE --count N --seed S [--feet]`, which is not built with the tests.

#include <cstdlib>
#include <fstream>
#include <string>

#include "tools/accuracy/export.h"

int main(int argc, char** argv) {
  const bool feet = argc == 8 && std::string(argv[7]) == "--feet";
  const bool asked = (argc == 7 || feet) && std::string(argv[1]) == "--export" &&
                     std::string(argv[3]) == "--count" && std::string(argv[5]) == "--seed";
  const long count = asked ? std::atol(argv[4]) : -1;
  if (count < 0) return 2;
  std::ofstream file(argv[2], std::ios::binary);
  const auto seed = std::uint64_t(std::atol(argv[6]));
  if (feet) {
    mien::accuracy::write_feet_header(file, seed);
    for (const auto& family : mien::accuracy::feet_families())
      mien::accuracy::write_feet(file, family, std::size_t(count), seed);
  } else {
    mien::accuracy::write_cases_header(file, seed);
    for (const auto& family : mien::accuracy::bezier_families())
      mien::accuracy::write_cases(file, family, std::size_t(count), seed);
  }
  return file.flush() ? 0 : 1;
}
