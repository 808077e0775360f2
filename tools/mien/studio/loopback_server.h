#pragma once
// Serves a folder over HTTP on the loopback, to browsers of this machine alone. libevent speaks the protocol.

#include <mien/expected.h>
#include "tools/mien/studio/web_folder.h"

#include <cstdint>
#include <memory>

namespace mien::command {

class LoopbackServer {
 public:
  /// Listens on a port of 127.0.0.1 from now on; 0: any that is free.
  static Expected<LoopbackServer> on(std::uint16_t port, WebFolder folder);

  LoopbackServer(LoopbackServer&&) noexcept;
  ~LoopbackServer();

  std::uint16_t port() const;

  /// Answers until SIGINT, SIGTERM or SIGHUP comes. Those that the caller ignores stay ignored.
  void run();

 private:
  struct Parts;
  explicit LoopbackServer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace mien::command
