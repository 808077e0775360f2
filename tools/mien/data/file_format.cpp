#include "tools/mien/data/file_format.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

namespace mien::command {

void expect_format(const Reading& in, const JsonNode& root, std::string_view format) {
  const JsonNode& found = in.need(root, "format");
  if (in.string(found) != format)
    in.refuse(found, fmt::format("expected \"{}\", got {}", format, in_quotes(in.string(found))));
  const JsonNode& version = in.need(root, "format_version");
  if (in.number(version) != 1) in.refuse(version, "expected the integer 1");
}

}  // namespace mien::command
