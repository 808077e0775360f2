#pragma once
// Files and runs of mien chernoff and mien stimuli.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/process/run_command.h"

namespace mien {

using test::Ran;
using test::run_mien;
using test::ScratchFolder;

/// A wrong file, and what is said of it.
struct WrongData {
  std::string what, sentence;
};

class DataTest : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  Ran chernoff(const std::string& table, const std::string& map) const {
    return run_mien({"chernoff", file("t.csv", table), "--map", file("m.json", map), "-o",
                     path("c.png"), "--manifest", path("c.csv"), "--legend", path("l.png"),
                     "--cell", "32"});
  }
  static std::string map(const std::string& features) {
    return R"({"format": "mien-chernoff", "format_version": 1, "label": "who", "map": [)" +
           features + "]}";
  }
  static std::string plan(const std::string& rest) {
    return R"({"format": "mien-stimuli", "format_version": 1, "size": 32, )" + rest + "}";
  }
  Ran stimuli(const std::string& what, const std::string& folder = "shown") const {
    return run_mien({"stimuli", file("plan.json", what), "-o", path(folder)});
  }
  std::size_t count(const std::string& folder) const {
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator(folder_ / folder))
      ++files;
    return files;
  }

  ScratchFolder folder_;
};

}  // namespace mien
