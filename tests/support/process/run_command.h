#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/faces/face_path.h"
#include "tests/support/process/scratch_folder.h"

namespace mien::test {

/// What a process left.
struct Ran {
  int code = -1;   ///< exit code; −1 if a signal ended it
  int signal = 0;  ///< that signal
  std::string out, err;
};

/// A program in a process of its own. Its output goes to files, so that it never waits for its
/// reader.
class Process {
 public:
  /// `out`: where standard output goes instead, if given. `environment`: NAME=VALUE, instead of what is inherited.
  explicit Process(const std::vector<std::string>& words, const std::string& out = {},
                   const std::vector<std::string>& environment = {})
      : out_(out.empty() ? (files_ / "out").string() : out) {
    std::vector<char*> argv, envp;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    for (const std::string& word : environment) envp.push_back(const_cast<char*>(word.c_str()));
    const auto is_given = [&](const std::string_view inherited) {
      return std::any_of(environment.begin(), environment.end(), [&](const std::string& word) {
        return inherited.starts_with(word.substr(0, word.find('=') + 1));
      });
    };
    for (char** e = environ; *e; ++e)
      if (!is_given(*e)) envp.push_back(*e);
    argv.push_back(nullptr);
    envp.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                       0600);
    ::posix_spawn_file_actions_addopen(&actions, 2, (files_ / "err").c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int failed = ::posix_spawn(&id_, argv[0], &actions, nullptr, argv.data(), envp.data());
    ::posix_spawn_file_actions_destroy(&actions);
    if (failed) ADD_FAILURE() << "cannot start " << words[0];
  }

  pid_t id() const { return id_; }

  /// Waits for its end.
  Ran wait() {
    int status = 0;
    ::waitpid(id_, &status, 0);
    Ran ran;
    if (WIFEXITED(status)) ran.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ran.signal = WTERMSIG(status);
    if (std::filesystem::is_regular_file(out_)) ran.out = read_text(out_);
    ran.err = read_text(files_ / "err");
    return ran;
  }

 private:
  ScratchFolder files_;
  std::string out_;
  pid_t id_ = -1;
};

/// `mien` with these arguments, to its end.
inline Process start_mien(std::vector<std::string> arguments, const std::string& out = {},
                          const std::vector<std::string>& environment = {}) {
  arguments.insert(arguments.begin(), MIEN_COMMAND);
  return Process(arguments, out, environment);
}
inline Ran run_mien(const std::vector<std::string>& arguments, const std::string& out = {},
                    const std::vector<std::string>& environment = {}) {
  return start_mien(arguments, out, environment).wait();
}

}  // namespace mien::test
