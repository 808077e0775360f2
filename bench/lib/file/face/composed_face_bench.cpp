// What a face from a code costs, and its steps: the recipe of a seed, the composed face, its text. A hundred people in
// turn, so that no part is asked for twice in a row.

#include <mien/composed_face.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace mien {
namespace {

constexpr int kPeople = 100;

std::vector<FaceCode> people() {
  std::vector<FaceCode> all;
  for (int i = 0; i < kPeople; ++i) all.push_back({.seed = seed_from_word(std::to_string(i))});
  return all;
}

/// Each of `inputs` in turn, as one iteration.
template <class Input, class Verb>
void in_turn(benchmark::State& state, const std::vector<Input>& inputs, Verb verb) {
  if (!verb(inputs[0])) std::abort();  // the library of parts is read once
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(verb(inputs[next]));
    next = (next + 1) % inputs.size();
  }
}

std::vector<Recipe> recipes() {
  std::vector<Recipe> all;
  for (const FaceCode& code : people()) all.push_back(recipe_from_code(code).value());
  return all;
}

void face_of_code(benchmark::State& state) {
  std::vector<std::string> codes;
  for (const FaceCode& code : people()) codes.push_back(face_code_text(code));
  in_turn(state, codes, [](const std::string& code) { return face_from_code(code); });
}

void recipe_of_code(benchmark::State& state) {
  in_turn(state, people(), [](const FaceCode& code) { return recipe_from_code(code); });
}

void face_of_recipe(benchmark::State& state) {
  in_turn(state, recipes(), [](const Recipe& recipe) { return face_from_recipe(recipe); });
}

void text_of_recipe(benchmark::State& state) {
  in_turn(state, recipes(), [](const Recipe& recipe) { return face_text_from_recipe(recipe); });
}

BENCHMARK(face_of_code);
BENCHMARK(recipe_of_code);
BENCHMARK(face_of_recipe);
BENCHMARK(text_of_recipe);

}  // namespace
}  // namespace mien
