#pragma once
// The rows of a CSV file (RFC 4180), whatever separates their cells.

#include <mien/expected.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::command {

struct CsvRows {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> lines;  ///< on which each row begins, counted from 1
  char separator = ',';
  bool decimal_commas = false;  ///< numbers are written 1,5; only where no comma separates cells
};

/// Reads a file's bytes. Cells are separated by commas, semicolons, tabs or bars: as a first line `sep=;`
/// says, or else so that every row has as many cells as the first and the most of them are numbers.
/// Blanks around cells are left out. Errors, with file and line: text that is not UTF-8, or holds
/// NULs; quotes that do not end; rows of other lengths; two separators that may be meant; more than
/// 100 000 rows or 1000 columns.
Expected<CsvRows> read_csv(std::string_view bytes, const std::string& name);

/// A finite number, written with a decimal comma if `decimal_comma`.
std::optional<double> csv_number(std::string_view cell, bool decimal_comma);

/// "tabs" of '\t', for messages.
std::string_view separator_name(char separator);

}  // namespace mien::command
