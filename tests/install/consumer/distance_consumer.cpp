// Distances of many points, from a program that knows nothing else of mien.
#include <mien/distance.h>

#include <vector>

int main() {
  const mien::QuadBezier line{{0, 0}, {1, 0}, {2, 0}};
  const std::vector<float> x{0, 1, 3}, y{1, 2, 0};
  std::vector<float> d(3);
  mien::distances(line, x, y, d);
  return d[0] == 1 && d[1] == 2 && d[2] == 1 && mien::distance(line, {1, 5}) == 5 ? 0 : 1;
}
