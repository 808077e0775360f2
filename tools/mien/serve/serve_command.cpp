// mien serve: pictures of faces over HTTP.

#include "lib/base/one_line.h"
#include "lib/parts/library/part_library.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/serve/face_site.h"
#include "tools/mien/terminal/messages.h"

#include <algorithm>
#include <thread>

namespace mien::command {
namespace {

constexpr std::uint16_t kDefaultServePort = 6437;           // beside the studio's
constexpr long kMostKept = 1 << 20, kMostQueued = 1 << 20;  // [MiB]; pictures

/// "127.0.0.1:8080", "[::1]:8080" or "8080".
Expected<HttpPlace> read_place(const std::string& text) {
  HttpPlace place{.said = "--listen " + one_line(text, 60)};
  const std::size_t colon = text.rfind(':');
  const auto port =
      read_whole("--listen", colon == text.npos ? text : text.substr(colon + 1), 0, 65535);
  std::string address = colon == text.npos ? place.address : text.substr(0, colon);
  const bool bracketed = address.starts_with('[') && address.ends_with(']');
  if (bracketed) address = address.substr(1, address.size() - 2);
  const bool plain = bracketed || address.find(':') == address.npos;
  if (!port || address.empty() || !plain)
    return Error{place.said, "expected ADDRESS:PORT, 127.0.0.1:8080 or [::1]:8080"};
  place.address = address;
  place.port = std::uint16_t(*port);
  return place;
}

/// Reads a whole number, if there is one.
template <class Number>
Expected<Done> read_count(Number& to, const char* option, const std::optional<std::string>& text,
                          long least, long most) {
  if (!text) return Done{};
  const auto number = read_whole(option, *text, least, most);
  if (!number) return number.error();
  to = Number(*number);
  return Done{};
}

Expected<FaceSiteOptions> read_site_options(const ServeArguments& arguments) {
  FaceSiteOptions options;
  long kept = 64;
  for (const auto& done :
       {read_count(options.limits.most_side, "--max-size", arguments.most_size, 1, View::kMaxSide),
        read_count(kept, "--cache", arguments.cache, 0, kMostKept),
        read_count(options.most_waiting, "--queue", arguments.queue, 1, kMostQueued)})
    if (!done) return done.error();
  options.cache = std::uint64_t(kept) << 20;
  if (arguments.timeout) {
    const auto timeout = read_real("--timeout", *arguments.timeout, 0.1, 3600);
    if (!timeout) return timeout.error();
    options.timeout = *timeout;
  }
  const auto threads = read_threads(arguments.threads.value_or("0"));
  if (!threads) return threads.error();
  options.threads =
      *threads > 0 ? *threads : int(std::max(1u, std::thread::hardware_concurrency()));
  return options;
}

}  // namespace

int serve_command(const ServeArguments& arguments) {
  const auto options = read_site_options(arguments);
  if (!options) return complain(options.error(), kUsedWrongly);
  const auto place =
      read_place(arguments.listen.value_or("127.0.0.1:" + std::to_string(kDefaultServePort)));
  if (!place) return complain(place.error(), kUsedWrongly);
  // The parts and letters are read before anybody waits for them.
  if (const auto parts = PartLibrary::shipped_or_why(); !parts)
    return complain(parts.error(), kFailed);
  (void)face_letters();
  auto server = HttpServer::on(*place, {.patience = options->timeout});
  if (!server) return complain(server.error(), kFailed);
  if (const int said = print(server->url() + "\n"); said != 0) return said;
  FaceSite site(*options, server->mail());
  server->run(site);
  return kDone;
}

}  // namespace mien::command
