#include "sdf/arrange/foreseen.h"
#include "lib/base/watch.h"
#include "sdf/outline/curve/piece_count.h"

#include <variant>

namespace mien {
namespace {

constexpr std::uint64_t kBytesOfPiece = sizeof(OutlinePiece);

std::uint64_t path_sides(const Shape& shape) {
  std::uint64_t sides = 0;
  if (const Path* path = std::get_if<Path>(&shape))
    for (const Path::Loop& loop : path->loops) sides += loop.sides.size();
  return sides;
}

/// Whether so many sides of paths may be too much. Most are cut twice at most, where x and y turn.
bool may_be_too_much(std::uint64_t sides) {
  constexpr std::uint64_t kPiecesOfSide = 3;
  return sides > 0 && !may_hold(sides * kPiecesOfSide * kBytesOfPiece);
}

}  // namespace

std::uint64_t least_bytes(const AreaPrograms& programs, std::span<const OutlineSource> sources,
                          const OutlineFrame& frame) {
  PieceCount count(frame);
  for (const OutlineSource& source : sources)
    if (const Path* path = std::get_if<Path>(&programs.shape(source));
        path && source.amount == 0.0 && !source.rim)
      count.add(*path);
  return count.pieces() * kBytesOfPiece;
}

void foresee(const AreaPrograms& programs, std::span<const OutlineSource> sources,
             const OutlineFrame& frame) {
  std::uint64_t sides = 0;
  for (const OutlineSource& source : sources) sides += path_sides(programs.shape(source));
  if (may_be_too_much(sides)) foresees(least_bytes(programs, sources, frame));
}

void foresee(const Scene& scene, const OutlineFrame& frame) {
  std::uint64_t sides = 0;
  for (const Shape& shape : scene.shapes()) sides += path_sides(shape);
  if (!may_be_too_much(sides)) return;
  AreaPrograms programs;
  programs.begin(scene);
  for (const Layer& layer : scene.layers()) programs.add(layer.area);
  foresee(programs, programs.outlines(), frame);
}

}  // namespace mien
