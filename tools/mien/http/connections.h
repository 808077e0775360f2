#pragma once
// The connections of a server: how many there may be, and how long each may take.
//
// libevent ends a connection on which nothing happens. One that sends a byte now and then, or takes one, would stay for
// ever, so each has a moment by which it must have asked, and one by which it must have taken the answer.

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

struct bufferevent;
struct event;
struct event_base;
struct evhttp;
struct evhttp_bound_socket;
struct evhttp_connection;

namespace mien::command {

class Connections {
 public:
  /// All that `http` takes from now on. `patience` [s]: for a request, and then for its answer to be taken.
  Connections(event_base* base, evhttp* http, double patience);
  Connections(const Connections&) = delete;
  ~Connections();

  /// Where they come from: while there are as many as may be, nobody is let in. Null: from nowhere any more.
  void come_from(evhttp_bound_socket* socket) { socket_ = socket; }

  /// It has asked, and waits for us as long as we please.
  void has_asked(evhttp_connection* one);
  /// We wait for it: to take an answer, or to ask again.
  void is_awaited(evhttp_connection* one);

  /// Whether all that was to be sent has been.
  bool all_sent() const;

 private:
  static bufferevent* begin(event_base* base, void* all);
  static void introduce(int, short, void* all);
  static void end_late(int, short, void* all);
  static void forget(evhttp_connection* one, void* all);
  void count();
  void expect(evhttp_connection* one, double patience);

  const double patience_;
  std::size_t most_;
  evhttp_bound_socket* socket_ = nullptr;
  bool open_ = true;                                      ///< whether new ones are let in
  event *introduction_, *look_;                           ///< soon; now and then
  std::vector<bufferevent*> unknown_;                     ///< that have no connection yet
  std::unordered_map<evhttp_connection*, double> until_;  ///< [s] of the monotonic clock
};

}  // namespace mien::command
