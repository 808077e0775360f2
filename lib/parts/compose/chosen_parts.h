#pragma once
// The part of each family that a recipe takes: one of the library's, or one of the recipe's own.

#include <mien/expected.h>
#include <mien/recipe.h>
#include "lib/parts/library/part_library.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mien {

/// What the recipe asks for that the library does not have; nothing if it has all.
std::optional<Error> wrong_in(const PartLibrary& library, const Recipe& recipe);

/// Families without a part in the recipe, and that need one, take the usual one; the style has its present name.
Recipe completed(const PartLibrary& library, Recipe recipe);

/// The library's part that a recipe takes of a family; null: none, or one of its own.
const Part* chosen_part(const PartLibrary& library, const Recipe& recipe, std::string_view family);

class ChosenParts {
 public:
  /// Reads the recipe's own parts. The library must outlive what comes of it. The error names what is unknown or out of
  /// range, in a part of one's own with its place.
  static Expected<ChosenParts> read(const PartLibrary& library, const Recipe& recipe);
  /// From the shipped library.
  static Expected<ChosenParts> read(const Recipe& recipe);

  const PartLibrary& library() const { return *library_; }
  const Recipe& recipe() const { return recipe_; }  ///< completed, as its style draws it
  const Part* of(std::string_view family) const;    ///< null: none
  /// Whether it has one of these, {"beard": ["full", "long"], "moustache": ["walrus"]}.
  bool wears(const Reading& in, const JsonNode& parts) const;
  std::uint64_t person() const { return person_; }  ///< person_seed of the recipe, styled or not

 private:
  ChosenParts(const PartLibrary& library, Recipe recipe, std::uint64_t person)
      : library_(&library), recipe_(std::move(recipe)), person_(person) {}
  void read_own(const Family& family, const OwnPart& own);

  const PartLibrary* library_;
  Recipe recipe_;
  std::uint64_t person_;
  std::deque<LibraryFile> files_;
  std::map<std::string, Part, std::less<>> own_;  ///< by family
};

}  // namespace mien
