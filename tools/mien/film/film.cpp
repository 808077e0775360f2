#include "tools/mien/film/film.h"
#include "render/image/file/atomic_file.h"
#include "render/image/file/output_path.h"
#include "render/image/file/system_error.h"
#include "render/image/file_type.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <vector>

namespace mien::command {
namespace {

using Words = std::vector<std::string>;

/// sRGB pixels become BT.709 video, which has the same primaries.
constexpr char kToVideo[] = "scale=in_range=full:out_range=tv:out_color_matrix=bt709";

/// The encoder's options, with a blank between two.
std::string codec_options(FilmType type, bool transparent) {
  switch (type) {
    case FilmType::mp4:
      return fmt::format(
          "-vf {} -c:v libx264 -preset medium -crf 16 -pix_fmt yuv420p -colorspace bt709 "
          "-color_primaries bt709 -color_trc bt709 -color_range tv -movflags +faststart -f mp4",
          kToVideo);
    case FilmType::webm:
      return fmt::format(
          "-vf {} -c:v libvpx-vp9 -b:v 0 -crf 20 -deadline good -cpu-used 5 -row-mt 1 "
          "-auto-alt-ref 0 -pix_fmt {} -colorspace bt709 -f webm",
          kToVideo, transparent ? "yuva420p" : "yuv420p");
    case FilmType::webp:
      return "-c:v libwebp_anim -lossless 1 -compression_level 3 -loop 0 -pix_fmt bgra -f webp";
    case FilmType::apng:
      return fmt::format("-c:v apng -plays 0 -pix_fmt {} -f apng", transparent ? "rgba" : "rgb24");
    case FilmType::gif:
      return "-filter_complex split[a][b];[a]palettegen=stats_mode=diff[p];"
             "[b][p]paletteuse=dither=sierra2_4a -loop 0 -f gif";
  }
  return {};
}

void add_words(const std::string& text, Words& words) {
  std::istringstream options(text);
  words.insert(words.end(), std::istream_iterator<std::string>{options}, {});
}

Words ffmpeg_words(const std::string& to, FilmType type, int width, int height, double fps,
                   bool transparent, const std::optional<FilmSound>& sound) {
  Words words;
  add_words(fmt::format("ffmpeg -hide_banner -loglevel error -nostdin -y -f rawvideo -pix_fmt rgba "
                        "-s {}x{} -r {} -i pipe:0",
                        width, height, fps),
            words);
  if (sound) {
    add_words(fmt::format("-ss {:.6f} -i", sound->from), words);
    words.push_back("file:" + sound->path);
    // Padded without end, then cut: it lasts as long as the pictures, to a sample.
    add_words(
        fmt::format(
            "-map 0:v:0 -map 1:a:0 -af apad,atrim=end={:.6f} -ar 48000 -flags:a +bitexact {}",
            sound->length, type == FilmType::mp4 ? "-c:a aac -b:a 160k" : "-c:a libopus -b:a 128k"),
        words);
  }
  add_words("-fflags +bitexact -flags:v +bitexact " + codec_options(type, transparent), words);
  words.push_back(to);
  return words;
}

}  // namespace

std::optional<FilmType> film_type(const std::string& path) {
  const std::string extension = lower_extension(path);
  const std::pair<const char*, FilmType> known[] = {{".mp4", FilmType::mp4},
                                                    {".webm", FilmType::webm},
                                                    {".webp", FilmType::webp},
                                                    {".apng", FilmType::apng},
                                                    {".gif", FilmType::gif}};
  for (const auto& [name, type] : known)
    if (extension == name) return type;
  return {};
}

bool holds_transparency(FilmType type) {
  return type != FilmType::mp4;
}

bool holds_sound(FilmType type) {
  return type == FilmType::mp4 || type == FilmType::webm;
}

struct Film::Process {
  AtomicFile file;
  std::string name;
  pid_t id = -1;
  int pipe = -1;
  std::FILE* said = nullptr;  // what ffmpeg complained of

  explicit Process(AtomicFile to) : file(std::move(to)) {}
  ~Process() {
    if (pipe >= 0) ::close(pipe);
    if (id > 0) {  // its input has ended, so it ends too
      int status = 0;
      ::waitpid(id, &status, 0);
    }
    if (said) std::fclose(said);
  }

  /// Starts the program whose name is the first word, reading from `input`. Returns 0 or an errno.
  int start(const Words& words, int input) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input, 0);
    ::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, ::fileno(said), 2);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    // A process group of its own: Ctrl-C is for this program only.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int failed = ::posix_spawnp(&id, argv[0], &actions, &attributes, argv.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    return failed;
  }

  std::string last_words() const {
    std::rewind(said);
    std::string text;
    char block[4096];
    while (const std::size_t got = std::fread(block, 1, sizeof block, said))
      text.append(block, got);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
  }
};

Film::Film(std::unique_ptr<Process> process) : process_(std::move(process)) {}
Film::Film(Film&&) noexcept = default;
Film::~Film() = default;

Expected<Film> Film::begin(const std::string& path, FilmType type, int width, int height,
                           double fps, bool transparent, const std::optional<FilmSound>& sound) {
  if (type == FilmType::mp4 && (width % 2 || height % 2))
    return Error{path, fmt::format("an mp4 has even sides, not {} x {}", width, height)};
  const auto target = find_output_path(path);
  if (!target) return target.error();
  if (target->stream) return Error{path, "a film needs a file that can be replaced"};
  auto file = AtomicFile::begin(target->path);
  if (!file) return file.error();
  auto process = std::make_unique<Process>(*std::move(file));
  process->name = path;
  process->said = std::tmpfile();
  int ends[2];
  if (!process->said || ::pipe2(ends, O_CLOEXEC) != 0)
    return Error{path, "cannot be written: " + system_error(errno)};
  process->pipe = ends[1];
  const Words words = ffmpeg_words(process->file.temporary().string(), type, width, height, fps,
                                   transparent, sound);
  const int failed = process->start(words, ends[0]);
  ::close(ends[0]);
  if (failed) {
    process->id = -1;
    return Error{path,
                 failed == ENOENT
                     ? "films are made by ffmpeg, which is not here: install the package ffmpeg"
                     : "ffmpeg cannot be started: " + system_error(failed)};
  }
  return Film(std::move(process));
}

Expected<Done> Film::add(const Image& frame) {
  const auto* at = reinterpret_cast<const char*>(frame.bytes.data());
  std::size_t left = frame.bytes.size();
  while (left > 0) {
    const ssize_t put = ::write(process_->pipe, at, left);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) {
      auto done = finish();
      return done ? Error{process_->name, "ffmpeg stopped early"} : done.error();
    }
    at += put;
    left -= std::size_t(put);
  }
  return Done{};
}

Expected<Done> Film::finish() {
  ::close(std::exchange(process_->pipe, -1));
  int status = 0;
  while (::waitpid(process_->id, &status, 0) < 0 && errno == EINTR) {
  }
  process_->id = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return Error{process_->name, "ffmpeg failed: " + process_->last_words()};
  return process_->file.commit();
}

}  // namespace mien::command
