// mien say: text becomes a track of sounds and a WAV, by mien-say, and a film of a face that speaks them.
//
// mien-say is a program of its own because the library that speaks is under the GPL. Track and sound are in files without
// a name while the film is made, so a killed run leaves nothing.

#include "lib/base/one_line.h"
#include "render/image/file/system_error.h"
#include "render/image/file/written_file.h"
#include "render/image/file_type.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/film/film.h"
#include "tools/mien/film/frame_names.h"
#include "tools/mien/terminal/child_process.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace mien::command {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using NamelessFile = std::unique_ptr<std::FILE, CloseFile>;

/// By which this program and those that it starts can open it.
std::string path_of(const NamelessFile& file) {
  return fmt::format("/proc/{}/fd/{}", ::getpid(), ::fileno(file.get()));
}

std::string bytes_of(const NamelessFile& file) {
  std::rewind(file.get());
  std::string bytes;
  char block[1 << 16];
  while (const std::size_t got = std::fread(block, 1, sizeof block, file.get()))
    bytes.append(block, got);
  return bytes;
}

/// What mien-say takes and gives.
struct Speech {
  NamelessFile text{std::tmpfile()}, track{std::tmpfile()}, sound{std::tmpfile()},
      said{std::tmpfile()};
  bool good() const { return text && track && sound && said; }
};

/// The program beside this one, or else one in PATH.
std::string say_program() {
  std::error_code failed;
  const auto own = std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
  const auto beside = own / "mien-say";
  return ::access(beside.c_str(), X_OK) == 0 ? beside.string() : "mien-say";
}

Expected<int> run_mien_say(const SayArguments& arguments, const Speech& speech) {
  std::vector<std::string> words{say_program(), "--track", path_of(speech.track)};
  if (arguments.voices) words = {words[0], "--voices"};
  const auto add = [&](const char* option, const std::optional<std::string>& value) {
    if (value) words.push_back(option), words.push_back(*value);
  };
  if (!arguments.voices) {
    add("--voice", arguments.voice);
    add("--rate", arguments.rate);
    add("--pitch", arguments.pitch);
  }
  const int text = arguments.text == "-" ? STDIN_FILENO : ::fileno(speech.text.get());
  pid_t id = -1;
  const int failed =
      start_process(words, {text, ::fileno(speech.sound.get()), ::fileno(speech.said.get())}, id);
  if (failed == ENOENT)
    return Error{"say",
                 "text is spoken by the program mien-say, which is not here: install the package "
                 "mien-say, or build mien with -DMIEN_BUILD_SAY=ON"};
  if (failed) return Error{"say", "mien-say cannot be started: " + system_error(failed)};
  return end_of_process(id);
}

/// Fills the speech, or gives the exit code after the error has been printed.
int speak(const SayArguments& arguments, const Speech& speech) {
  if (!speech.good())
    return complain({"say", "no temporary file: " + system_error(errno)}, kFailed);
  const std::string& text = arguments.text;
  if (std::fwrite(text.data(), 1, text.size(), speech.text.get()) != text.size() ||
      std::fflush(speech.text.get()) != 0)
    return complain({"say", "no temporary file: " + system_error(errno)}, kFailed);
  std::rewind(speech.text.get());
  const auto code = run_mien_say(arguments, speech);
  if (!code) return complain(code.error(), kFailed);
  if (*code == 0) return kDone;
  std::string said = last_line(speech.said.get());
  constexpr std::string_view kName = "mien-say: ";
  if (said.starts_with(kName)) said.erase(0, kName.size());
  if (said.empty()) said = "say: mien-say ended without a word";
  return complain(said, *code == int(kUsedWrongly) ? kUsedWrongly : kFailed);
}

int write_bytes(const std::string& path, const std::string& bytes) {
  const auto done =
      write_file(path, [&](const PutBytes& put) { return put(bytes.data(), bytes.size()); });
  return done ? int(kDone) : complain(done.error(), kFailed);
}

enum class Spoken { nothing, track, film };

/// What the output is by its name.
Expected<Spoken> kind_of_output(const std::string& output) {
  const std::string extension = lower_extension(output);
  if (output.empty()) return Spoken::nothing;
  if (extension == ".tsv") return Spoken::track;
  const auto names = read_frame_names(output);
  if (!names) return names.error();
  if (*names || film_type(output) || extension == ".png") return Spoken::film;
  return Error{"-o " + one_line(output, 60),
               extension == ".wav" ? "the sound is for --sound"
                                   : "expected a film: .mp4 .webm .webp .apng .gif, pictures like "
                                     "frames/%05d.png, or .tsv for the track"};
}

/// What can be known to be wrong before anything is spoken.
Expected<Spoken> plan_say(const SayArguments& arguments) {
  if (arguments.voices) return Spoken::nothing;
  if (arguments.text.empty()) return Error{"TEXT", "is empty"};
  const auto& [render, frames, fps, sound, again] = arguments.animate;
  const auto kind = kind_of_output(render.output);
  if (kind && *kind == Spoken::nothing && !sound)
    return Error{"say", "-o FILE or --sound FILE is needed"};
  return kind;
}

}  // namespace

int say_command(const SayArguments& arguments) {
  const auto kind = plan_say(arguments);
  if (!kind) return complain(kind.error(), kUsedWrongly);
  const Speech speech;
  if (const int code = speak(arguments, speech); code != kDone) return code;
  if (arguments.voices) return print(bytes_of(speech.sound));
  AnimateArguments animate = arguments.animate;
  if (animate.sound)
    if (const int code = write_bytes(*animate.sound, bytes_of(speech.sound)); code != kDone)
      return code;
  const std::string& output = animate.render.output;
  if (*kind == Spoken::track) return write_bytes(output, bytes_of(speech.track));
  if (*kind == Spoken::nothing) return kDone;
  if (animate.render.posed.face.empty()) animate.render.posed.face = "toon";
  animate.render.posed.speech = path_of(speech.track);
  const auto film = film_type(output);
  animate.sound.reset();
  if (film && holds_sound(*film)) animate.sound = path_of(speech.sound);
  return animate_command(animate);
}

}  // namespace mien::command
