#pragma once
// Tables of data: CSV files with a heading.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien::command {

struct Table {
  std::string name;                  ///< of its file
  std::vector<std::string> columns;  ///< their headings without blanks around, no two alike
  std::vector<std::vector<std::string>>
      rows;                        ///< a cell for each column; UTF-8 as it stands in the file
  std::vector<std::size_t> lines;  ///< on which line of the file each row begins
  bool decimal_commas = false;     ///< 1,5 is a number

  /// The index of a column; blanks around the name do not count.
  Expected<std::size_t> column(std::string_view heading) const;
  /// The finite number in a cell. The error has the row's line and names the column.
  Expected<double> number(std::size_t row, std::size_t column) const;
  /// Whether every row has a finite number there; the error is that of the first cell that has none.
  Expected<Done> numeric(std::size_t column) const;
  /// Whether texts stand there: at least half of the cells that are not empty are no numbers.
  bool has_texts(std::size_t column) const;
  /// Where a cell is: `states.csv:8: column "Murder"`.
  std::string place(std::size_t row, std::size_t column) const;
};

/// Reads a table (csv_rows.h says what is a CSV file). Decimal commas are a warning. Errors: a file
/// that cannot be read as CSV; no rows; two columns of one heading.
Expected<Table> read_table(const std::filesystem::path& path, std::vector<Error>* warnings);

/// Appends a cell to a line of CSV, in quotes where it needs them.
void add_cell(std::string& line, std::string_view cell);

}  // namespace mien::command
