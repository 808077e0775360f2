#include "tools/mien/serve/face_request.h"
#include <mien/face_code.h>
#include <mien/recipe.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/face/standard_names.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/http/http_answer.h"
#include "tools/mien/http/percent_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace mien::command {
namespace {

constexpr std::array<std::string_view, 3> kEndings{".png", ".svg", ".webp"};  // of FaceFormat
constexpr std::string_view kSeedFolder = "/seed/";

/// Where a key's value goes: a text that may come once, a list, or a flag.
using Place = std::variant<std::optional<std::string>*, std::vector<std::string>*, bool*>;

struct Key {
  std::string_view name;
  Place (*place)(FaceRequest& to);
};

/// Of the options of `mien render`; in the order in which a request's meaning names them.
#define MIEN_KEY(name, member)                                \
  {                                                           \
    name, [](FaceRequest& to) -> Place { return &to.member; } \
  }
const Key kKeys[] = {
    MIEN_KEY("size", arguments.size),
    MIEN_KEY("width", width),
    MIEN_KEY("height", height),
    MIEN_KEY("fit", arguments.fit),
    MIEN_KEY("region", arguments.region),
    MIEN_KEY("background", arguments.background),
    MIEN_KEY("blend", arguments.blend),
    MIEN_KEY("light", arguments.light),
    MIEN_KEY("legible", arguments.legible),
    MIEN_KEY("dither", arguments.dither),
    MIEN_KEY("depth", arguments.depth),
    MIEN_KEY("dpi", arguments.dpi),
    MIEN_KEY("id-prefix", arguments.id_prefix),
    MIEN_KEY("effect", arguments.effects),
    MIEN_KEY("style", arguments.posed.style),
    MIEN_KEY("neutral", arguments.posed.neutral),
    MIEN_KEY("time", arguments.posed.time),
    MIEN_KEY("clip", arguments.posed.clips),
    MIEN_KEY("seed", arguments.posed.seed),
    MIEN_KEY("liveliness", arguments.posed.liveliness),
    MIEN_KEY("gestures", arguments.posed.gestures),
    MIEN_KEY("pose", arguments.posed.poses),
    MIEN_KEY("look-at", arguments.posed.look_at),
    MIEN_KEY("blink", arguments.posed.blink),
    MIEN_KEY("bias", arguments.posed.bias),
    MIEN_KEY("unwrap", arguments.posed.unwrap),
    MIEN_KEY("unwrap-mode", arguments.posed.unwrap_mode),
    MIEN_KEY("emotion", arguments.posed.emotions),
    MIEN_KEY("muscle", arguments.posed.muscles),
    MIEN_KEY("clamp", arguments.posed.clamp),
    MIEN_KEY("set", arguments.posed.settings),
};
#undef MIEN_KEY

/// Keys that say what others can, shorter: transparent is a background, and these are settings.
constexpr std::string_view kTransparent = "transparent", kGaze = "gaze";
constexpr std::array<std::string_view, 7> kControls{"gaze.x", "gaze.y", "yaw",     "pitch",
                                                    "roll",   "nearer", "dilation"};
constexpr std::array<std::string_view, 5> kSets{"viseme", "arkit", "facs", "vrm", "azure"};

Refusal wrong(std::string where, std::string what) {
  return {kWrong, {std::move(where), std::move(what)}};
}

Expected<bool> read_flag(std::string_view name, std::string_view value) {
  if (value.empty() || value == "1" || value == "true") return true;
  if (value == "0" || value == "false") return false;
  return Error{fmt::format("{}={}", name, one_line(value, 60)), "expected 1 or 0, true or false"};
}

Expected<Done> put(const Key& key, const std::string& value, FaceRequest& to) {
  const Place place = key.place(to);
  if (auto* const* list = std::get_if<std::vector<std::string>*>(&place)) {
    (*list)->push_back(value);
    return Done{};
  }
  if (auto* const* flag = std::get_if<bool*>(&place)) {
    const auto on = read_flag(key.name, value);
    if (!on) return on.error();
    **flag = *on;
    return Done{};
  }
  auto& text = *std::get<std::optional<std::string>*>(place);
  if (text) return Error{std::string(key.name), "may be given only once"};
  text = value;
  return Done{};
}

Expected<Done> put_transparent(const std::string& value, FaceRequest& to) {
  const auto on = read_flag(kTransparent, value);
  if (!on) return on.error();
  if (!*on) return Done{};
  if (to.arguments.background)
    return Error{std::string(kTransparent), "the background is said already"};
  to.arguments.background = kTransparent;
  return Done{};
}

/// "X,Y": both eyes' controls.
Expected<Done> put_gaze(const std::string& value, FaceRequest& to) {
  const std::size_t comma = value.find(',');
  if (comma == value.npos || value.find(',', comma + 1) != value.npos)
    return Error{"gaze=" + one_line(value, 60), "expected X,Y, as gaze.x and gaze.y take them"};
  to.arguments.posed.settings.push_back("gaze.x=" + value.substr(0, comma));
  to.arguments.posed.settings.push_back("gaze.y=" + value.substr(comma + 1));
  return Done{};
}

/// "viseme=ou=0.5" as the setting that it is, "viseme.ou=0.5".
std::string setting_of(std::string_view set, std::string_view text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view weight = equals < text.size() ? text.substr(equals) : "=1";
  return fmt::format("{}.{}{}", set, standard_spelling(set, text.substr(0, equals)), weight);
}

Expected<Done> put_pair(const std::string& name, const std::string& value, FaceRequest& to) {
  if (name == kTransparent) return put_transparent(value, to);
  if (name == kGaze) return put_gaze(value, to);
  std::vector<std::string>& settings = to.arguments.posed.settings;
  if (std::ranges::find(kControls, name) != kControls.end())
    return settings.push_back(fmt::format("{}={}", name, value)), Done{};
  if (std::ranges::find(kSets, name) != kSets.end())
    return settings.push_back(setting_of(name, value)), Done{};
  const auto* const key =
      std::ranges::find_if(kKeys, [&](const Key& one) { return one.name == name; });
  if (key != std::end(kKeys)) return put(*key, value, to);
  return Error{"", unknown_name("key", one_line(name, 60), request_keys())};
}

/// Reads "a=b&c=d"; of a pair without "=" the value is empty.
Expected<Done> read_query(std::string_view query, FaceRequest& to) {
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    if (pair.empty()) continue;
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const auto name = percent_decoded(pair.substr(0, equals), true);
    const auto value = percent_decoded(pair.substr(std::min(pair.size(), equals + 1)), true);
    if (!name || !value)
      return Error{one_line(pair, 60), "a % has no two hexadecimal digits behind it"};
    if (!is_utf8(*name) || !is_utf8(*value))
      return Error{one_line(pair, 60), "this is no text in UTF-8"};
    if (auto done = put_pair(*name, *value, to); !done) return done;
  }
  return Done{};
}

