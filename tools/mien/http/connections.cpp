#include "tools/mien/http/connections.h"
#include "lib/base/monotonic_seconds.h"

#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <event2/event.h>
#include <event2/http.h>
#include <event2/listener.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace mien::command {
namespace {

constexpr std::size_t kMostConnections = 1000;
constexpr std::size_t kOtherFiles = 64;  // that the process may have open beside them
constexpr timeval kLookEvery{0, 250'000};
constexpr double kForEver = std::numeric_limits<double>::infinity();

std::size_t most_connections() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0 || files.rlim_cur == RLIM_INFINITY)
    return kMostConnections;
  return std::clamp<std::size_t>(files.rlim_cur, kOtherFiles + 1, kMostConnections + kOtherFiles) -
         kOtherFiles;
}

}  // namespace

Connections::Connections(event_base* base, evhttp* http, double patience)
    : patience_(patience),
      most_(most_connections()),
      introduction_(event_new(base, -1, 0, &Connections::introduce, this)),
      look_(event_new(base, -1, EV_PERSIST, &Connections::end_late, this)) {
  evhttp_set_bevcb(http, &Connections::begin, this);
  event_add(look_, &kLookEvery);
}

Connections::~Connections() {
  for (bufferevent* one : unknown_) bufferevent_decref(one);
  event_free(introduction_);
  event_free(look_);
}

/// libevent asks for what a new connection reads and writes by; the connection itself is there a moment later.
bufferevent* Connections::begin(event_base* base, void* all) {
  auto* const self = static_cast<Connections*>(all);
  bufferevent* const made = bufferevent_socket_new(base, -1, 0);
  if (!made) return nullptr;
  bufferevent_incref(made);
  self->unknown_.push_back(made);
  event_active(self->introduction_, 0, 0);
  self->count();
  return made;
}

void Connections::introduce(int, short, void* all) {
  auto* const self = static_cast<Connections*>(all);
  for (bufferevent* one : std::exchange(self->unknown_, {})) {
    bufferevent_data_cb reads = nullptr;
    bufferevent_event_cb ends = nullptr;
    void* connection = nullptr;
    bufferevent_getcb(one, &reads, nullptr, &ends, &connection);
    // Without its calls it has been given up already.
    if (reads || ends) {
      auto* const known = static_cast<evhttp_connection*>(connection);
      evhttp_connection_set_closecb(known, &Connections::forget, self);
      self->until_[known] = monotonic_seconds() + self->patience_;
    }
    bufferevent_decref(one);
  }
  self->count();
}

void Connections::forget(evhttp_connection* one, void* all) {
  auto* const self = static_cast<Connections*>(all);
  self->until_.erase(one);
  self->count();
}

void Connections::end_late(int, short, void* all) {
  const double now = monotonic_seconds();
  for (const auto& [one, until] : static_cast<Connections*>(all)->until_)
    // libevent sees that the other side is gone, and clears away what belongs to it.
    if (until < now)
      ::shutdown(bufferevent_getfd(evhttp_connection_get_bufferevent(one)), SHUT_RDWR);
}

void Connections::count() {
  const bool open = until_.size() + unknown_.size() < most_;
  if (!socket_ || open == open_) return;
  open_ = open;
  evconnlistener* const listener = evhttp_bound_socket_get_listener(socket_);
  open ? evconnlistener_enable(listener) : evconnlistener_disable(listener);
}

void Connections::expect(evhttp_connection* one, double patience) {
  if (const auto found = until_.find(one); found != until_.end())
    found->second = monotonic_seconds() + patience;
}

void Connections::has_asked(evhttp_connection* one) {
  expect(one, kForEver);
}

void Connections::is_awaited(evhttp_connection* one) {
  expect(one, patience_);
}

bool Connections::all_sent() const {
  return std::ranges::all_of(until_, [](const auto& one) {
    bufferevent* const to = evhttp_connection_get_bufferevent(one.first);
    return evbuffer_get_length(bufferevent_get_output(to)) == 0;
  });
}

}  // namespace mien::command
