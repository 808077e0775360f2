#include <mien/motion_file.h>
#include "lib/base/memory_ran_out.h"

#include "lib/file/json/read_bytes.h"
#include "motion_reader_private.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "lib/base/from_chars.h"

namespace mien {

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

std::optional<double> number_in(std::string_view text) {
  text = without_blanks(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, status] = from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

namespace {

/// The reader for a file with this first line that is not blank; null: none is known.
std::unique_ptr<MotionReader> reader_for(std::string_view line, const MotionSource& source) {
  line = without_blanks(line);
  if (line.starts_with('{') || line.starts_with('[')) return json_motion_reader(source);
  if (line.starts_with('<')) return rhubarb_xml_reader(source);
  if (line.find("\"ooTextFile\"") != std::string_view::npos) return text_grid_reader(source);
  if (is_take_heading(line)) return csv_take_reader(source);
  if (is_mark(line)) return marks_reader(source);
  if (is_pho(line)) return pho_reader(source);
  if (line.find_first_of(",;\t|") != std::string_view::npos) return csv_take_reader(source);
  return nullptr;
}

void append_utf8(std::string& text, std::uint32_t c) {
  if (c < 0x80) {
    text += char(c);
  } else if (c < 0x800) {
    text += char(0xC0 | c >> 6);
    text += char(0x80 | (c & 0x3F));
  } else {
    if (c >= 0x10000) text += char(0xF0 | c >> 18);
    text += char(c >= 0x10000 ? 0x80 | (c >> 12 & 0x3F) : 0xE0 | c >> 12);
    text += char(0x80 | (c >> 6 & 0x3F));
    text += char(0x80 | (c & 0x3F));
  }
}

/// UTF-16, as Praat may write it, unit by unit.
class Utf16Text {
 public:
  explicit Utf16Text(bool big) : big_(big) {}

  void add(std::string_view bytes, std::string& text) {
    for (const char byte : bytes) {
      const auto b = std::uint32_t(static_cast<unsigned char>(byte));
      if (!half_) {
        half_ = b;
        continue;
      }
      const std::uint32_t unit = big_ ? *half_ << 8 | b : b << 8 | *half_;
      half_.reset();
      if (unit >= 0xD800 && unit < 0xDC00) {
        high_ = unit;
      } else if (unit >= 0xDC00 && unit < 0xE000) {
        append_utf8(text, high_ ? 0x10000 + ((high_ - 0xD800) << 10) + (unit - 0xDC00) : 0xFFFD);
        high_ = 0;
      } else {
        append_utf8(text, unit);
      }
    }
  }

 private:
  bool big_;
  std::optional<std::uint32_t> half_;
  std::uint32_t high_ = 0;
};

/// A file on its way to a reader: bytes are cut into lines, whatever ends them.
class MotionLines {
 public:
  explicit MotionLines(const MotionSource& source) : source_(source) {}

  /// False: it ends here, with an error.
  bool take(std::string_view block) {
    if (!began_) {
      start_ += block;
      if (start_.size() < 4) return true;
      return begin();
    }
    return add(block);
  }

  Expected<Motion> finish(std::vector<Error>& told) {
    if (!began_ && !error_) begin();
    if (!error_ && !pending_.empty()) give(pending_);
    if (error_) return *error_;
    if (!reader_) return Error{source_.name, "is empty"};
    return reader_->finish(told);
  }

 private:
  bool begin() {
    began_ = true;
    const std::string start = std::move(start_);
    std::string_view text = start;
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
      utf16_.emplace(text.front() == '\xFE');
      text.remove_prefix(2);
    } else if (text.starts_with("\xEF\xBB\xBF")) {
      text.remove_prefix(3);
    }
    return add(text);
  }

  bool add(std::string_view block) {
    if (utf16_) {
      std::string text;
      utf16_->add(block, text);
      return cut(text);
    }
    return cut(block);
  }

  bool cut(std::string_view block) {
    while (!block.empty()) {
      const std::size_t end = end_of_line(block);
      if (end == std::string_view::npos) {
        pending_ += block;
        if (pending_.size() > source_.limits.bytes)
          return fail(
              {source_.at(number_),
               fmt::format("a line longer than {} bytes (limit: bytes)", source_.limits.bytes)});
        return true;
      }
      pending_ += block.substr(0, end);
      block.remove_prefix(end + 1);
      if (!give(pending_)) return false;
      pending_.clear();
    }
    return true;
  }

  /// Lines end with "\n" or "\r\n", or, in files without these, with an old Mac's "\r".
  std::size_t end_of_line(std::string_view block) {
    const std::size_t end = block.find('\n');
    if (end != std::string_view::npos) newlines_ = true;
    return newlines_ || end != std::string_view::npos ? end : block.find('\r');
  }

  bool give(std::string_view text) {
    if (text.ends_with('\r')) text.remove_suffix(1);
    const FileLine line{text, number_++};
    if (!reader_) {
      if (without_blanks(text).empty() || without_blanks(text).starts_with('#')) return true;
      reader_ = reader_for(text, source_);
      if (!reader_)
        return fail({source_.at(line.number),
                     "is no take or track of speech that is known: a table with a column of times, "
                     "JSON, a TextGrid, cues of Rhubarb, or a moment and a sound in each line"});
    }
    if (auto taken = reader_->take(line); !taken) return fail(std::move(taken).error());
    return true;
  }

  bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  MotionSource source_;
  std::string start_, pending_;
  bool began_ = false, newlines_ = false;
  std::optional<Utf16Text> utf16_;
  std::size_t number_ = 1;
  std::unique_ptr<MotionReader> reader_;
  std::optional<Error> error_;
};

/// Reads by feed(lines), which gives blocks to lines.take.
template <class Feed>
Expected<Motion> read_by(const MotionSource& source, std::vector<Error>* told, Feed&& feed) {
  try {
    MotionLines lines(source);
    if (auto fed = feed(lines); !fed) return fed.error();
    std::vector<Error> all;
    auto motion = lines.finish(all);
    if (told) told->insert(told->end(), all.begin(), all.end());
    return motion;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return Error{source.name, fmt::format("cannot be read: {}", one_line(e.what()))};
  }
}

}  // namespace

Expected<Motion> read_motion(const std::filesystem::path& path, std::vector<Error>* told,
                             const MotionLimits& limits) try {
  return read_by({one_line(path.string()), limits}, told, [&](MotionLines& lines) {
    return read_in_blocks(path, [&](std::string_view block) { return lines.take(block); });
  });
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

Expected<Motion> read_motion_text(std::string_view text, std::string_view name,
                                  std::vector<Error>* told, const MotionLimits& limits) try {
  return read_by({one_line(name), limits}, told, [&](MotionLines& lines) -> Expected<Done> {
    lines.take(text);
    return Done{};
  });
} catch (const std::bad_alloc&) {
  return memory_ran_out(name);
}

}  // namespace mien
