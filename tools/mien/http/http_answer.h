#pragma once
// What a server is asked and what it answers, whatever speaks the protocol.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace mien::command {

/// A GET or HEAD. The texts last as long as the call.
struct HttpAsked {
  std::string_view target;         ///< as it came: "/a%20b?c=d"
  std::string_view host;           ///< without its port; empty: none was said
  std::string_view if_none_match;  ///< empty: none was said
};

inline constexpr int kOk = 200, kSeeOther = 302, kNotModified = 304, kWrong = 400, kForbidden = 403,
                     kNotFound = 404, kNotAllowed = 405, kTooLongTarget = 414, kMisdirected = 421,
                     kTooLongHead = 431, kBroken = 500, kUnavailable = 503;

/// Bytes that several answers may share.
using HttpBytes = std::shared_ptr<const std::string>;

struct HttpAnswer {
  int code = kOk;
  std::vector<std::pair<const char*, std::string>> headers;  ///< but for Content-Length
  std::variant<HttpBytes, std::filesystem::path> body;       ///< no bytes: empty
};

/// A sentence for people.
HttpAnswer told(int code, const std::string& sentence);

/// What answers. All of it happens on the server's own thread.
class HttpSite {
 public:
  using Later = std::function<void(HttpAnswer)>;

  virtual ~HttpSite() = default;
  /// Nothing: `later` is called once, on the server's thread, or never where the server ends before.
  virtual std::optional<HttpAnswer> answer(const HttpAsked& asked, const Later& later) = 0;
};

}  // namespace mien::command
