#pragma once
// One palette for a whole film, and how its colours are shown by it.
//
// The palette is found in OKLab, where distances are differences as they are seen: the colours are cut in two where that
// takes most off the sum of squared distances, until there are as many groups as the palette has places (the greedy cut of Wan,
// Wong and Prusinkiewicz 1988); then Lloyd's steps move colours to the nearest group. A place is the colour of the film
// nearest to its group's mean, so flat areas are shown as they are.
//
// A colour that is between two places is shown by both, ordered by a Bayer matrix. Which of them a pixel has depends on its
// colour and place alone, so what rests does not flicker.

#include <mien/image.h>

#include <cstdint>
#include <vector>

namespace mien::command {

class FilmPalette {
 public:
  struct Rgb {
    std::uint8_t r, g, b;
  };
  static constexpr int kMost = 255;

  /// A frame of 8 bits: those of its pixels that are there.
  void count(const Image& frame);
  /// After all that counts.
  void choose();
  const std::vector<Rgb>& colors() const { return colors_; }

  /// The place of a pixel, RGBA, that is there.
  std::uint8_t place_of(const std::uint8_t* pixel, int x, int y);

 private:
  std::uint32_t mix_of(std::uint32_t color) const;

  std::vector<std::uint32_t> of_color_;  // by packed colour: how often it is there, then its mix
  std::vector<Rgb> colors_;
  std::vector<float> l_, a_, b_;  // of the places
};

/// Whether a pixel is there, in a format in which pixels are or are not.
inline bool is_there(const std::uint8_t* pixel) {
  return pixel[3] >= 128;
}

}  // namespace mien::command
