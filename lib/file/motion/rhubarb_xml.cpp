// Rhubarb's tracks as XML: <mouthCue start="0.00" end="0.05">X</mouthCue>. Its elements have no text that needs more than
// what is read here, so no library of XML is asked.

#include "motion_reader_private.h"
#include "speech_builder_private.h"

namespace mien {
namespace {

class RhubarbXmlReader final : public MotionReader {
 public:
  explicit RhubarbXmlReader(const MotionSource& source)
      : source_(source), speech_(source.name, source.limits) {
    speech_.alphabet = PhoneAlphabet::rhubarb;
  }

  Expected<Done> take(const FileLine& line) override {
    last_ = line.number;
    closed_ |= line.text.find("</rhubarbResult>") != std::string_view::npos;
    std::string_view left = line.text;
    for (;;) {
      const std::size_t at = left.find(kElement);
      if (at == std::string_view::npos) return Done{};
      left.remove_prefix(at);
      if (auto done = take_cue(line, left); !done) return done;
    }
  }

  Expected<Motion> finish(std::vector<Error>& told) override {
    if (!closed_) return Error{source_.at(last_), "the file ends before </rhubarbResult>"};
    return speech_.finish(told);
  }

 private:
  static constexpr std::string_view kElement = "<mouthCue ";

  /// Reads the cue at the front of `left`, and goes past it.
  Expected<Done> take_cue(const FileLine& line, std::string_view& left) {
    const std::size_t end = left.find('>');
    const std::size_t close = left.find("</mouthCue>");
    if (end == std::string_view::npos || close == std::string_view::npos || close < end)
      return Error{source_.at(line, left), "expected <mouthCue start=\"…\" end=\"…\">X</mouthCue>"};
    const std::string_view tag = left.substr(0, end), cue = left;
    const auto begin = attribute(line, tag, "start");
    if (!begin) return begin.error();
    const auto until = attribute(line, tag, "end");
    if (!until) return until.error();
    const std::string_view name = without_blanks(left.substr(end + 1, close - end - 1));
    left.remove_prefix(close);
    return speech_.add(*begin, *until, name, [&] { return source_.at(line, cue); });
  }

  Expected<double> attribute(const FileLine& line, std::string_view tag, const char* name) const {
    for (const char quote : {'"', '\''}) {
      const std::string key = fmt::format(" {}={}", name, quote);
      const std::size_t at = tag.find(key);
      if (at == std::string_view::npos) continue;
      const std::string_view text = tag.substr(at + key.size());
      const std::string_view value = text.substr(0, text.find(quote));
      if (const auto number = number_in(value)) return *number;
      return Error{source_.at(line, value),
                   fmt::format("expected the seconds of {}, got {}", name, in_quotes(value))};
    }
    return Error{source_.at(line, tag), fmt::format("a cue without its {}", name)};
  }

  MotionSource source_;
  SpeechBuilder speech_;
  std::size_t last_ = 1;
  bool closed_ = false;
};

}  // namespace

std::unique_ptr<MotionReader> rhubarb_xml_reader(const MotionSource& source) {
  return std::make_unique<RhubarbXmlReader>(source);
}

}  // namespace mien