Expected<Done> check_sides(FaceRequest& request, int most) {
  RenderArguments& to = request.arguments;
  if (to.size && (request.width || request.height))
    return Error{"size=" + one_line(*to.size, 60), "width and height are said, too"};
  for (const auto& [key, side] : {std::pair{"width", request.width}, {"height", request.height}})
    if (side)
      if (auto read = read_side(key, *side, most); !read) return read.error();
  if (request.width || request.height) return Done{};
  if (!to.size) to.size = std::to_string(std::min(kDefaultFaceSide, most));
  const auto size = read_size(*to.size, 1);
  if (!size) return size.error();
  if (std::max(size->width, size->height) <= most) return Done{};
  return Error{"size=" + one_line(*to.size, 60),
               fmt::format("this server draws {} pixels a side at most", most)};
}

Expected<Done> check_style(const FaceRequest& request) {
  const auto& style = request.arguments.posed.style;
  if (!style) return Done{};
  const std::vector<std::string> styles = part_styles();
  if (std::ranges::find(styles, *style) != styles.end()) return Done{};
  return Error{"style=" + one_line(*style, 60),
               unknown_name("style", one_line(*style, 60), {styles.begin(), styles.end()})};
}

/// What is asked for, whatever the order of its keys: each text behind its length, so that none can look like two.
std::string meaning_of(FaceRequest& request) {
  std::string text = fmt::format("{} {}", request.arguments.posed.face, int(request.format));
  const auto add = [&](std::string_view name, const std::string& value) {
    text += fmt::format("&{}={}:{}", name, value.size(), value);
  };
  for (const Key& key : kKeys) {
    const Place place = key.place(request);
    if (auto* const* list = std::get_if<std::vector<std::string>*>(&place)) {
      for (const std::string& one : **list) add(key.name, one);
    } else if (auto* const* flag = std::get_if<bool*>(&place)) {
      if (**flag) add(key.name, "1");
    } else if (const auto& value = *std::get<std::optional<std::string>*>(place)) {
      add(key.name, *value);
    }
  }
  return text;
}

