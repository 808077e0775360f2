// In place of http_server.cpp where mien is built without libevent, as for a wheel (-DMIEN_BUILD_SERVER=OFF).

#include "tools/mien/http/http_server.h"

namespace mien::command {

struct HttpServer::Parts {};

HttpServer::HttpServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
HttpServer::HttpServer(HttpServer&&) noexcept = default;
HttpServer::~HttpServer() = default;

Expected<HttpServer> HttpServer::on(const HttpPlace& place, const HttpLimits&) {
  return Error{place.said.empty() ? "server" : place.said,
               "this mien was built without a server (-DMIEN_BUILD_SERVER=OFF); the web package's "
               "studio.html opens from the disk"};
}
std::uint16_t HttpServer::port() const {
  return 0;
}
std::string HttpServer::url() const {
  return {};
}
HttpServer::Mail HttpServer::mail() {
  return {};
}
void HttpServer::run(HttpSite&) {}

}  // namespace mien::command
