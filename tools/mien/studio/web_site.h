#pragma once
// A folder as a site for browsers of this machine alone.

#include "tools/mien/http/http_answer.h"
#include "tools/mien/studio/web_folder.h"

namespace mien::command {

class WebSite final : public HttpSite {
 public:
  explicit WebSite(WebFolder folder) : folder_(std::move(folder)) {}
  std::optional<HttpAnswer> answer(const HttpAsked& asked, const Later& later) override;

 private:
  WebFolder folder_;
};

}  // namespace mien::command
