// Takes as tables: a heading, and a row for each frame. Those of Live Link Face, of OpenFace, and any other with a column of
// times.
//
// Rows are read one by one and hold nothing but numbers, so a cell is what stands between two separators. libcsv, which
// reads the tables of the command, is not where the core is built for web pages.

#include "lib/base/nearest_name.h"
#include "lib/face/standard_names.h"
#include "motion_reader_private.h"
#include "take_builder_private.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "lib/base/from_chars.h"

namespace mien {
namespace {

constexpr char kSeparators[] = {',', ';', '\t', '|'};
constexpr std::size_t kMostCells = 10'000;

/// The cells of a line, without the quotes around them.
void cut_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  while (cells.size() < kMostCells) {
    std::size_t from = 0;
    if (line.starts_with('"')) from = std::min(line.find('"', 1), line.size());
    const std::size_t end = line.find(separator, from);
    std::string_view cell = without_blanks(line.substr(0, end));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = without_blanks(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

/// The separator that divides a heading into most cells.
char separator_of(std::string_view heading) {
  char best = ',';
  for (const char c : kSeparators)
    if (std::count(heading.begin(), heading.end(), c) >
        std::count(heading.begin(), heading.end(), best))
      best = c;
  return best;
}

/// Letters and digits in lower case: "time (s)" is "times".
std::string heading_letters(std::string_view heading) {
  std::string letters;
  for (const char c : heading)
    if (c >= 'A' && c <= 'Z')
      letters += char(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      letters += c;
  return letters;
}

enum class TimeColumn { none, code, ticking, seconds, milliseconds };

TimeColumn time_column(std::string_view heading) {
  const std::string letters = heading_letters(heading);
  if (letters == "timecode") return TimeColumn::code;
  if (letters == "timestamp" || letters == "timestamps") return TimeColumn::ticking;
  for (const char* name : {"timestampms", "timems", "milliseconds", "ms", "timeinms"})
    if (letters == name) return TimeColumn::milliseconds;
  for (const char* name :
       {"time", "times", "seconds", "timesec", "timeseconds", "t", "sec", "timeins"})
    if (letters == name) return TimeColumn::seconds;
  return TimeColumn::none;
}

/// "13:29:07:45.453": hours, minutes, seconds, and frames, of which 60 make a second at whatever rate rows come. Or
/// "13:29:07.75". Seconds since midnight; none: something else.
std::optional<double> seconds_of_code(std::string_view code) {
  constexpr double kCodeFrames = 60;
  double parts[4] = {0, 0, 0, 0};
  int count = 0;
  for (; count < 4; ++count) {
    const std::size_t end = code.find_first_of(":;");
    const auto number = number_in(code.substr(0, end));
    if (!number || *number < 0 || *number >= (count == 0 ? 24 : 60)) return {};
    parts[count] = *number;
    if (end == std::string_view::npos) break;
    code.remove_prefix(end + 1);
  }
  if (count < 2 || count > 3) return {};
  return parts[0] * 3600 + parts[1] * 60 + parts[2] + parts[3] / kCodeFrames;
}

class CsvTakeReader final : public MotionReader {
 public:
  explicit CsvTakeReader(const MotionSource& source)
      : source_(source), take_(source.name, source.limits) {}

  Expected<Done> take(const FileLine& line) override {
    if (headings_.empty()) return take_heading(line);
    if (without_blanks(line.text).empty()) return Done{};
    cut_cells(line.text, separator_, cells_);
    if (cells_.size() == headings_.size() + 1 && cells_.back().empty()) cells_.pop_back();
    // Live Link Face writes a row without a face as its time and a count of 0, and ends it there.
    if (cells_.size() < headings_.size() && sees_no_face()) cells_.resize(headings_.size());
    if (cells_.size() != headings_.size())
      return Error{source_.at(line.number),
                   fmt::format("{} cells, the heading has {}", cells_.size(), headings_.size())};
    return take_row(line);
  }

  Expected<Motion> finish(std::vector<Error>& told) override {
    if (take_.columns() == 0) return no_channels();
    if (!ignored_.empty()) told.push_back({source_.name, ignored_text()});
    if (commas_) told.push_back({source_.name, "numbers are read with decimal commas"});
    if (other_faces_ > 0)
      told.push_back(
          {source_.name,
           fmt::format("{} rows of other faces than the first are left out", other_faces_)});
    return take_.finish(told);
  }

 private:
  struct Use {
    std::size_t cell;
    std::vector<std::pair<std::size_t, TakeTarget>> to;  ///< columns of the take
  };

  Expected<Done> take_heading(const FileLine& line) {
    separator_ = separator_of(line.text);
    cut_cells(line.text, separator_, cells_);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::string heading(cells_[i]);
      if (!heading.empty() &&
          std::find(headings_.begin(), headings_.end(), heading) != headings_.end())
        return Error{source_.at(line, cells_[i]),
                     fmt::format("two columns are called {}", in_quotes(heading))};
      headings_.push_back(heading);
      take_column(i);
    }
    if (time_cell_) return Done{};
    return Error{
        source_.at(line.number),
        "no column holds times: expected one called \"Timecode\", \"timestamp\" or \"time\""};
  }

  void take_column(std::size_t cell) {
    const std::string& heading = headings_[cell];
    const std::string letters = heading_letters(heading);
    open_face_ |= letters == "confidence" || letters == "success";
    if (letters == "success" || letters == "blendshapecount") seen_ = cell;
    if (letters == "faceid") face_ = cell;
    if (const TimeColumn time = time_column(heading); time != TimeColumn::none && !time_cell_) {
      time_cell_ = cell, time_ = time;
      take_.clock = time == TimeColumn::code || time == TimeColumn::ticking ? TakeClock::ticking
                    : time == TimeColumn::milliseconds ? TakeClock::milliseconds
                                                       : TakeClock::seconds;
      return;
    }
    Use use{cell, {}};
    for (const TakeTarget& target : take_targets(heading)) {
      const std::size_t before = take_.columns(), column = take_.column(target);
      // OpenFace's AU12_c, whether it is there, repeats AU12_r, how much.
      if (column < before && heading.ends_with("_c")) return;
      if (column < before) drop(column);
      use.to.emplace_back(column, target);
    }
    if (!use.to.empty())
      uses_.push_back(std::move(use));
    else if (!is_beside_the_face(heading) && !heading.empty())
      ignored_.push_back(heading);
  }

  /// Takes a column away from the cell that it had.
  void drop(std::size_t column) {
    for (Use& use : uses_)
      std::erase_if(use.to, [&](const auto& to) { return to.first == column; });
  }

  Expected<Done> take_row(const FileLine& line) {
    if (face_ && !is_first_face()) return Done{};
    const auto time = time_of(line);
    if (!time) return time.error();
    if (sees_no_face()) {
      take_.skip_row();
      return Done{};
    }
    const Place place = [&] { return source_.at(line, cells_[*time_cell_]); };
    if (auto begun = take_.begin_row(*time, place); !begun) return begun;
    for (const Use& use : uses_) {
      const auto value = number(cells_[use.cell]);
      if (!value) return no_number(line, use.cell);
      for (const auto& [column, target] : use.to) take_.set(column, *value, target);
    }
    return Done{};
  }

  /// By a column that tells so, or as the cells of all channels are empty: one alone may be a slip.
  bool sees_no_face() {
    if (seen_ && *seen_ < cells_.size() && number(cells_[*seen_]).value_or(1) == 0) return true;
    return cells_.size() == headings_.size() && uses_.size() > 1 &&
           std::all_of(uses_.begin(), uses_.end(),
                       [&](const Use& use) { return cells_[use.cell].empty(); });
  }

  bool is_first_face() {
    const std::string_view id = cells_[*face_];
    if (first_face_.empty()) first_face_ = std::string(id);
    other_faces_ += id != first_face_;
    return id == first_face_;
  }

  /// Times of day go on after midnight.
  Expected<double> time_of(const FileLine& line) {
    const std::string_view cell = cells_[*time_cell_];
    if (time_ != TimeColumn::code) {
      const auto time = number(cell);
      if (!time) return no_number(line, *time_cell_);
      return *time;
    }
    const auto code = seconds_of_code(cell);
    if (!code)
      return Error{
          source_.at(line, cell),
          fmt::format("expected a time code like 13:29:07:45.453, got {}", in_quotes(cell))};
    constexpr double kDay = 24 * 3600.0;
    if (last_code_ && *code + kDay / 2 < *last_code_) days_ += kDay;
    last_code_ = *code;
    return days_ + *code;
  }

  std::optional<double> number(std::string_view cell) {
    if (auto value = number_in(cell)) return value;
    if (separator_ == ',' || cell.find(',') == std::string_view::npos) return {};
    std::string pointed(cell);
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    const auto value = number_in(pointed);
    commas_ |= value.has_value();
    return value;
  }

  Error no_number(const FileLine& line, std::size_t cell) const {
    const std::string_view text = cells_[cell];
    const std::string heading = one_line(headings_[cell], 60);
    return {source_.at(line, text),
            text.empty() ? fmt::format("the number of {} is missing", in_quotes(heading))
                         : fmt::format("expected a finite number for {}, got {}",
                                       in_quotes(heading), in_quotes(text))};
  }

  Error no_channels() const {
    std::vector<std::string_view> known;
    for (const char* set : {"arkit", "facs", "viseme"})
      for (const std::string_view name : standard_names(set)) known.push_back(name);
    for (const std::string& heading : ignored_)
      if (const auto near = nearest_name(heading, known); !near.empty())
        return {source_.at(1), unknown_name("channel of a face", heading, known)};
    return {source_.at(1),
            "no column is a channel of a face: expected names like \"jawOpen\", "
            "\"AU12_r\" or \"viseme_PP\""};
  }

  std::string ignored_text() const {
    constexpr std::size_t kMostNamed = 5;
    std::string text = ignored_.size() == 1 ? "a column that moves no face is left out: "
                                            : "columns that move no face are left out: ";
    if (open_face_ && ignored_.size() > kMostNamed)
      return text + fmt::format("{} of OpenFace's", ignored_.size());
    for (std::size_t i = 0; i < std::min(ignored_.size(), kMostNamed); ++i)
      text += (i > 0 ? ", " : "") + in_quotes(ignored_[i]);
    if (ignored_.size() > kMostNamed)
      text += fmt::format(" and {} more", ignored_.size() - kMostNamed);
    return text;
  }

  MotionSource source_;
  TakeBuilder take_;
  char separator_ = ',';
  std::vector<std::string> headings_, ignored_;
  std::vector<std::string_view> cells_;
  std::vector<Use> uses_;
  std::optional<std::size_t> time_cell_, seen_, face_;
  TimeColumn time_ = TimeColumn::none;
  std::optional<double> last_code_;
  double days_ = 0;
  std::string first_face_;
  std::size_t other_faces_ = 0;
  bool commas_ = false, open_face_ = false;
};

}  // namespace

bool is_take_heading(std::string_view line) {
  std::vector<std::string_view> cells;
  cut_cells(line, separator_of(line), cells);
  return cells.size() > 1 && std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
           return time_column(cell) != TimeColumn::none;
         });
}

std::unique_ptr<MotionReader> csv_take_reader(const MotionSource& source) {
  return std::make_unique<CsvTakeReader>(source);
}

}  // namespace mien
