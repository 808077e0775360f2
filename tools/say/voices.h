#pragma once
// Voices of eSpeak NG by what people call them.

#include <mien/expected.h>

#include <string>

namespace mien::say {

/// Speaks with a voice from now on: a language ("en", "pt-br"), a voice's name ("English (Scotland)"), or either with a
/// variant ("de+f3"). Of several for a language it is the one that eSpeak prefers. The error names the nearest one.
Expected<Done> take_voice(const std::string& wanted);

/// "LANGUAGE<TAB>NAME", a line for each voice.
std::string list_of_voices();

}  // namespace mien::say
