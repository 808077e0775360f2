// Tracks of speech with a sound in each line: marks (a moment, a tab, a name), and the .pho files of espeak and MBROLA (a
// name, milliseconds, and how the pitch goes).

#include "motion_reader_private.h"
#include "speech_builder_private.h"

#include <algorithm>
#include <span>

namespace mien {
namespace {

/// The first word of a text, which it loses with the blanks after it.
std::string_view next_mark_word(std::string_view& text) {
  text = without_blanks(text);
  const std::size_t end = text.find_first_of(" \t");
  const std::string_view word = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view{} : without_blanks(text.substr(end));
  return word;
}

class MarksReader final : public MotionReader {
 public:
  explicit MarksReader(const MotionSource& source)
      : source_(source), speech_(source.name, source.limits) {}

  Expected<Done> take(const FileLine& line) override {
    std::string_view left = line.text;
    const std::string_view word = next_mark_word(left);
    if (word.empty() || word.starts_with('#')) return Done{};
    const auto time = number_in(word);
    if (!time)
      return Error{
          source_.at(line, word),
          fmt::format("expected SECONDS and the name of a sound, got {}", in_quotes(word))};
    // A file of intervals has their ends, too.
    const std::string_view rest = left;
    const std::string_view second = next_mark_word(left);
    const auto end = left.empty() ? std::nullopt : number_in(second);
    return speech_.add(*time, end, end ? left : rest, [&] { return source_.at(line, word); });
  }

  Expected<Motion> finish(std::vector<Error>& told) override { return speech_.finish(told); }

 private:
  MotionSource source_;
  SpeechBuilder speech_;
};

class PhoReader final : public MotionReader {
 public:
  explicit PhoReader(const MotionSource& source)
      : source_(source), speech_(source.name, source.limits) {
    speech_.alphabet = PhoneAlphabet::sampa;
  }

  Expected<Done> take(const FileLine& line) override {
    std::string_view left = line.text;
    const std::string_view name = next_mark_word(left);
    if (name.empty() || name.starts_with(';') || name.starts_with('#')) return Done{};
    const std::string_view word = next_mark_word(left);
    const auto length = number_in(word);
    if (!length || *length < 0)
      return Error{source_.at(line, word.empty() ? name : word),
                   fmt::format("expected the milliseconds that {} lasts, got {}", in_quotes(name),
                               in_quotes(word))};
    const double begin = time_;
    time_ += *length / 1000;
    if (auto added = speech_.add(begin, time_, name, [&] { return source_.at(line, name); });
        !added)
      return added;
    speech_.set_pitch(pitches(left));
    return Done{};
  }

  Expected<Motion> finish(std::vector<Error>& told) override { return speech_.finish(told); }

 private:
  /// Pairs: at how many percent of the sound, and how high [Hz]. Anything else is no pitch.
  std::span<const double> pitches(std::string_view left) {
    hertz_.clear();
    while (!left.empty()) {
      next_mark_word(left);
      const auto height = number_in(next_mark_word(left));
      if (!height || !(*height > 0 && *height < 1e5)) break;
      hertz_.push_back(*height);
    }
    return hertz_;
  }

  MotionSource source_;
  SpeechBuilder speech_;
  std::vector<double> hertz_;
  double time_ = 0;
};

}  // namespace

bool is_mark(std::string_view line) {
  const std::string_view word = next_mark_word(line);
  return number_in(word).has_value() && line.find_first_of(",;|") == std::string_view::npos;
}

bool is_pho(std::string_view line) {
  const std::string_view name = next_mark_word(line);
  if (name.starts_with(';')) return true;
  return !name.empty() && number_in(next_mark_word(line)).has_value();
}

std::unique_ptr<MotionReader> marks_reader(const MotionSource& source) {
  return std::make_unique<MarksReader>(source);
}
std::unique_ptr<MotionReader> pho_reader(const MotionSource& source) {
  return std::make_unique<PhoReader>(source);
}

}  // namespace mien
