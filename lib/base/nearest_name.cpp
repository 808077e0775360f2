#include "lib/base/nearest_name.h"

#include "lib/base/one_line.h"
#include "lib/base/synonyms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace mien {
namespace {

constexpr std::size_t kLongestWanted = 100;  ///< a longer text is no mistyped name
constexpr std::size_t kShort = 4;            ///< such words begin with the right letter
constexpr int kNever = 1000;                 ///< more wrong letters than any slip has
constexpr std::size_t kMostListed = 12;      ///< more names are no sentence
constexpr std::size_t kLongestList = 160;    ///< nor are longer ones, of letters
constexpr std::size_t kLeastWord = 4;        ///< shorter ones are in too many names to mean one

/// In lower case, without separators but dots between parts, "head/Turn_x" to "head.turnx", and
/// without the dashes of an option.
std::string closed_up(std::string_view name) {
  std::string closed;
  for (const char c : name)
    if (c >= 'A' && c <= 'Z')
      closed += char(c - 'A' + 'a');
    else if (c != '-' && c != '_' && c != ' ')
      closed += c == '/' ? '.' : c;
  for (std::size_t at; (at = closed.find("colour")) != std::string::npos;) closed.erase(at + 4, 1);
  return closed;
}

std::size_t last_begin(std::string_view name) {
  const std::size_t mark = name.find_last_of("./");
  return mark == std::string_view::npos ? 0 : mark + 1;
}

std::string_view last_part(std::string_view name) {
  return name.substr(last_begin(name));
}

/// "browInner-up" has the words brow, inner and up.
bool has_word(std::string_view name, std::string_view word) {
  std::string at;
  for (const char c : name) {
    const bool capital = c >= 'A' && c <= 'Z', mark = c == '-' || c == '_' || c == '.' || c == '/';
    if (capital || mark) {
      if (at == word) return true;
      at.clear();
    }
    if (!mark) at += capital ? char(c - 'A' + 'a') : c;
  }
  return at == word;
}

struct Wanted {
  explicit Wanted(std::string_view said) : text(said), closed(closed_up(said)) {}
  std::string_view text;
  std::string closed;
};

/// "--set" of "--set yaw=DEGREES", "set" of "set: yaw".
std::string_view first_word(std::string_view text) {
  return text.substr(0, text.find_first_of(" :"));
}

std::string_view shortest_ending(const std::vector<std::string_view>& names, std::string_view end) {
  std::string_view shortest;
  for (const std::string_view name : names)
    if (name.ends_with(end) && (shortest.empty() || name.size() < shortest.size())) shortest = name;
  return shortest;
}

/// The name that a meaning is in this list: with what stands before the word asked for, as it is,
/// or as the end of the shortest longer name; empty: none.
std::string_view of_meaning(const Wanted& asked, std::string_view meaning,
                            const std::vector<std::string_view>& names) {
  const std::string before(asked.text.substr(0, last_begin(asked.text)));
  const std::string whole = before + std::string(meaning);
  for (const std::string_view name : names)
    if (name == whole) return name;
  if (const auto longer = shortest_ending(names, "." + whole); !longer.empty()) return longer;
  for (const std::string_view name : names)
    if (name == first_word(meaning)) return meaning;
  return shortest_ending(names, fmt::format(".{}", meaning));
}

std::string_view of_meanings(const Wanted& asked, std::span<const std::string_view> means,
                             const std::vector<std::string_view>& names) {
  for (const std::string_view meaning : means)
    if (const auto found = of_meaning(asked, meaning, names); !found.empty()) return found;
  return {};
}

std::string digits(std::string_view text) {
  std::string all;
  std::copy_if(text.begin(), text.end(), std::back_inserter(all),
               [](char c) { return c >= '0' && c <= '9'; });
  return all;
}

bool begin_alike(std::string_view a, std::string_view b) {
  return !a.empty() && !b.empty() && a[0] == b[0];
}

/// How many letters of a are wrong, if it may be a slip of the hand: one of `share` letters at most,
/// but always `least`, and the first only in a long word and alone; else as many as never. A wrong
/// digit is no slip: AU12 is not AU13.
int slips(std::string_view a, std::string_view b, int share, int least) {
  if (digits(a) != digits(b)) return kNever;
  const int allowed = std::max(int(a.size()) / share, least);
  const int edits = edit_distance(a, b, allowed);
  if (edits > allowed) return kNever;
  const bool short_name = std::min(a.size(), b.size()) <= kShort;
  if (begin_alike(a, b) || (a.size() == 1 && least > 0)) return edits;
  const bool swapped = a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0];
  return edits > 1 || (short_name && !swapped) ? kNever : edits;
}

