#pragma once
// A film: frames become a file, which appears whole or not at all. Animated pictures are written here, the others by ffmpeg.

#include <mien/expected.h>
#include <mien/image.h>

#include <functional>
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

struct FilmPlan {
  FilmType type = FilmType::mp4;
  int width = 0, height = 0;
  double fps = 30;
  bool transparent = false;
  std::optional<FilmSound> sound = {};
  long frames = 0;
  int threads = 1;
  /// Draws frame 0 … frames − 1, on several threads at once; an error's `where` is left empty. Films with a palette look at
  /// some of them first.
  std::function<Expected<Image>(long frame)> draw = {};
};

/// Takes frames of 8 bits, in order. Without finish nothing is left.
class FilmWriter {
 public:
  virtual ~FilmWriter() = default;
  virtual Expected<Done> add(const Image& frame) = 0;
  /// Then the film is in its place.
  virtual Expected<Done> finish() = 0;
};

/// Errors: what writes the type is not installed, sides that it cannot have, no place to write.
Expected<std::unique_ptr<FilmWriter>> begin_film(const std::string& path, const FilmPlan& plan);

}  // namespace mien::command
