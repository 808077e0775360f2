// mien serve under those who ask for too much, too slowly, or very often.

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/process/effort.h"
#include "tests/support/process/web_peer.h"

namespace mien {
namespace {

using test::code_of;
using test::header_of;
using test::WebPeer;

std::vector<std::string> serve(std::vector<std::string> more) {
  more.insert(more.begin(), {"serve", "--listen", "127.0.0.1:0"});
  return more;
}

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// [KiB] that a process holds in memory.
long resident(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
  return -1;
}

/// Whether the other side has closed.
bool is_closed(int handle) {
  char byte;
  const ssize_t n = ::recv(handle, &byte, 1, MSG_DONTWAIT | MSG_PEEK);
  return n == 0 || (n < 0 && errno != EAGAIN);
}

TEST(ServeLoad, DropsWhoAsksSlowly) {
  const WebPeer faces(serve({"--timeout", "0.5"}));
  const int silent = faces.connected(), slow = faces.connected();
  const std::string request = faces.request("/healthz");
  const auto began = std::chrono::steady_clock::now();
  std::size_t sent = 0;
  while (!is_closed(slow) && sent + 1 < request.size()) {
    ::send(slow, &request[sent++], 1, MSG_NOSIGNAL);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_TRUE(is_closed(slow)) << "a byte now and then is not enough";
  EXPECT_GE(seconds_since(began), 0.4);
  EXPECT_EQ(test::WebPeer::heard(silent), "");
  ::close(slow);
  EXPECT_EQ(code_of(faces.get("/healthz")), "200") << "others are served";
}

TEST(ServeLoad, DropsWhoTakesSlowly) {
  const WebPeer faces(serve({"--timeout", "1"}));
  const int handle = faces.connected();
  const int small = 4096;
  ::setsockopt(handle, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
  constexpr int kAsked = 2000;
  std::string all;
  for (int i = 0; i < kAsked; ++i) all += faces.request("/seed/a.png?size=256");
  std::size_t sent = 0;
  const auto began = std::chrono::steady_clock::now();
  // It stops reading when its answers are not taken, so not all may go.
  while (sent < all.size() && seconds_since(began) < 20) {
    const ssize_t n =
        ::send(handle, all.data() + sent, all.size() - sent, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (n < 0 && errno != EAGAIN) break;
    if (n > 0)
      sent += std::size_t(n);
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (seconds_since(began) > 4) break;
  }
  std::this_thread::sleep_for(std::chrono::seconds(2));
  const std::string answers = test::WebPeer::heard(handle);
  int whole = 0;
  for (std::size_t at = 0; (at = answers.find("HTTP/1.1 200", at)) != answers.npos; ++at) ++whole;
  EXPECT_LT(whole, kAsked);
  EXPECT_EQ(code_of(faces.get("/healthz")), "200") << "others are served";
}

TEST(ServeLoad, TellsWhoComesTooLateToAskAgain) {
  const WebPeer faces(serve({"--threads", "1", "--queue", "2", "--timeout", "60"}));
  std::vector<int> handles;
  for (int i = 0; i < 20; ++i) {
    handles.push_back(faces.connected());
    WebPeer::say(handles.back(), faces.request("/seed/" + std::to_string(i) + ".png?size=700",
                                               "GET", "127.0.0.1", "Connection: close\r\n"));
  }
  int drawn = 0, told = 0;
  for (const int handle : handles) {
    const std::string answer = WebPeer::heard(handle);
    drawn += code_of(answer) == "200";
    if (code_of(answer) != "503") continue;
    ++told;
    EXPECT_EQ(header_of(answer, "Retry-After"), "1");
    EXPECT_EQ(header_of(answer, "Cache-Control"), "no-store");
  }
  EXPECT_GE(drawn, 2) << "as many as may wait, and one more if the thread was quick";
  EXPECT_GE(told, 1);
  EXPECT_EQ(drawn + told, 20);
}

TEST(ServeLoad, AnswersManyWhoAskForOnePicture) {
  const WebPeer faces(serve({"--threads", "1", "--queue", "1"}));
  std::vector<int> handles;
  for (int i = 0; i < 20; ++i) {
    handles.push_back(faces.connected());
    WebPeer::say(handles.back(), faces.request("/seed/one.png?size=400", "GET", "127.0.0.1",
                                               "Connection: close\r\n"));
  }
  std::string first;
  for (const int handle : handles) {
    const std::string answer = WebPeer::heard(handle);
    EXPECT_EQ(code_of(answer), "200") << "it is drawn once";
    if (first.empty()) first = test::body_of(answer);
    EXPECT_TRUE(test::body_of(answer) == first);
  }
}

TEST(ServeLoad, GivesUpWhatTakesTooLong) {
  const WebPeer faces(serve({"--timeout", "0.1", "--max-size", "6000"}));
  const std::string answer = faces.get("/seed/a.png?size=6000&style=vinyl");
  EXPECT_EQ(code_of(answer), "503");
  EXPECT_EQ(test::body_of(answer), "this takes longer than the 0.1 s that it may\n");
}

TEST(ServeLoad, KeepsItsMemory) {
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer keeps what is freed";
  const WebPeer faces(serve({"--threads", "1", "--cache", "1"}));
  const auto ask = [&](int from, int count) {
    const int handle = faces.connected();
    std::string all;
    for (int i = from; i < from + count; ++i)
      all += faces.request(i % 5 ? "/seed/" + std::to_string(i % 7) + ".png?size=16&blink=0." +
                                       std::to_string(i % 9)
                                 : "/seed/a.png?size=x" + std::to_string(i));
    all += faces.request("/healthz", "GET", "127.0.0.1", "Connection: close\r\n");
    // Answers are taken while it asks: neither side waits for the other.
    std::thread asking([&] { WebPeer::say(handle, all); });
    std::string answers;
    char some[1 << 16];
    for (ssize_t n; (n = ::recv(handle, some, sizeof some, 0)) > 0;)
      answers.append(some, std::size_t(n));
    asking.join();
    ::close(handle);
    EXPECT_TRUE(answers.ends_with("\r\n\r\nok\n"));
  };
  ask(0, 500);
  const long before = resident(faces.id());
  for (int round = 0; round < 10; ++round) ask(round * 500, 500);
  for (int i = 0; i < 300; ++i) ::close(faces.connected());
  EXPECT_LT(resident(faces.id()) - before, 4096) << "[KiB], from " << before;
}

}  // namespace
}  // namespace mien
