#include "tools/mien/http/http_server.h"
#include "lib/base/monotonic_seconds.h"
#include "tools/mien/http/connections.h"

#include <event2/buffer.h>
#include <event2/event.h>
#include <event2/http.h>
#include <event2/keyvalq_struct.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <mutex>
#include <unordered_set>
#include <vector>

namespace mien::command {
namespace {

constexpr double kLastAnswers = 5;           // [s] that who has asked before the end may wait
constexpr timeval kBetweenLooks{0, 10'000};  // whether they have them

template <auto kFree>
struct FreedBy {
  template <class T>
  void operator()(T* one) const {
    kFree(one);
  }
};
using Base = std::unique_ptr<event_base, FreedBy<&event_base_free>>;
using Http = std::unique_ptr<evhttp, FreedBy<&evhttp_free>>;
using Event = std::unique_ptr<event, FreedBy<&event_free>>;

/// What other threads have left to be done on the server's.
struct Mailbox {
  std::mutex mutex;
  std::vector<std::function<void()>> letters;
  const int bell = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);

  Mailbox() = default;
  Mailbox(const Mailbox&) = delete;
  ~Mailbox() { ::close(bell); }

  void leave(std::function<void()> letter) {
    {
      const std::lock_guard lock(mutex);
      letters.push_back(std::move(letter));
    }
    ::eventfd_write(bell, 1);
  }
  void empty() {
    eventfd_t rung = 0;
    ::eventfd_read(bell, &rung);
    std::vector<std::function<void()>> all;
    {
      const std::lock_guard lock(mutex);
      all.swap(letters);
    }
    for (const auto& letter : all) letter();
  }
};

bool is_head(evhttp_request* asked) {
  return evhttp_request_get_command(asked) == EVHTTP_REQ_HEAD;
}

void tell(evhttp_request* asked, const char* name, const std::string& value) {
  evhttp_add_header(evhttp_request_get_output_headers(asked), name, value.c_str());
}

/// The length of a file, whose bytes go behind the headers unless only those were asked for.
std::size_t add_file(evhttp_request* asked, int handle, std::size_t size) {
  // The buffer closes the file, when it has been sent or at once where it could not take it.
  if (is_head(asked) || size == 0 ||
      evbuffer_add_file(evhttp_request_get_output_buffer(asked), handle, 0, ev_off_t(size)) != 0)
    ::close(handle);
  return size;
}

std::size_t add_bytes(evhttp_request* asked, const HttpBytes& bytes) {
  if (!bytes) return 0;
  if (!is_head(asked) && !bytes->empty())
    evbuffer_add_reference(
        evhttp_request_get_output_buffer(asked), bytes->data(), bytes->size(),
        [](const void*, std::size_t, void* held) { delete static_cast<HttpBytes*>(held); },
        new HttpBytes(bytes));
  return bytes->size();
}

void send(evhttp_request* asked, const HttpAnswer& answer) {
  std::size_t size = 0;
  if (const auto* path = std::get_if<std::filesystem::path>(&answer.body)) {
    const int handle = ::open(path->c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status;
    if (handle < 0 || ::fstat(handle, &status) != 0) {
      if (handle >= 0) ::close(handle);
      return send(asked, told(kNotFound, "this file cannot be read"));
    }
    size = add_file(asked, handle, std::size_t(status.st_size));
  } else {
    size = add_bytes(asked, std::get<HttpBytes>(answer.body));
  }
  for (const auto& [name, value] : answer.headers) tell(asked, name, value);
  if (answer.code != kNotModified) tell(asked, "Content-Length", std::to_string(size));
  // A range may be asked for and is not given (RFC 9110, 14.2): the whole is what comes.
  tell(asked, "Accept-Ranges", "none");
  tell(asked, "X-Content-Type-Options", "nosniff");
  evhttp_send_reply(asked, answer.code, nullptr, nullptr);
}

/// [bytes] of the headers' names and values.
std::size_t head_size(evhttp_request* asked) {
  std::size_t size = 0;
  for (const evkeyval* one = evhttp_request_get_input_headers(asked)->tqh_first; one;
       one = one->next.tqe_next)
    size += std::strlen(one->key) + std::strlen(one->value);
  return size;
}

const char* header_of(evhttp_request* asked, const char* name) {
  const char* value = evhttp_find_header(evhttp_request_get_input_headers(asked), name);
  return value ? value : "";
}

/// The path and what follows it, also where a proxy was sent a whole address.
std::string target_of(evhttp_request* asked) {
  const char* const whole = evhttp_request_get_uri(asked);
  if (whole && *whole == '/') return whole;
  const evhttp_uri* const uri = evhttp_request_get_evhttp_uri(asked);
  const char* const path = uri ? evhttp_uri_get_path(uri) : nullptr;
  const char* const query = uri ? evhttp_uri_get_query(uri) : nullptr;
  return std::string(path && *path ? path : "/") + (query ? std::string("?") + query : "");
}

Error cannot_listen(const HttpPlace& place, int why) {
  if (why == EADDRINUSE)
    return {place.said, "another program has this port; port 0 takes one that is free"};
  if (why == EACCES)
    return {place.said, "this port is the administrator's; those from 1024 on are everybody's"};
  if (why == EADDRNOTAVAIL || why == 0)
    return {place.said, "this machine has no such address; 127.0.0.1 is its own, 0.0.0.0 all"};
  return {place.said, fmt::format("cannot listen: {}", std::strerror(why))};
}

std::uint16_t port_of(evhttp_bound_socket* socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  ::getsockname(evhttp_bound_socket_get_fd(socket), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.ss_family == AF_INET6
                   ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                   : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

timeval time_of(double seconds) {
  return {std::time_t(seconds), suseconds_t((seconds - std::floor(seconds)) * 1e6)};
}

}  // namespace

struct HttpServer::Parts {
  Mailbox mailbox;
  std::string address;
  std::uint16_t port = 0;
  std::size_t longest_head = 0;
  Base base;  // outlives what is in it
  std::optional<Connections> connections;
  std::unordered_set<evhttp_request*> unanswered;
  Http http;
  evhttp_bound_socket* socket = nullptr;
  HttpSite* site = nullptr;
  std::vector<Event> signals;
  Event bell, last_look;
  double ends_at = 0;  // [s] of the monotonic clock; 0: it goes on

  ~Parts();
  void come(evhttp_request* asked);
  void answer(evhttp_request* asked, const HttpAnswer& answer);
  void end();
  void end_if_done();
};

HttpServer::Parts::~Parts() {
  if (connections) connections->come_from(nullptr);
  // Those whose connection is there are its own; the others are nobody's but ours.
  for (evhttp_request* asked : unanswered)
    if (!evhttp_request_get_connection(asked)) evhttp_request_free(asked);
  unanswered.clear();
}

void HttpServer::Parts::come(evhttp_request* asked) {
  connections->has_asked(evhttp_request_get_connection(asked));
  evhttp_request_set_on_complete_cb(
      asked,
      [](evhttp_request* sent, void* parts) {
        static_cast<Parts*>(parts)->connections->is_awaited(evhttp_request_get_connection(sent));
      },
      this);
  const auto command = evhttp_request_get_command(asked);
  if (command != EVHTTP_REQ_GET && command != EVHTTP_REQ_HEAD) {
    HttpAnswer no = told(kNotAllowed, "only GET and HEAD are answered");
    no.headers.emplace_back("Allow", "GET, HEAD");
    return answer(asked, no);
  }
  if (head_size(asked) > longest_head)
    return answer(asked, told(kTooLongHead,
                              fmt::format("the headers have more than {} bytes", longest_head)));
  unanswered.insert(asked);
  const std::string target = target_of(asked);
  const char* const host = evhttp_request_get_host(asked);
  const auto now = site->answer({target, host ? host : "", header_of(asked, "If-None-Match")},
                                [this, asked](const HttpAnswer& later) { answer(asked, later); });
  if (now) answer(asked, *now);
}

void HttpServer::Parts::answer(evhttp_request* asked, const HttpAnswer& answer) {
  unanswered.erase(asked);
  // Where nobody waits for it any more, sending it is forgetting it.
  if (evhttp_connection* one = evhttp_request_get_connection(asked)) {
    connections->is_awaited(one);
    if (ends_at > 0) tell(asked, "Connection", "close");
  }
  send(asked, answer);
}

/// Nobody is let in any more, and who has asked gets an answer.
void HttpServer::Parts::end() {
  if (ends_at > 0) return;
  ends_at = monotonic_seconds() + kLastAnswers;
  connections->come_from(nullptr);
  evhttp_del_accept_socket(http.get(), socket);
  socket = nullptr;
  last_look.reset(event_new(
      base.get(), -1, EV_PERSIST,
      [](evutil_socket_t, short, void* parts) { static_cast<Parts*>(parts)->end_if_done(); },
      this));
  event_add(last_look.get(), &kBetweenLooks);
  end_if_done();
}

void HttpServer::Parts::end_if_done() {
  if ((unanswered.empty() && connections->all_sent()) || monotonic_seconds() > ends_at)
    event_base_loopbreak(base.get());
}

namespace {

/// libevent is C: no exception may pass through it.
template <class Parts>
void come_without_throwing(evhttp_request* asked, void* parts) noexcept {
  try {
    static_cast<Parts*>(parts)->come(asked);
  } catch (...) {
    static_cast<Parts*>(parts)->unanswered.erase(asked);
    evhttp_send_reply(asked, kBroken, nullptr, nullptr);
  }
}

}  // namespace

HttpServer::HttpServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
HttpServer::HttpServer(HttpServer&&) noexcept = default;
HttpServer::~HttpServer() = default;

Expected<HttpServer> HttpServer::on(const HttpPlace& place, const HttpLimits& limits) {
  auto parts = std::make_unique<Parts>();
  parts->base.reset(event_base_new());
  if (parts->base) parts->http.reset(evhttp_new(parts->base.get()));
  if (!parts->http) return Error{place.said, "cannot begin to serve"};
  evhttp* const http = parts->http.get();
  // libevent's own patience is for connections on which nothing happens; Connections has the last word.
  const timeval idle = time_of(limits.patience + 1);
  evhttp_set_timeout_tv(http, &idle);
  // Beyond these, libevent refuses by itself, without a sentence. A body is not wanted.
  evhttp_set_max_headers_size(http, ev_ssize_t(4 * limits.longest_head));
  evhttp_set_max_body_size(http, ev_ssize_t(4 * limits.longest_head));
  evhttp_set_allowed_methods(http, 0xffff);  // the answer to others says which are
  evhttp_set_gencb(http, come_without_throwing<Parts>, parts.get());
  parts->connections.emplace(parts->base.get(), http, limits.patience);
  errno = 0;
  parts->socket = evhttp_bind_socket_with_handle(http, place.address.c_str(), place.port);
  if (!parts->socket) return cannot_listen(place, errno);
  parts->connections->come_from(parts->socket);
  parts->address = place.address;
  parts->longest_head = limits.longest_head;
  parts->port = port_of(parts->socket);
  parts->bell.reset(event_new(
      parts->base.get(), parts->mailbox.bell, EV_READ | EV_PERSIST,
      [](evutil_socket_t, short, void* mailbox) { static_cast<Mailbox*>(mailbox)->empty(); },
      &parts->mailbox));
  event_add(parts->bell.get(), nullptr);
  return HttpServer(std::move(parts));
}

std::uint16_t HttpServer::port() const {
  return parts_->port;
}

std::string HttpServer::url() const {
  const bool numbers = parts_->address.find(':') != std::string::npos;
  return fmt::format("http://{}{}{}:{}/", numbers ? "[" : "", parts_->address, numbers ? "]" : "",
                     parts_->port);
}

HttpServer::Mail HttpServer::mail() {
  return [mailbox = &parts_->mailbox](std::function<void()> letter) {
    mailbox->leave(std::move(letter));
  };
}

void HttpServer::run(HttpSite& site) {
  parts_->site = &site;
  event_base* const base = parts_->base.get();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before;
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    parts_->signals.emplace_back(evsignal_new(
        base, signal,
        [](evutil_socket_t, short, void* parts) { static_cast<Parts*>(parts)->end(); },
        parts_.get()));
    evsignal_add(parts_->signals.back().get(), nullptr);
  }
  event_base_dispatch(base);
  parts_->site = nullptr;
}

}  // namespace mien::command
