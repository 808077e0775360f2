#pragma once
// A film: frames go through a pipe into an ffmpeg process, which writes them to a file. The film appears
// whole or not at all.

#include <mien/expected.h>
#include <mien/image.h>

#include <memory>
#include <optional>
#include <string>

namespace mien::command {

enum class FilmType { mp4, webm, webp, apng, gif };

/// By the extension, if it is a film's.
std::optional<FilmType> film_type(const std::string& path);
/// Whether the type holds transparency.
bool holds_transparency(FilmType type);

/// Whether the type has sound.
bool holds_sound(FilmType type);

/// What is heard: a file that ffmpeg reads. It is cut or goes on in silence, so that it lasts as long as the pictures.
struct FilmSound {
  std::string path;
  double from = 0;    ///< [s] what comes before is left out
  double length = 0;  ///< [s] of the film
};

class Film {
 public:
  /// Starts ffmpeg. Errors: it is not installed (names the package), sides that the type cannot have, no
  /// place to write.
  static Expected<Film> begin(const std::string& path, FilmType type, int width, int height,
                              double fps, bool transparent,
                              const std::optional<FilmSound>& sound = {});
  Film(Film&&) noexcept;
  ~Film();  ///< without finish nothing is left

  /// The next frame, 8 bits.
  Expected<Done> add(const Image& frame);
  /// Waits for ffmpeg; then the film is in its place.
  Expected<Done> finish();

 private:
  struct Process;
  explicit Film(std::unique_ptr<Process> process);
  std::unique_ptr<Process> process_;
};

}  // namespace mien::command