/// The name with the fewest wrong letters, a third at most, not counting the parts at its front that
/// both have ("gaze.z": one letter behind these may be wrong); else, with a quarter wrong at most, the
/// name whose last part it is. `known`: a word that is in use, which is no slip for another such word,
/// as "yaw" is none for "jaw".
std::string_view nearest_spelling(const Wanted& asked, const std::vector<std::string_view>& names,
                                  bool known) {
  std::string_view best;
  int least = kNever;
  const auto take = [&](std::string_view name, int edits) {
    if (edits < least && !(known && !meanings(closed_up(last_part(name))).empty()))
      best = name, least = edits;
  };
  for (const std::string_view name : names) {
    const std::string closed = closed_up(name);
    std::string_view a = asked.closed, b = closed;
    for (std::size_t dot;
         (dot = a.find('.')) != std::string_view::npos && b.starts_with(a.substr(0, dot + 1));)
      a.remove_prefix(dot + 1), b.remove_prefix(dot + 1);
    take(name, slips(a, b, 3, a.size() < asked.closed.size() ? 1 : 0));
  }
  if (!best.empty() || asked.closed.find('.') != std::string::npos) return best;
  for (const std::string_view name : names)
    take(name, slips(asked.closed, closed_up(last_part(name)), 4, asked.closed.size() > 2));
  return best;
}

/// The names that begin with the word (`front`), or have it as one of their words: whether there is
/// one, and it, if it is the only one. Both halves of a thing, "left.joy" and "right.joy", are one.
struct WithWord {
  bool some = false;
  std::string_view only;
};
WithWord with_word(const Wanted& asked, const std::vector<std::string_view>& names, bool front) {
  WithWord found;
  if (asked.closed.size() < kLeastWord) return found;
  for (const std::string_view name : names) {
    if (front ? !closed_up(last_part(name)).starts_with(asked.closed)
              : !has_word(name, asked.closed))
      continue;
    if (found.some && last_part(found.only) != last_part(name)) return {true, {}};
    if (!found.some || name.size() < found.only.size()) found.only = name;
    found.some = true;
  }
  return found;
}

/// All names, if they are few enough to be read in a sentence.
std::string listed(const std::vector<std::string_view>& names) {
  if (names.size() < 2 || names.size() > kMostListed) return {};
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char* const between = i == 0 ? "" : i + 1 < names.size() ? ", " : " and ";
    all += fmt::format("{}{}", between, in_quotes(names[i]));
  }
  return all.size() > kLongestList ? std::string{} : all;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b, int most) {
  const int n = int(a.size()), m = int(b.size());
  if (std::abs(n - m) > most) return most + 1;
  std::vector<int> before(m + 1), last(m + 1), row(m + 1);  // rows i − 2, i − 1 and i of the table
  for (int j = 0; j <= m; ++j) last[j] = j;
  for (int i = 1; i <= n; ++i) {
    row[0] = i;
    int least = i;
    for (int j = 1; j <= m; ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    if (least > most) return most + 1;
    before.swap(last);
    last.swap(row);
  }
  return std::min(last[m], most + 1);
}

std::string_view nearest_name(std::string_view wanted, const std::vector<std::string_view>& names) {
  if (wanted.size() > kLongestWanted) return {};
  const Wanted asked(wanted);
  if (asked.closed.empty()) return {};
  for (const std::string_view name : names)
    if (closed_up(name) == asked.closed) return name;
  const auto means = meanings(last_part(asked.closed));
  if (const auto meant = of_meanings(asked, means, names); !meant.empty()) return meant;
  if (means.empty())
    if (const WithWord has = with_word(asked, names, false); has.some) return has.only;
  const std::string_view spelt = nearest_spelling(asked, names, !means.empty());
  if (!spelt.empty() || !means.empty()) return spelt;
  return with_word(asked, names, true).only;
}

std::string unknown_name(std::string_view what, std::string_view wanted,
                         const std::vector<std::string_view>& names) {
  const std::string said = fmt::format("no {} named {}", what, in_quotes(wanted));
  if (const std::string_view near = nearest_name(wanted, names); !near.empty())
    return fmt::format("{}; did you mean {}?", said, in_quotes(near));
  const std::string all = listed(names);
  return all.empty() ? said : fmt::format("{}; there are {}", said, all);
}

}  // namespace mien
