#pragma once
// What varies in a job: a name and the values that it takes, one after the other.

#include <mien/view.h>

#include <string>
#include <vector>

namespace mien::command {

struct Variable {
  enum class Kind {
    words,    ///< as the plan lists them
    numbers,  ///< from `first` on
    people,   ///< codes, by a word
    regions,  ///< of one picture
    frames,   ///< of one film, from `first` on
    stimuli   ///< pictures of an experiment
  };

  std::string name;
  Kind kind = Kind::words;
  long count = 0;
  long first = 0;                  ///< of numbers and frames
  std::string seed;                ///< of people
  std::string file;                ///< of stimuli: the experiment's plan
  int columns = 0, rows = 0;       ///< of regions
  std::vector<std::string> words;  ///< of words; of stimuli: the pictures' file names
  std::vector<PixelRect> rects;    ///< of regions, row by row from the top

  /// What stands in names and arguments for {name}. Numbers are filled up with zeros, so names sort as they count. The i-th person
  /// of a word is that of the seed WORD/i. Regions are r0c0 and so on, by row and column.
  std::string text(long i) const;
  /// What the value adds to a command's arguments: --region, --frames.
  std::vector<std::string> arguments(long i) const;
  /// Whether its items are pieces of one file.
  bool cuts() const { return kind >= Kind::regions; }
};

/// So many columns and rows of a picture that is so large. Large regions begin at multiples of 256 pixels, as tiles do.
std::vector<PixelRect> cut_regions(int width, int height, int columns, int rows);

}  // namespace mien::command
