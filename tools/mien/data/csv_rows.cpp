#include "tools/mien/data/csv_rows.h"
#include "lib/base/from_chars.h"
#include "lib/base/one_line.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace mien::command {
namespace {

constexpr std::size_t kMostRows = 100'000, kMostColumns = 1000;
constexpr char kSeparators[] = {',', ';', '\t', '|'};
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";  // some programs begin UTF-8 with it
constexpr std::string_view kHowToSave = "; tables are UTF-8: save it as \"CSV UTF-8\"";

std::string at_line(const std::string& name, std::size_t line) {
  return fmt::format("{}:{}", name, line);
}

/// Whether every second of the first bytes is a NUL, as in UTF-16 without a mark.
bool looks_like_utf16(std::string_view bytes) {
  constexpr std::size_t kLooked = 64;
  const std::size_t looked = std::min(bytes.size(), kLooked) / 2;
  std::size_t nuls[2] = {0, 0};
  for (std::size_t i = 0; i < 2 * looked; ++i) nuls[i % 2] += bytes[i] == '\0';
  return looked >= 2 && std::max(nuls[0], nuls[1]) * 4 >= looked * 3;
}

Expected<Done> check_encoding(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") || looks_like_utf16(bytes))
    return Error{name, fmt::format("is UTF-16{}", kHowToSave)};
  std::size_t line = 1;
  for (std::string_view left = bytes; !left.empty();) {
    const int length = utf8_length(left);
    if (left.front() == '\0') return Error{at_line(name, line), "a NUL byte, which no text has"};
    if (length == 0)
      return Error{at_line(name, line),
                   fmt::format("byte {:02X} is not UTF-8, perhaps Latin-1{}",
                               unsigned(static_cast<unsigned char>(left[0])), kHowToSave)};
    line += left.front() == '\n';
    left.remove_prefix(std::size_t(length));
  }
  return Done{};
}

/// What the parser has found so far.
struct Parsed {
  CsvRows found;
  std::vector<std::string> row;
  bool too_many = false;
};

void end_cell(void* text, std::size_t length, void* to) {
  Parsed& parsed = *static_cast<Parsed*>(to);
  if (parsed.row.size() > kMostColumns || parsed.too_many) return;
  parsed.row.emplace_back(static_cast<const char*>(text), length);
}

void end_row(int, void* to) {
  Parsed& parsed = *static_cast<Parsed*>(to);
  parsed.too_many = parsed.too_many || parsed.found.rows.size() > kMostRows;
  if (!parsed.too_many) parsed.found.rows.push_back(std::move(parsed.row));
  parsed.row.clear();
}

/// Where a line ends: behind "\n", "\r\n" or an old Mac's "\r".
std::size_t line_size(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos) return text.size();
  return end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
}

Expected<CsvRows> rows_of(std::string_view text, std::size_t line, char separator,
                          const std::string& name) {
  csv_parser parser{};
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) return Error{name, "cannot be read"};
  const std::unique_ptr<csv_parser, void (*)(csv_parser*)> freed(&parser, csv_free);
  csv_set_delim(&parser, static_cast<unsigned char>(separator));
  Parsed parsed;
  parsed.found.separator = separator;
  std::size_t begin = line;  // of the row that is being read
  const auto note_rows = [&] {
    if (parsed.found.rows.size() > parsed.found.lines.size()) parsed.found.lines.push_back(begin);
  };
  const Error quotes{{}, "quotes that do not end, or that stand inside a cell without quotes"};
  for (; !text.empty(); ++line) {
    const std::size_t size = line_size(text);
    const bool blank = text.find_first_not_of(" \t\r\n") >= size && parsed.row.empty();
    if (csv_parse(&parser, text.data(), size, end_cell, end_row, &parsed) != size)
      return Error{at_line(name, begin), quotes.what};
    text.remove_prefix(size);
    if (parsed.found.rows.size() > parsed.found.lines.size() || blank) {
      note_rows();
      begin = line + 1;
    }
    if (parsed.too_many)
      return Error{at_line(name, line), fmt::format("more than {} rows", kMostRows)};
  }
  if (csv_fini(&parser, end_cell, end_row, &parsed) != 0)
    return Error{at_line(name, begin), quotes.what};
  note_rows();
  return std::move(parsed.found);
}

/// Whether a cell is a number with that decimal sign, and digits behind it.
bool has_fraction(std::string_view cell, char sign) {
  const std::size_t at = cell.find(sign);
  return at != std::string_view::npos && at + 1 < cell.size() &&
         cell.find(sign, at + 1) == std::string_view::npos &&
         csv_number(cell, sign == ',').has_value();
}

bool any_fraction(const CsvRows& csv, char sign) {
  return std::any_of(csv.rows.begin() + 1, csv.rows.end(), [&](const auto& row) {
    return std::any_of(row.begin(), row.end(),
                       [&](const std::string& cell) { return has_fraction(cell, sign); });
  });
}

