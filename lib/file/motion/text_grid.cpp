// Praat's TextGrids, long and short. In both, what counts are texts in quotes, numbers that stand free and flags in angle
// brackets, in the same order; all else explains them to people.

#include "motion_reader_private.h"
#include "speech_builder_private.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

struct GridToken {
  enum class Kind { text, number, flag } kind;
  std::string text;
  double number = 0;
  std::size_t line, column;
};

/// Cuts lines into tokens. A text may go on in the next line.
class GridTokens {
 public:
  /// Calls each(token) for what the line holds.
  template <class Each>
  Expected<Done> cut(const FileLine& line, Each&& each) {
    std::string_view left = line.text;
    if (open_) {
      text_.text += '\n';
      if (!take_text(left)) return Done{};
      if (auto done = each(text_); !done) return done;
    }
    for (;;) {
      const std::size_t begin = left.find_first_not_of(" \t");
      if (begin == std::string_view::npos || left[begin] == '!') return Done{};
      left.remove_prefix(begin);
      const auto column = std::size_t(left.data() - line.text.data()) + 1;
      if (left.front() == '"') {
        left.remove_prefix(1);
        text_ = {GridToken::Kind::text, {}, 0, line.number, column};
        if (!take_text(left)) return Done{};
        if (auto done = each(text_); !done) return done;
        continue;
      }
      const std::string_view word = left.substr(0, left.find_first_of(" \t"));
      left.remove_prefix(word.size());
      const auto number = number_in(word);
      const bool flag = word.size() > 2 && word.front() == '<' && word.back() == '>';
      if (!number && !flag) continue;
      const GridToken token{number ? GridToken::Kind::number : GridToken::Kind::flag,
                            std::string(word), number.value_or(0), line.number, column};
      if (auto done = each(token); !done) return done;
    }
  }

  bool is_open() const { return open_; }
  std::size_t opened() const { return text_.line; }

 private:
  /// Whether the text ends here; it is cut off the line. Two quotes are one of the text.
  bool take_text(std::string_view& left) {
    open_ = true;
    for (;;) {
      const std::size_t quote = left.find('"');
      text_.text += left.substr(0, quote);
      left.remove_prefix(quote == std::string_view::npos ? left.size() : quote + 1);
      if (quote == std::string_view::npos) return false;
      if (!left.starts_with('"')) break;
      text_.text += '"';
      left.remove_prefix(1);
    }
    open_ = false;
    return true;
  }

  GridToken text_{GridToken::Kind::text, {}, 0, 0, 0};
  bool open_ = false;
};

struct GridInterval {
  double begin, end;
  std::string text;
  std::size_t line;
};

struct GridTier {
  std::string name;
  bool intervals = true;  ///< else points
  double left = 0;        ///< to be read
  std::vector<GridInterval> all;

  /// Aligners call it "phones", with a speaker's name before it where there are several.
  bool holds_phones() const {
    std::string letters;
    for (const char c : name) letters += char(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    for (const char* end : {"phones", "phone", "phonemes", "phoneme", "mau", "segments"})
      if (letters.ends_with(end)) return true;
    return false;
  }
};

class TextGridReader final : public MotionReader {
 public:
  explicit TextGridReader(const MotionSource& source) : source_(source) {}

  Expected<Done> take(const FileLine& line) override {
    return tokens_.cut(line, [&](const GridToken& token) { return step(token); });
  }

  Expected<Motion> finish(std::vector<Error>& told) override {
    if (tokens_.is_open())
      return Error{source_.at(tokens_.opened()), "a text whose quotes do not end"};
    if (state_ != State::tiers || tier_.left > 0)
      return Error{source_.name, "the file ends within a TextGrid"};
    keep_better();
    if (best_.all.empty()) return Error{source_.name, "no tier has intervals"};
    if (!best_.holds_phones())
      told.push_back(
          {source_.name,
           fmt::format("no tier is called \"phones\": that of {} is read, which has the most "
                       "intervals",
                       in_quotes(best_.name))});
    SpeechBuilder speech(source_.name, source_.limits);
    for (const GridInterval& one : best_.all)
      if (auto done = speech.add(one.begin, one.end, without_blanks(one.text),
                                 [&] { return source_.at(one.line); });
          !done)
        return done.error();
    return speech.finish(told);
  }

