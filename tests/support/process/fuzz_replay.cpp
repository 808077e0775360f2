// The short form of a fuzzer, for every suite and compiler: each file of the folders named, as it is
// and with seeded mutations. What the long form finds is kept beside the fuzzer in corpus/.
//
//   NAME_replay MUTATIONS PATH…      prints how many inputs went through

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bits = std::mt19937_64;  // the same numbers on every machine

std::size_t below(Bits& bits, std::size_t n) {
  return n ? std::size_t(bits() % n) : 0;
}

/// A span removed, doubled or moved, a byte changed, or a number put in a number's place.
std::string mutated(std::string text, Bits& bits) {
  static const char* const kNumbers[] = {"-1",     "1e308",      "0",    "-0.0",
                                         "1e-320", "4294967296", "\"\"", "[]"};
  const std::size_t at = below(bits, text.size()), length = 1 + below(bits, 40);
  switch (below(bits, 5)) {
    case 0:
      return text.erase(at, length);
    case 1:
      return text.insert(at, text.substr(at, length));
    case 2:
      return text.insert(below(bits, text.size()), text.substr(at, length));
    case 3:
      if (!text.empty()) text[at] = char(bits() & 0xff);
      return text;
    default: {
      const std::size_t from = text.find_first_of("-0123456789", at);
      if (from == std::string::npos) return text;
      const std::size_t to = text.find_first_not_of("-+.eE0123456789", from);
      return text.replace(from, to == std::string::npos ? to : to - from,
                          kNumbers[below(bits, std::size(kNumbers))]);
    }
  }
}

void feed(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

long replay(const std::filesystem::path& path, int mutations) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  feed(text);
  Bits bits(20260101);
  std::string changed = text;
  for (int i = 0; i < mutations; ++i) {
    changed = mutated(i % 4 ? std::move(changed) : text, bits);
    feed(changed);
  }
  return 1 + mutations;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const int mutations = std::atoi(argv[1]);
  long inputs = 0;
  for (int i = 2; i < argc; ++i)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i]))
      if (entry.is_regular_file()) inputs += replay(entry.path(), mutations);
  std::printf("%ld inputs\n", inputs);
  return inputs > 0 ? 0 : 1;
}
