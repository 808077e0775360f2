// In place of loopback_server.cpp where mien is built without libevent, as for a wheel (-DMIEN_BUILD_STUDIO=OFF).

#include "tools/mien/studio/loopback_server.h"

namespace mien::command {

struct LoopbackServer::Parts {};

LoopbackServer::LoopbackServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
LoopbackServer::LoopbackServer(LoopbackServer&&) noexcept = default;
LoopbackServer::~LoopbackServer() = default;

Expected<LoopbackServer> LoopbackServer::on(std::uint16_t, WebFolder) {
  return Error{"studio",
               "this mien was built without a server (-DMIEN_BUILD_STUDIO=OFF); the web package's "
               "studio.html opens from the disk"};
}
std::uint16_t LoopbackServer::port() const {
  return 0;
}
void LoopbackServer::run() {}

}  // namespace mien::command
