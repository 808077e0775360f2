#pragma once
// Faces as a site: /CODE.png, /seed/WORD.svg, drawn on threads of its own; and /healthz.

#include "tools/mien/http/http_server.h"
#include "tools/mien/serve/answer_cache.h"
#include "tools/mien/serve/face_request.h"
#include "tools/mien/serve/work_queue.h"

#include <atomic>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace mien::command {

struct FaceSiteOptions {
  RequestLimits limits = {};
  std::uint64_t cache = std::uint64_t(64) << 20;  ///< [bytes] of pictures that are kept
  int threads = 1;                                ///< that draw
  std::size_t most_waiting = 256;                 ///< pictures that are still to be drawn
  double timeout = 10;                            ///< [s] from the request to the picture
};

class FaceSite final : public HttpSite {
 public:
  /// `mail` brings pictures to the server's thread.
  FaceSite(const FaceSiteOptions& options, HttpServer::Mail mail);
  /// What is being drawn is given up.
  ~FaceSite() override;

  std::optional<HttpAnswer> answer(const HttpAsked& asked, const Later& later) override;

 private:
  /// Who waits for a picture.
  struct Waiting {
    Later later;
    bool of_word;
    std::string etag;
    FaceFormat format;
  };

  bool begin_to_draw(const FaceRequest& request);
  void is_drawn(const std::string& meaning, const DrawnFace& drawn);

  const FaceSiteOptions options_;
  const HttpServer::Mail mail_;
  AnswerCache cache_;
  std::unordered_map<std::string, std::vector<Waiting>> waiting_;  ///< by meaning
  std::atomic<bool> ends_ = false;
  WorkQueue queue_;
};

/// The tag of what a request means, of this version of mien, in its quotes (RFC 9110, 8.8.3).
std::string etag_of(std::string_view meaning);

/// Whether a header If-None-Match names a tag: "a", W/"a", a list of them, or *.
bool names_tag(std::string_view if_none_match, std::string_view etag);

}  // namespace mien::command
