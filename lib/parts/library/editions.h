#pragma once
// Editions of the library of parts. Each is frozen for ever but the trial one; all are compiled in, side by side.

#include <mien/api.h>
#include <mien/expected.h>

#include <string>
#include <string_view>

namespace mien {

/// Its parts, and so its faces, may still change.
inline constexpr char kTrialEdition = 'A';

/// The signs of the editions that this build has, from the oldest; the trial one is the last.
MIEN_API std::string_view editions();

/// The newest that is frozen; the trial one while there is none. Codes and recipes that name no edition are of it.
MIEN_API char newest_edition();

/// "A". The error says which editions there are.
MIEN_API Expected<char> read_edition(std::string_view text);

}  // namespace mien