 private:
  /// What comes next.
  enum class State {
    type,
    object,
    low,
    high,
    exists,
    size,
    tiers,
    name,
    tier_low,
    tier_high,
    count,
    begin,
    end,
    text
  };

  Expected<Done> step(const GridToken& token) {
    using Kind = GridToken::Kind;
    const auto next = [&](Kind kind, State then, const char* what) -> Expected<Done> {
      if (token.kind != kind) return unexpected(token, what);
      state_ = then;
      return Done{};
    };
    switch (state_) {
      case State::type:
        return next(Kind::text, State::object, "\"ooTextFile\"");
      case State::object:
        if (token.kind == Kind::text && token.text != "TextGrid")
          return Error{place(token),
                       fmt::format("expected a TextGrid, got {}", in_quotes(token.text))};
        return next(Kind::text, State::low, "\"TextGrid\"");
      case State::low:
        return next(Kind::number, State::high, "its first moment");
      case State::high:
        return next(Kind::number, State::exists, "its last moment");
      case State::exists:
        return next(Kind::flag, State::size, "<exists>");
      case State::size:
        return next(Kind::number, State::tiers, "how many tiers there are");
      case State::tiers:
        return begin_tier(token);
      case State::name:
        tier_.name = token.text;
        return next(Kind::text, State::tier_low, "a tier's name");
      case State::tier_low:
        return next(Kind::number, State::tier_high, "its first moment");
      case State::tier_high:
        return next(Kind::number, State::count, "its last moment");
      case State::count:
        return take_count(token);
      case State::begin:
        interval_ = {token.number, token.number, {}, token.line};
        return next(Kind::number, tier_.intervals ? State::end : State::text, "a moment");
      case State::end:
        interval_.end = token.number;
        return next(Kind::number, State::text, "a moment");
      case State::text:
        return take_interval(token);
    }
    return Done{};
  }

  Expected<Done> begin_tier(const GridToken& token) {
    keep_better();
    if (token.kind != GridToken::Kind::text ||
        (token.text != "IntervalTier" && token.text != "TextTier"))
      return unexpected(token, "\"IntervalTier\" or \"TextTier\"");
    tier_ = {.intervals = token.text == "IntervalTier"};
    state_ = State::name;
    return Done{};
  }

  Expected<Done> take_count(const GridToken& token) {
    if (token.kind != GridToken::Kind::number || !(token.number >= 0))
      return unexpected(token, "how many intervals there are");
    tier_.left = token.number;
    state_ = token.number > 0 ? State::begin : State::tiers;
    return Done{};
  }

  Expected<Done> take_interval(const GridToken& token) {
    if (token.kind != GridToken::Kind::text) return unexpected(token, "a text in quotes");
    interval_.text = token.text;
    if (tier_.all.size() >= source_.limits.rows)
      return Error{place(token),
                   fmt::format("more than {} intervals (limit: rows)", source_.limits.rows)};
    tier_.all.push_back(std::move(interval_));
    tier_.left -= 1;
    state_ = tier_.left > 0 ? State::begin : State::tiers;
    return Done{};
  }

  void keep_better() {
    if (tier_.intervals && (std::pair(tier_.holds_phones(), tier_.all.size()) >
                            std::pair(best_.holds_phones(), best_.all.size())))
      best_ = std::move(tier_);
    tier_ = {};
  }

  std::string place(const GridToken& token) const {
    return fmt::format("{}:{}:{}", source_.name, token.line, token.column);
  }
  Error unexpected(const GridToken& token, const char* what) const {
    return {place(token), fmt::format("expected {}, got {}", what, in_quotes(token.text))};
  }

  MotionSource source_;
  GridTokens tokens_;
  State state_ = State::type;
  GridTier tier_, best_;
  GridInterval interval_{0, 0, {}, 0};
};

}  // namespace

std::unique_ptr<MotionReader> text_grid_reader(const MotionSource& source) {
  return std::make_unique<TextGridReader>(source);
}

}  // namespace mien
