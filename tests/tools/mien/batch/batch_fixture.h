#pragma once
// Plans, runs of mien batch and mien join, and what is in their folder then.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/support/process/run_command.h"

namespace mien {

using test::read_text;
using test::run_mien;
using test::write_text;

class BatchTest : public testing::Test {
 protected:
  using Ran = test::Ran;

  static std::string plan_of(const std::string& jobs) {
    return R"({"format": "mien-batch", "format_version": 1, "jobs": [)" + jobs + "]}";
  }
  /// `count` small people.
  static std::string people(int count, const std::string& size = "24") {
    return R"({"run": ["render", "{who}", "--size", ")" + size +
           R"("], "each": {"who": {"people": )" + std::to_string(count) +
           R"(, "seed": "ada"}}, "output": "crowd/{who}.png"})";
  }
  void plan(const std::string& jobs) const { write_text(folder_ / "plan.json", plan_of(jobs)); }
  std::vector<std::string> batch_words(const std::string& to, const std::string& part) const {
    std::vector<std::string> words{"batch", path("plan.json"), "-o", path(to)};
    if (!part.empty()) words.insert(words.end(), {"--part", part});
    return words;
  }
  Ran batch(const std::string& to = "out", const std::string& part = {}) const {
    return run_mien(batch_words(to, part));
  }
  Ran join(const std::string& to = "out") const {
    return run_mien({"join", path("plan.json"), path(to)});
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string manifest(const std::string& part, const std::string& to = "out") const {
    return path(to + "/manifest-" + part + ".jsonl");
  }
  /// Of every file in a folder, journals and all, by its name from there; manifests left out unless asked for.
  std::map<std::string, std::string> files(const std::string& to = "out",
                                           bool manifests = false) const {
    std::map<std::string, std::string> all;
    for (const auto& one : std::filesystem::recursive_directory_iterator(folder_ / to)) {
      const std::string name = one.path().lexically_relative(folder_ / to).string();
      if (one.is_regular_file() && (manifests || !name.starts_with("manifest-")))
        all[name] = read_text(one.path());
    }
    return all;
  }

  test::ScratchFolder folder_;
};

}  // namespace mien
