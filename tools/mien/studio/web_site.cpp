#include "tools/mien/studio/web_site.h"
#include "tools/mien/http/percent_text.h"

#include <fmt/format.h>

#include <cctype>

namespace mien::command {
namespace {

std::string percent_encoded(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        byte < 128 && (std::isalnum(byte) || std::string("/-._~").find(c) != std::string::npos);
    text += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return text;
}

HttpAnswer file_at(const WebFile& file) {
  return {kOk,
          {{"Content-Type", std::string(file.type)},
           {"Cache-Control", "no-cache"}},  // a package that is made again is seen at once
          file.path};
}

HttpAnswer elsewhere_at(const std::string& path) {
  HttpAnswer answer = told(kSeeOther, "elsewhere");
  answer.headers.emplace_back("Location", percent_encoded(path));
  return answer;
}

}  // namespace

std::optional<HttpAnswer> WebSite::answer(const HttpAsked& asked, const Later&) {
  // Pages of the network that give their own name this machine's address would read what is served here.
  if (asked.host != "127.0.0.1" && asked.host != "localhost")
    return told(kMisdirected, "only 127.0.0.1 and localhost are answered");
  const auto path = percent_decoded(target_parts(asked.target).path);
  if (!path) return told(kWrong, "a % in this address has no two hexadecimal digits behind it");
  const auto found = folder_.at(*path);
  if (const auto* file = std::get_if<WebFile>(&found)) return file_at(*file);
  if (const auto* elsewhere = std::get_if<Elsewhere>(&found)) return elsewhere_at(elsewhere->path);
  if (std::get<NoFile>(found) == NoFile::forbidden)
    return told(kForbidden, "this is outside of the folder");
  return told(kNotFound, "there is no such file");
}

}  // namespace mien::command
