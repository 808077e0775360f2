#include "tools/mien/film/ffmpeg_film.h"
#include "render/image/file/system_error.h"
#include "tools/mien/terminal/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <vector>

namespace mien::command {
namespace {

using Words = std::vector<std::string>;

/// sRGB pixels become BT.709 video, which has the same primaries.
constexpr char kToVideo[] = "scale=in_range=full:out_range=tv:out_color_matrix=bt709";

/// What the picture's numbers are, for players.
constexpr char kTagged[] =
    "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv";

/// The encoder's options, with a blank between two.
std::string codec_options(const FilmPlan& plan) {
  if (plan.type == FilmType::mp4)
    return fmt::format(
        "-vf {} -c:v libx264 -preset medium -crf 16 -pix_fmt yuv420p {} -movflags +faststart -f "
        "mp4",
        kToVideo, kTagged);
  return fmt::format(
      "-vf {} -c:v libvpx-vp9 -b:v 0 -crf 20 -deadline good -cpu-used 5 -row-mt 1 "
      "-auto-alt-ref 0 -pix_fmt {} {} -f webm",
      kToVideo, plan.transparent ? "yuva420p" : "yuv420p", kTagged);
}

void add_words(const std::string& text, Words& words) {
  std::istringstream options(text);
  words.insert(words.end(), std::istream_iterator<std::string>{options}, {});
}

Words ffmpeg_words(const std::string& to, const FilmPlan& plan) {
  Words words;
  add_words(fmt::format("ffmpeg -hide_banner -loglevel error -nostdin -y -f rawvideo -pix_fmt rgba "
                        "-s {}x{} -r {} -i pipe:0",
                        plan.width, plan.height, plan.fps),
            words);
  if (const auto& sound = plan.sound) {
    add_words(fmt::format("-ss {:.6f} -i", sound->from), words);
    words.push_back("file:" + sound->path);
    // Padded without end, then cut: it lasts as long as the pictures, to a sample.
    add_words(fmt::format(
                  "-map 0:v:0 -map 1:a:0 -af apad,atrim=end={:.6f} -ar 48000 -flags:a +bitexact {}",
                  sound->length,
                  plan.type == FilmType::mp4 ? "-c:a aac -b:a 160k" : "-c:a libopus -b:a 128k"),
              words);
  }
  add_words("-fflags +bitexact -flags:v +bitexact " + codec_options(plan), words);
  words.push_back(to);
  return words;
}

/// The process and the file it writes.
class FfmpegFilm final : public FilmWriter {
 public:
  FfmpegFilm(AtomicFile to, std::string name) : file_(std::move(to)), name_(std::move(name)) {}
  ~FfmpegFilm() override {
    if (pipe_ >= 0) ::close(pipe_);
    if (id_ > 0) end_of_process(id_);  // its input has ended, so it ends too
    if (said_) std::fclose(said_);
  }

  Expected<Done> begin(const FilmPlan& plan);
  Expected<Done> add(const Image& frame) override;
  Expected<Done> finish() override;

 private:
  /// Of ffmpeg's work, as far as it was given any.
  Expected<Done> end();

  AtomicFile file_;
  std::string name_;
  pid_t id_ = -1;
  int pipe_ = -1;
  std::FILE* said_ = nullptr;  // what ffmpeg complained of
};

/// The file that ffmpeg writes, as one of its descriptors. By its name it would be made anew where this program was
/// killed and the next one has removed it. Opened a second time, it does not share the lock, which ends with this program.
constexpr int kFilmDescriptor = 3;

Expected<Done> FfmpegFilm::begin(const FilmPlan& plan) {
  said_ = std::tmpfile();
  const int film = said_ ? ::open(file_.temporary().c_str(), O_RDWR | O_CLOEXEC) : -1;
  int ends[2];
  if (film < 0 || ::pipe2(ends, O_CLOEXEC) != 0) {
    const int failed = errno;
    if (film >= 0) ::close(film);
    return Error{name_, "cannot be written: " + system_error(failed)};
  }
  pipe_ = ends[1];
  const int failed = start_process(ffmpeg_words(fmt::format("/dev/fd/{}", kFilmDescriptor), plan),
                                   {ends[0], -1, ::fileno(said_), film}, id_);
  ::close(ends[0]);
  ::close(film);
  if (!failed) return Done{};
  id_ = -1;
  return Error{name_, failed == ENOENT
                          ? "films of this kind are made by ffmpeg, which is not here: install the "
                            "package ffmpeg, or take .webp, .apng or .gif"
                          : "ffmpeg cannot be started: " + system_error(failed)};
}

Expected<Done> FfmpegFilm::add(const Image& frame) {
  const auto* at = reinterpret_cast<const char*>(frame.bytes.data());
  std::size_t left = frame.bytes.size();
  while (left > 0) {
    const ssize_t put = ::write(pipe_, at, left);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) {
      auto done = end();
      return done ? Error{name_, "ffmpeg stopped early"} : done.error();
    }
    at += put;
    left -= std::size_t(put);
  }
  return Done{};
}

Expected<Done> FfmpegFilm::end() {
  ::close(std::exchange(pipe_, -1));
  const int code = end_of_process(std::exchange(id_, -1));
  if (code != 0) return Error{name_, "ffmpeg failed: " + last_line(said_)};
  return Done{};
}

Expected<Done> FfmpegFilm::finish() {
  if (auto done = end(); !done) return done;
  return file_.commit();
}

}  // namespace

Expected<std::unique_ptr<FilmWriter>> ffmpeg_film(AtomicFile file, const std::string& name,
                                                  const FilmPlan& plan) {
  if (plan.type == FilmType::mp4 && (plan.width % 2 || plan.height % 2))
    return Error{name, fmt::format("an mp4 has even sides, not {} x {}", plan.width, plan.height)};
  auto film = std::make_unique<FfmpegFilm>(std::move(file), name);
  if (auto begun = film->begin(plan); !begun) return begun.error();
  return std::unique_ptr<FilmWriter>(std::move(film));
}

}  // namespace mien::command
