#include <mien/editions.h>

#include "lib/base/one_line.h"
#include "lib/parts/library/edition_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

/// "A, B and Z".
std::string listed(std::string_view signs) {
  std::string text;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (i > 0) text += i + 1 < signs.size() ? ", " : " and ";
    text += signs[i];
  }
  return text;
}

}  // namespace

std::string_view editions() {
  static const std::string signs = [] {
    std::string all;
    for (const ShippedFolder& folder : shipped_folders()) all += folder.edition;
    return all;
  }();
  return signs;
}

char newest_edition() {
  return newest_of(editions());
}

Expected<char> read_edition(std::string_view text) {
  if (text.size() == 1 && editions().find(text[0]) != std::string_view::npos) return text[0];
  return Error{{},
               fmt::format("edition {} is not known to this version, which has {}",
                           one_line(text, 20), listed(editions()))};
}

std::vector<ShippedPart> edition_files(std::span<const ShippedFolder> folders, char edition) {
  std::vector<ShippedPart> files;
  for (const ShippedFolder& folder : folders) {
    if (folder.edition > edition) break;
    const auto is_topology = [](const ShippedPart& part) { return part.name == kTopologyFile; };
    if (std::any_of(folder.parts.begin(), folder.parts.end(), is_topology)) files.clear();
    files.insert(files.end(), folder.parts.begin(), folder.parts.end());
  }
  return files;
}

char newest_of(std::string_view signs) {
  const std::size_t frozen = signs.find_last_not_of(kTrialEdition);
  return frozen == std::string_view::npos ? kTrialEdition : signs[frozen];
}

}  // namespace mien
