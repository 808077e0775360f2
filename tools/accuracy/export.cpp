#include "tools/accuracy/export.h"

#include <fmt/format.h>

#include "tools/accuracy/reference.h"

namespace mien::accuracy {

void write_cases_header(std::ostream& out, uint64_t seed) {
  out << fmt::format(
             "# distances to quadratic Beziers; hex floats; seed {}; CC0 1.0, for anybody and "
             "anything\n",
             seed)
      << "family,x0,y0,x1,y1,x2,y2,px,py,distance,distance_rest\n";
}

void write_cases(std::ostream& out, const Family& family, size_t count, uint64_t seed) {
  for (const Case& k : cases_of(family, count, seed)) {
    const Quad truth = true_distance(k);
    const double head = double(truth), rest = double(truth - Quad(head));
    const QuadBezier& c = std::get<QuadBezier>(k.figure);
    out << fmt::format("{},{:a},{:a},{:a},{:a},{:a},{:a},{:a},{:a},{:a},{:a}\n", family.name,
                       c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y, k.p.x, k.p.y, head, rest);
  }
}

}  // namespace mien::accuracy
