#include "tools/mien/studio/loopback_server.h"

#include <arpa/inet.h>
#include <event2/buffer.h>
#include <event2/event.h>
#include <event2/http.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace mien::command {
namespace {

constexpr int kPatience = 60;  // [s] for a browser that neither asks nor takes
constexpr ev_ssize_t kLongestRequest =
    1 << 16;  // [bytes] of an asker's headers, and of a body that is not wanted

constexpr int kSeeOther = 302, kForbidden = 403, kNotFound = 404, kNotAllowed = 405,
              kMisdirected = 421, kBroken = 500;

template <auto kFree>
struct FreedBy {
  template <class T>
  void operator()(T* one) const {
    kFree(one);
  }
};
using Base = std::unique_ptr<event_base, FreedBy<&event_base_free>>;
using Http = std::unique_ptr<evhttp, FreedBy<&evhttp_free>>;
using Signal = std::unique_ptr<event, FreedBy<&event_free>>;

void tell(evhttp_request* asked, const char* name, const std::string& value) {
  evhttp_add_header(evhttp_request_get_output_headers(asked), name, value.c_str());
}

void refuse(evhttp_request* asked, int code, const char* sentence) {
  tell(asked, "Content-Type", "text/plain; charset=utf-8");
  const std::string text = std::string(sentence) + "\n";
  tell(asked, "Content-Length", std::to_string(text.size()));
  if (evhttp_request_get_command(asked) != EVHTTP_REQ_HEAD)
    evbuffer_add(evhttp_request_get_output_buffer(asked), text.data(), text.size());
  evhttp_send_reply(asked, code, nullptr, nullptr);
}

/// Pages of the network that give their own name this machine's address would read what is served here.
bool is_asked_by_our_name(evhttp_request* asked) {
  const char* host = evhttp_request_get_host(asked);
  return host && (std::strcmp(host, "127.0.0.1") == 0 || std::strcmp(host, "localhost") == 0);
}

std::string decoded_path(evhttp_request* asked) {
  const evhttp_uri* uri = evhttp_request_get_evhttp_uri(asked);
  const char* path = uri ? evhttp_uri_get_path(uri) : nullptr;
  std::size_t size = 0;
  std::unique_ptr<char, FreedBy<&std::free>> decoded(path ? evhttp_uridecode(path, 0, &size)
                                                          : nullptr);
  return decoded ? std::string(decoded.get(), size) : std::string();
}

void send(evhttp_request* asked, const WebFile& file) {
  const int handle = ::open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status;
  if (handle < 0 || ::fstat(handle, &status) != 0) {
    if (handle >= 0) ::close(handle);
    return refuse(asked, kNotFound, "this file cannot be read");
  }
  tell(asked, "Content-Type", std::string(file.type));
  tell(asked, "Content-Length", std::to_string(status.st_size));
  tell(asked, "Cache-Control", "no-cache");  // a package that is made again is seen at once
  tell(asked, "X-Content-Type-Options", "nosniff");
  // The buffer closes the file, when it has been sent or at once where it could not take it.
  const bool only_head = evhttp_request_get_command(asked) == EVHTTP_REQ_HEAD;
  if (only_head || status.st_size == 0 ||
      evbuffer_add_file(evhttp_request_get_output_buffer(asked), handle, 0, status.st_size) != 0)
    ::close(handle);
  evhttp_send_reply(asked, HTTP_OK, nullptr, nullptr);
}

void send_elsewhere(evhttp_request* asked, const Elsewhere& elsewhere) {
  std::unique_ptr<char, FreedBy<&std::free>> encoded(
      evhttp_uriencode(elsewhere.path.c_str(), -1, 0));
  std::string path;
  for (const char* at = encoded.get(); at && *at;) {  // slashes stay: they part the path
    const bool slash = std::strncmp(at, "%2F", 3) == 0;
    path += slash ? '/' : *at;
    at += slash ? 3 : 1;
  }
  tell(asked, "Location", path);
  refuse(asked, kSeeOther, "elsewhere");
}

void answer(evhttp_request* asked, const WebFolder& folder) {
  const auto command = evhttp_request_get_command(asked);
  if (command != EVHTTP_REQ_GET && command != EVHTTP_REQ_HEAD) {
    tell(asked, "Allow", "GET, HEAD");
    return refuse(asked, kNotAllowed, "only GET and HEAD are answered");
  }
  if (!is_asked_by_our_name(asked))
    return refuse(asked, kMisdirected, "only 127.0.0.1 and localhost are answered");
  const auto found = folder.at(decoded_path(asked));
  if (const auto* file = std::get_if<WebFile>(&found)) return send(asked, *file);
  if (const auto* elsewhere = std::get_if<Elsewhere>(&found))
    return send_elsewhere(asked, *elsewhere);
  if (std::get<NoFile>(found) == NoFile::forbidden)
    return refuse(asked, kForbidden, "this is outside of the folder");
  refuse(asked, kNotFound, "there is no such file");
}

/// libevent is C: no exception may pass through it.
void answer_without_throwing(evhttp_request* asked, void* folder) noexcept {
  try {
    answer(asked, *static_cast<const WebFolder*>(folder));
  } catch (...) {
    evhttp_send_reply(asked, kBroken, nullptr, nullptr);
  }
}

void stop(evutil_socket_t, short, void* base) {
  event_base_loopbreak(static_cast<event_base*>(base));
}

Error cannot_listen(std::uint16_t port, int why) {
  const std::string where = fmt::format("--port {}", port);
  if (why == EADDRINUSE)
    return {where, "another program has this port; --port 0 takes one that is free"};
  if (why == EACCES)
    return {where, "this port is the administrator's; those from 1024 on are everybody's"};
  return {where, fmt::format("cannot listen: {}", std::strerror(why))};
}

std::uint16_t port_of(evhttp_bound_socket* socket) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(evhttp_bound_socket_get_fd(socket), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

}  // namespace

struct LoopbackServer::Parts {
  WebFolder folder;
  Base base;  // outlives what is in it
  Http http;
  std::vector<Signal> signals;
  std::uint16_t port = 0;
};

LoopbackServer::LoopbackServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
LoopbackServer::LoopbackServer(LoopbackServer&&) noexcept = default;
LoopbackServer::~LoopbackServer() = default;

Expected<LoopbackServer> LoopbackServer::on(std::uint16_t port, WebFolder folder) {
  auto parts = std::make_unique<Parts>(Parts{std::move(folder), Base(event_base_new()), {}, {}});
  if (parts->base) parts->http.reset(evhttp_new(parts->base.get()));
  if (!parts->http) return Error{"studio", "cannot begin to serve"};
  evhttp* http = parts->http.get();
  evhttp_set_timeout(http, kPatience);
  evhttp_set_max_headers_size(http, kLongestRequest);
  evhttp_set_max_body_size(http, kLongestRequest);
  evhttp_set_allowed_methods(http, 0xffff);  // the answer to others says which are
  evhttp_set_gencb(http, answer_without_throwing, &parts->folder);
  errno = 0;
  evhttp_bound_socket* socket = evhttp_bind_socket_with_handle(http, "127.0.0.1", port);
  if (!socket) return cannot_listen(port, errno);
  parts->port = port_of(socket);
  return LoopbackServer(std::move(parts));
}

std::uint16_t LoopbackServer::port() const {
  return parts_->port;
}

void LoopbackServer::run() {
  event_base* base = parts_->base.get();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before;
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    parts_->signals.emplace_back(evsignal_new(base, signal, stop, base));
    evsignal_add(parts_->signals.back().get(), nullptr);
  }
  event_base_dispatch(base);
}

}  // namespace mien::command
