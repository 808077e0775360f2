#include "tests/exactness/arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <string_view>

namespace mien::test {
namespace {

bool read_number(std::string_view text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && number >= 1;
}

/// Leaves those storages of which `keep` holds.
template <class Keep>
void keep_storages(Wanted& wanted, Keep keep) {
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = wanted[i] && keep(kStorages[i]);
}

bool read_process(std::string_view text, ExactnessArguments& out) {
  const std::size_t slash = text.find('/');
  int process = 0;
  if (slash == text.npos || !read_number(text.substr(0, slash), process) ||
      !read_number(text.substr(slash + 1), out.processes) || process > out.processes)
    return false;
  out.process = process - 1;
  return true;
}

bool read_word(std::string_view name, const std::string& value, ExactnessArguments& out) {
  int number = 0;
  if (name == "--face") return out.faces.push_back(value), true;
  if (name == "--pose") return out.poses.push_back(value), true;
  if (name == "--processes") return read_process(value, out);
  if (name == "--blend") {
    if (value != "srgb" && value != "linear") return false;
    const Blend blend = value == "srgb" ? Blend::srgb : Blend::linear;
    keep_storages(out.storages, [&](const Storage& s) { return s.blend == blend; });
    return true;
  }
  if (!read_number(value, number)) return false;
  if (name == "--depth") {
    keep_storages(out.storages, [&](const Storage& s) { return (s.top == 255) == (number == 8); });
    return number == 8 || number == 16;
  }
  if (name == "--size") return out.sizes.push_back(number), true;
  if (name == "--windows") return out.windows = number, true;
  if (name == "--every") return out.every = number, true;
  if (name == "--seed") return out.seed = std::uint64_t(number), true;
  if (name == "--first") return out.first = number, true;
  return false;
}

}  // namespace

std::optional<ExactnessArguments> read_exactness_arguments(int count, char** words) {
  ExactnessArguments out;
  for (int i = 1; i < count; ++i) {
    const std::string name = words[i];
    if (name == "--unlit") {
      out.lit = false;
    } else if (name == "-h" || name == "--help") {
      fmt::print("{}", kExactnessUse);
      return std::nullopt;
    } else if (i + 1 == count || !read_word(name, words[i + 1], out)) {
      fmt::print(stderr, "not understood: {} {}\n{}", name, i + 1 < count ? words[i + 1] : "",
                 kExactnessUse);
      return std::nullopt;
    } else {
      ++i;
    }
  }
  return out;
}

}  // namespace mien::test
