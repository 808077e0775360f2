#pragma once
// What is by chance and yet one person's own: a hand, clothes of a style, idle life.

#include <mien/recipe.h>

#include <cstdint>

namespace mien {

/// seed_from_word of the code that the recipe was made from, wherever the code is written in another way; without one, of
/// the recipe's text but for its style.
std::uint64_t person_seed(const Recipe& recipe);

}  // namespace mien
