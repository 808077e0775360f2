#pragma once
// `mien studio` or `mien serve` in a process of its own, and bytes said to it over a socket.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/process/end_process.h"
#include "tests/support/process/run_command.h"

namespace mien::test {

/// From its address on. It is asked for a port that is free unless its words say which.
class WebPeer {
 public:
  explicit WebPeer(const std::vector<std::string>& words)
      : process_(start_mien(words, (scratch_ / "said").string())) {
    for (int i = 0; i < 6000 && address_.empty(); ++i) {
      const std::string said = read_text(scratch_ / "said");
      if (said.ends_with('\n')) address_ = said.substr(0, said.size() - 1);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    const std::size_t colon = address_.rfind(':');
    EXPECT_NE(colon, address_.npos) << "after a minute there is no address";
    if (colon != address_.npos) port_ = std::atoi(address_.c_str() + colon + 1);
  }
  WebPeer(const WebPeer&) = delete;
  ~WebPeer() {
    if (!ended_) end(SIGKILL);
  }

  const std::string& address() const { return address_; }
  int port() const { return port_; }
  pid_t id() const { return process_.id(); }

  Ran end(int signal) {
    ended_ = true;
    end_process(process_.id(), signal);
    return process_.wait();
  }

  /// A socket to it; to be closed by whoever asked.
  int connected() const {
    const int handle = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const timeval patience{60, 0};
    ::setsockopt(handle, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    sockaddr_in to{};
    to.sin_family = AF_INET, to.sin_port = htons(std::uint16_t(port_));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(handle, reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
    return handle;
  }
  static void say(int handle, const std::string& bytes) {
    EXPECT_EQ(::send(handle, bytes.data(), bytes.size(), MSG_NOSIGNAL), ssize_t(bytes.size()));
  }
  /// All that it says until it closes; closes, too.
  static std::string heard(int handle) {
    std::string answer;
    char some[4096];
    for (ssize_t n; (n = ::recv(handle, some, sizeof some, 0)) > 0;)
      answer.append(some, std::size_t(n));
    ::close(handle);
    return answer;
  }

  /// What it answers to these bytes.
  std::string asked(const std::string& bytes) const {
    const int handle = connected();
    say(handle, bytes);
    return heard(handle);
  }
  /// `headers`: whole lines.
  std::string get(const std::string& target, const std::string& method = "GET",
                  const std::string& host = "127.0.0.1", const std::string& headers = {}) const {
    return asked(request(target, method, host, headers + "Connection: close\r\n"));
  }
  std::string request(const std::string& target, const std::string& method = "GET",
                      const std::string& host = "127.0.0.1",
                      const std::string& headers = {}) const {
    return method + " " + target + " HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port_) +
           "\r\n" + headers + "\r\n";
  }

 private:
  ScratchFolder scratch_;
  Process process_;
  std::string address_;
  int port_ = 0;
  bool ended_ = false;
};

inline bool has(const std::string& answer, const std::string& text) {
  return answer.find(text) != answer.npos;
}
inline std::string code_of(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") ? answer.substr(9, 3) : answer;
}
inline std::string body_of(const std::string& answer) {
  const std::size_t end = answer.find("\r\n\r\n");
  return end == answer.npos ? "" : answer.substr(end + 4);
}
/// The value of a header; empty if it is not there.
inline std::string header_of(const std::string& answer, const std::string& name) {
  const std::size_t at = answer.substr(0, answer.find("\r\n\r\n") + 2).find("\r\n" + name + ": ");
  if (at == answer.npos) return {};
  const std::size_t from = at + name.size() + 4;
  return answer.substr(from, answer.find("\r\n", from) - from);
}

}  // namespace mien::test
