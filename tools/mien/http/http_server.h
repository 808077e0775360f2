#pragma once
// A server of HTTP/1.1. libevent speaks the protocol; a site answers.
//
//   auto server = HttpServer::on({.port = 8080}, {});
//   server->run(site);

#include <mien/expected.h>
#include "tools/mien/http/http_answer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace mien::command {

struct HttpPlace {
  std::string address = "127.0.0.1";  ///< or a name; IPv6 without brackets
  std::uint16_t port = 0;             ///< 0: any that is free
  std::string said = {};              ///< what errors call it: "--port 80"
};

struct HttpLimits {
  double patience = 60;              ///< [s] for a whole request, and for an answer to be taken
  std::size_t longest_head = 16384;  ///< [bytes] of a request's headers
};

class HttpServer {
 public:
  /// Listens from now on.
  static Expected<HttpServer> on(const HttpPlace& place, const HttpLimits& limits);

  HttpServer(HttpServer&&) noexcept;
  ~HttpServer();

  std::uint16_t port() const;
  /// "http://127.0.0.1:8080/"
  std::string url() const;

  /// Calls something on the server's thread while it runs; to be used on any thread, as long as the server is there.
  using Mail = std::function<void(std::function<void()>)>;
  Mail mail();

  /// Answers until SIGINT, SIGTERM or SIGHUP comes; then nobody is let in, and who has asked is answered, within a few
  /// seconds. Signals that the caller ignores stay ignored.
  void run(HttpSite& site);

 private:
  struct Parts;
  explicit HttpServer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace mien::command