Refusal no_such_path(std::string_view path) {
  return {kNotFound,
          {one_line(path, 60), "there is nothing here; /CODE.png and /seed/WORD.png are faces"}};
}

/// The face and the format that a path asks for.
std::optional<Refusal> read_path(std::string_view path, FaceRequest& to) {
  const auto* const ending =
      std::ranges::find_if(kEndings, [&](std::string_view one) { return path.ends_with(one); });
  if (ending == kEndings.end()) {
    const std::size_t dot = path.rfind('.');
    if (dot == path.npos || path.find('/', dot) != path.npos) return no_such_path(path);
    return Refusal{kNotFound,
                   {one_line(path.substr(dot), 60), "pictures are .png, .svg or .webp here"}};
  }
  to.format = FaceFormat(ending - kEndings.begin());
  path.remove_suffix(ending->size());
  to.of_word = path.starts_with(kSeedFolder);
  const auto name = percent_decoded(path.substr(to.of_word ? kSeedFolder.size() : 1));
  if (!name || !is_utf8(*name)) return wrong(one_line(path, 60), "this is no text in UTF-8");
  if (to.of_word) {
    if (name->empty()) return wrong("/seed/", "a word is needed: /seed/WORD.png");
    to.arguments.posed.face = face_code_text({.seed = seed_from_word(*name), .held = {}});
    return {};
  }
  if (name->find('/') != name->npos || name->empty()) return no_such_path(path);
  const auto code = read_face_code(*name);
  if (!code) {
    if (looks_like_face_code(*name)) return Refusal{kNotFound, code.error()};
    return Refusal{kNotFound,
                   {"code " + one_line(*name, 60),
                    fmt::format("this is no code; /seed/{}{} is somebody for any word",
                                one_line(path.substr(1), 60), *ending)}};
  }
  to.arguments.posed.face = face_code_text(*code);
  return {};
}

}  // namespace

Expected<int> read_side(std::string_view key, std::string_view text, int most) {
  const auto side = read_whole(key, text, 1, most);
  if (!side) return Error{fmt::format("{}={}", key, one_line(text, 60)), side.error().what};
  return int(*side);
}

std::vector<std::string_view> request_keys() {
  std::vector<std::string_view> names{kTransparent, kGaze};
  for (const Key& key : kKeys) names.push_back(key.name);
  names.insert(names.end(), kControls.begin(), kControls.end());
  names.insert(names.end(), kSets.begin(), kSets.end());
  return names;
}

Error in_request_words(Error error) {
  if (error.where.starts_with("--")) {
    error.where.erase(0, 2);
    if (const std::size_t space = error.where.find(' '); space != error.where.npos)
      error.where[space] = '=';
  }
  for (std::size_t at = 0; (at = error.what.find("--", at)) != error.what.npos;)
    if (at + 2 < error.what.size() && std::islower(static_cast<unsigned char>(error.what[at + 2])))
      error.what.erase(at, 2);
    else
      ++at;
  return error;
}

std::variant<FaceRequest, Refusal> read_face_request(std::string_view target,
                                                     const RequestLimits& limits) {
  if (target.size() > kLongestTarget)
    return Refusal{kTooLongTarget,
                   {"", fmt::format("this address has {} bytes, {} are read at most", target.size(),
                                    kLongestTarget)}};
  const TargetParts parts = target_parts(target);
  if (!parts.path.starts_with('/')) return no_such_path(parts.path);
  FaceRequest request;
  if (auto refused = read_path(parts.path, request)) return *refused;
  for (const auto& step : {read_query(parts.query, request), check_style(request),
                           check_sides(request, limits.most_side)})
    if (!step) return Refusal{kWrong, in_request_words(step.error())};
  request.meaning = meaning_of(request);
  return request;
}

}  // namespace mien::command