/// The first row that has not as many cells as the heading; none: an empty optional.
std::optional<std::size_t> uneven(const CsvRows& csv) {
  for (std::size_t i = 1; i < csv.rows.size(); ++i)
    if (csv.rows[i].size() != csv.rows[0].size()) return i;
  return {};
}

std::size_t count_numbers(const CsvRows& csv) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < csv.rows.size(); ++i)
    count += std::size_t(std::count_if(
        csv.rows[i].begin(), csv.rows[i].end(),
        [&](const std::string& cell) { return csv_number(cell, csv.decimal_commas).has_value(); }));
  return count;
}

/// The reading with a separator, unless a cell holds an odd quote then.
Expected<CsvRows> read_separated(std::string_view text, std::size_t line, char separator,
                                 const std::string& name) {
  auto csv = rows_of(text, line, separator, name);
  if (csv && csv->rows.size() > 1)
    csv->decimal_commas = separator != ',' && any_fraction(*csv, ',') && !any_fraction(*csv, '.');
  return csv;
}

/// How good a reading is: whether all rows are as long as the heading, and how many cells are numbers
/// then, or else how many cells the heading has.
std::pair<bool, std::size_t> worth(const Expected<CsvRows>& csv) {
  if (!csv || csv->rows.empty()) return {false, 0};
  const bool even = csv->rows.size() > 1 && csv->rows[0].size() > 1 && !uneven(*csv);
  return {even, even ? count_numbers(*csv) : csv->rows[0].size()};
}

/// The best reading, of equals the first. Two that hold as many numbers are an error: "1;2,3" may be 1
/// and 2.3.
Expected<CsvRows> best_reading(std::string_view text, const std::string& name) {
  auto best = read_separated(text, 1, kSeparators[0], name);
  char equal = 0;
  for (const char separator : {kSeparators[1], kSeparators[2], kSeparators[3]}) {
    auto csv = read_separated(text, 1, separator, name);
    const auto now = worth(csv), before = worth(best);
    if (now == before && now.first && now.second > 0) equal = separator;
    if (now <= before) continue;
    best = std::move(csv);
    equal = 0;
  }
  if (equal == 0) return best;
  return Error{
      name,
      fmt::format("cells may be separated by {} or by {}; a first line \"sep={}\" or "
                  "\"sep={}\" tells which",
                  separator_name(best->separator), separator_name(equal), best->separator, equal)};
}

/// The separator of a first line "sep=;", as spreadsheets write it.
std::optional<char> said_separator(std::string_view line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  const bool quoted = line.size() > 2 && line.front() == '"' && line.back() == '"';
  if (quoted) line = line.substr(1, line.size() - 2);
  if (line.size() != 5 || !(line.starts_with("sep=") || line.starts_with("SEP="))) return {};
  return line[4];
}

}  // namespace

std::string_view separator_name(char separator) {
  return separator == ','   ? "commas"
         : separator == ';' ? "semicolons"
         : separator == '|' ? "bars"
                            : "tabs";
}

std::optional<double> csv_number(std::string_view cell, bool decimal_comma) {
  while (cell.starts_with(' ')) cell.remove_prefix(1);
  while (cell.ends_with(' ')) cell.remove_suffix(1);
  if (cell.starts_with('+')) cell.remove_prefix(1);
  std::string pointed(cell);
  if (decimal_comma) {
    if (cell.find('.') != std::string_view::npos) return {};
    if (const std::size_t comma = cell.find(','); comma != std::string_view::npos)
      pointed[comma] = '.';
  }
  double value = 0;
  const char* const end = pointed.data() + pointed.size();
  const auto [at, wrong] = from_chars(pointed.data(), end, value);
  if (wrong != std::errc{} || at != end || !std::isfinite(value)) return {};
  return value;
}

Expected<CsvRows> read_csv(std::string_view bytes, const std::string& name) {
  if (const auto checked = check_encoding(bytes, name); !checked) return checked.error();
  if (bytes.starts_with(kUtf8Mark)) bytes.remove_prefix(kUtf8Mark.size());
  const std::string_view first = bytes.substr(0, line_size(bytes));
  const std::optional<char> said = said_separator(first);
  if (said &&
      std::find(std::begin(kSeparators), std::end(kSeparators), *said) == std::end(kSeparators))
    return Error{at_line(name, 1),
                 fmt::format("cells are separated by commas, semicolons, tabs or bars, "
                             "not by {}",
                             in_quotes(std::string_view(&*said, 1)))};
  auto csv =
      said ? read_separated(bytes.substr(first.size()), 2, *said, name) : best_reading(bytes, name);
  if (!csv) return csv.error();
  if (!csv->rows.empty() && csv->rows[0].size() > kMostColumns)
    return Error{name, fmt::format("more than {} columns", kMostColumns)};
  if (const auto row = uneven(*csv))
    return Error{at_line(name, csv->lines[*row]),
                 fmt::format("{} cells separated by {}, the heading has {}", csv->rows[*row].size(),
                             separator_name(csv->separator), csv->rows[0].size())};
  return csv;
}

}  // namespace mien::command
