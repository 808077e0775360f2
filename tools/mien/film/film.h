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

class Film {
 public:
  /// Starts ffmpeg. Errors: it is not installed (names the package), sides that the type cannot have, no
  /// place to write.
  static Expected<Film> begin(const std::string& path, FilmType type, int width, int height,
                              double fps, bool transparent);
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
