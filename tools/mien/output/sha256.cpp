#include "tools/mien/output/sha256.h"
#include "lib/file/json/read_bytes.h"
#include "tools/mien/terminal/interrupt.h"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace mien::command {
namespace {

std::string digest_text(sha256_ctx& state) {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&state, digest.size(), digest.data());
  std::string text;
  for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace

std::string sha256(std::span<const std::byte> bytes) {
  sha256_ctx state;
  sha256_init(&state);
  sha256_update(&state, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return digest_text(state);
}

Expected<std::string> sha256_of_file(const std::filesystem::path& path) {
  sha256_ctx state;
  sha256_init(&state);
  const auto read = read_in_blocks(path, [&](std::string_view block) {
    sha256_update(&state, block.size(), reinterpret_cast<const std::uint8_t*>(block.data()));
    return !interrupted();
  });
  if (!read) return read.error();
  if (interrupted()) return Error{"", "cancelled"};
  return digest_text(state);
}

}  // namespace mien::command
