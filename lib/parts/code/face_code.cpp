#include <mien/face_code.h>
#include "lib/base/memory_ran_out.h"
#include "lib/base/mixed_bits.h"
#include "lib/base/one_line.h"
#include "lib/parts/code/edition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

// Crockford's base 32 (crockford.com/base32.html): no I, L, O and U.
constexpr std::string_view kSigns = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
constexpr int kSeedSigns = FaceCode::kSeedBits / 5, kBodySigns = 1 + kSeedSigns;
constexpr std::size_t kMostHeld = 256;

/// −1: no sign.
int value_of(char sign) {
  if (sign >= 'a' && sign <= 'z') sign = char(sign - 'a' + 'A');
  if (sign == 'O') sign = '0';
  if (sign == 'I' || sign == 'L') sign = '1';
  const std::size_t at = kSigns.find(sign);
  return at == std::string_view::npos ? -1 : int(at);
}

/// a·b in GF(32), modulo x⁵ + x² + 1.
int product(int a, int b) {
  int sum = 0;
  for (; b; b >>= 1) {
    if (b & 1) sum ^= a;
    a <<= 1;
    if (a & 32) a ^= 0b100101;
  }
  return sum;
}

/// Σ value · xⁱ: weights of neighbours differ and none is 0, so that one wrong sign or one swap shows. Weights come
/// again after 31 signs.
int check_of(const std::vector<int>& values) {
  int sum = 0, weight = 1;
  for (const int value : values) sum ^= product(value, weight = product(weight, 2));
  return sum;
}

std::vector<int> values_of(const FaceCode& code) {
  std::vector<int> values{value_of(kEdition)};
  for (int i = kSeedSigns - 1; i >= 0; --i) values.push_back(int(code.seed >> (5 * i) & 31));
  for (const HeldValue& held : code.held)
    for (const int part : {held.field, held.value}) {
      values.push_back(part >> 5 & 31);
      values.push_back(part & 31);
    }
  return values;
}

}  // namespace

std::string face_code_text(const FaceCode& code) {
  const std::vector<int> values = values_of(code);
  std::string text;
  const auto add = [&](int value) { text += kSigns[std::size_t(value)]; };
  for (int i = 0; i < kBodySigns; ++i) {
    if (i == 5 || i == 10) text += '-';
    add(values[std::size_t(i)]);
  }
  add(check_of(values));
  for (std::size_t i = kBodySigns; i < values.size(); ++i) {
    if ((i - kBodySigns) % 4 == 0) text += '~';
    add(values[i]);
  }
  return text;
}

bool looks_like_face_code(std::string_view text) {
  const std::string_view body = text.substr(0, text.find('~'));
  const auto known = [](char c) { return c == '-' || value_of(c) >= 0 || c == 'u' || c == 'U'; };
  const auto hyphens = std::count(body.begin(), body.end(), '-');
  return std::all_of(body.begin(), body.end(), known) &&
         int(body.size() - std::size_t(hyphens)) == kBodySigns + 1;
}

Expected<FaceCode> read_face_code(std::string_view text) try {
  const std::string where = "code " + one_line(text, 60);
  const std::size_t tilde = std::min(text.find('~'), text.size());
  std::vector<int> values;
  for (const char sign : text) {
    if (sign == '-' || sign == '~') continue;
    const int value = value_of(sign);
    if (value < 0)
      return Error{where, fmt::format("\"{}\" is no sign of a code; those are {}",
                                      one_line({&sign, 1}, 4), kSigns)};
    values.push_back(value);
    if (values.size() > kBodySigns + 1 + 4 * kMostHeld)
      return Error{where, fmt::format("it is longer than a code that holds {} values", kMostHeld)};
  }
  const std::string_view unheld = text.substr(0, tilde);
  const auto signs = std::count_if(unheld.begin(), unheld.end(), [](char c) { return c != '-'; });
  if (signs != kBodySigns + 1)
    return Error{where, fmt::format("a code has {} signs before what it holds, this has {}",
                                    kBodySigns + 1, signs)};
  if ((values.size() - kBodySigns - 1) % 4 != 0)
    return Error{where, "a held value has four signs: two of its field, two of the value"};
  const int check = values[kBodySigns];
  values.erase(values.begin() + kBodySigns);
  if (check_of(values) != check)
    return Error{where, "a sign is wrong, or two are swapped: its check sign does not fit"};
  if (values[0] != value_of(kEdition))
    return Error{where, unknown_edition(kSigns.substr(std::size_t(values[0]), 1))};
  FaceCode code;
  for (int i = 1; i < kBodySigns; ++i)
    code.seed = code.seed << 5 | std::uint64_t(values[std::size_t(i)]);
  for (std::size_t i = kBodySigns; i < values.size(); i += 4)
    code.held.push_back({values[i] << 5 | values[i + 1], values[i + 2] << 5 | values[i + 3]});
  return code;
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

std::uint64_t seed_from_word(std::string_view word) {
  std::uint64_t hash = 0;
  for (const char c : word)
    hash = mixed_bits(hash ^ std::uint64_t(static_cast<unsigned char>(c)) ^ 0x100);
  return hash >> (64 - FaceCode::kSeedBits);
}

}  // namespace mien
