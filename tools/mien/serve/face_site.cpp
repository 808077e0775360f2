#include "tools/mien/serve/face_site.h"
#include <mien/version.h>
#include "lib/base/monotonic_seconds.h"
#include "tools/mien/http/percent_text.h"
#include "tools/mien/output/sha256.h"

#include <fmt/format.h>

#include <span>
#include <utility>

namespace mien::command {
namespace {

constexpr const char* kTypes[] = {"image/png", "image/svg+xml", "image/webp"};  // of FaceFormat

/// A code is a face for ever, a word only as long as its seed means the same.
constexpr const char* kForCodes = "public, max-age=31536000, immutable";
constexpr const char* kForWords = "public, max-age=86400";

void add_caching(HttpAnswer& to, bool of_word, const std::string& etag) {
  to.headers.emplace_back("ETag", etag);
  to.headers.emplace_back("Cache-Control", of_word ? kForWords : kForCodes);
  to.headers.emplace_back("Access-Control-Allow-Origin", "*");
}

HttpAnswer unavailable(const std::string& sentence) {
  HttpAnswer answer = told(kUnavailable, sentence);
  answer.headers.emplace_back("Retry-After", "1");
  return answer;
}

/// What is answered with a picture, or with the sentence that stands in its place.
HttpAnswer answer_with(const DrawnFace& drawn, FaceFormat format, bool of_word,
                       const std::string& etag) {
  if (drawn.code != kOk) {
    std::string text = *drawn.bytes;
    text.pop_back();  // its end of line
    return drawn.code == kUnavailable ? unavailable(text) : told(drawn.code, text);
  }
  HttpAnswer answer{kOk, {{"Content-Type", kTypes[int(format)]}}, drawn.bytes};
  if (format == FaceFormat::svg)  // opened by itself it may do nothing
    answer.headers.emplace_back("Content-Security-Policy",
                                "default-src 'none'; style-src 'unsafe-inline'; sandbox");
  add_caching(answer, of_word, etag);
  return answer;
}

}  // namespace

std::string etag_of(std::string_view meaning) {
  const std::string text = fmt::format("mien {} {}", MIEN_VERSION_STRING, meaning);
  return fmt::format("\"{}\"", sha256(std::as_bytes(std::span(text))).substr(0, 32));
}

bool names_tag(std::string_view if_none_match, std::string_view etag) {
  while (!if_none_match.empty()) {
    const std::size_t end = std::min(if_none_match.find(','), if_none_match.size());
    std::string_view one = if_none_match.substr(0, end);
    if_none_match.remove_prefix(std::min(end + 1, if_none_match.size()));
    while (one.starts_with(' ') || one.starts_with('\t')) one.remove_prefix(1);
    while (one.ends_with(' ') || one.ends_with('\t')) one.remove_suffix(1);
    if (one.starts_with("W/")) one.remove_prefix(2);
    if (one == etag || one == "*") return true;
  }
  return false;
}

FaceSite::FaceSite(const FaceSiteOptions& options, HttpServer::Mail mail)
    : options_(options),
      mail_(std::move(mail)),
      cache_(options.cache),
      queue_(options.threads, options.most_waiting) {}

FaceSite::~FaceSite() {
  ends_ = true;
}

std::optional<HttpAnswer> FaceSite::answer(const HttpAsked& asked, const Later& later) {
  if (target_parts(asked.target).path == "/healthz") return told(kOk, "ok");
  const auto read = read_face_request(asked.target, options_.limits);
  if (const auto* refusal = std::get_if<Refusal>(&read))
    return told(refusal->code, sentence(refusal->error));
  const auto& request = std::get<FaceRequest>(read);
  const std::string etag = etag_of(request.meaning);
  // Only who was given the picture has its tag.
  if (names_tag(asked.if_none_match, etag)) {
    HttpAnswer same{kNotModified, {}, {}};
    add_caching(same, request.of_word, etag);
    return same;
  }
  if (const DrawnFace* known = cache_.find(request.meaning))
    return answer_with(*known, request.format, request.of_word, etag);
  const bool first = !waiting_.contains(request.meaning);
  if (first && !begin_to_draw(request))
    return unavailable("too many pictures are waited for; ask again in a second");
  waiting_[request.meaning].push_back({later, request.of_word, etag, request.format});
  return {};
}

bool FaceSite::begin_to_draw(const FaceRequest& request) {
  const double until = monotonic_seconds() + options_.timeout;
  return queue_.take([this, request, until] {
    const auto go_on = [&] { return !ends_ && monotonic_seconds() < until; };
    const std::string late =
        fmt::format("this takes longer than the {:.6g} s that it may", options_.timeout);
    DrawnFace drawn =
        go_on() ? drawn_face(request, options_.limits, go_on, late)
                : DrawnFace{kUnavailable, std::make_shared<const std::string>(late + "\n")};
    mail_(
        [this, meaning = request.meaning, drawn = std::move(drawn)] { is_drawn(meaning, drawn); });
  });
}

void FaceSite::is_drawn(const std::string& meaning, const DrawnFace& drawn) {
  if (drawn.code == kOk || drawn.code == kWrong) cache_.put(meaning, drawn);
  auto waiting = waiting_.extract(meaning);
  if (!waiting) return;
  for (const Waiting& one : waiting.mapped())
    one.later(answer_with(drawn, one.format, one.of_word, one.etag));
}

}  // namespace mien::command
