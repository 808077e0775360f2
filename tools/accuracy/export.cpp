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

void write_feet_header(std::ostream& out, uint64_t seed) {
  out << fmt::format(
             "# feet on quadratic Beziers; hex floats; seed {}; CC0 1.0, for anybody and "
             "anything\n",
             seed)
      << "family,x0,y0,x1,y1,x2,y2,px,py,t,distance,normal_x,normal_y,bend,next_t,next_distance,"
         "next_normal_x,"
         "next_normal_y,next_bend,next_barrier\n";
}

void write_feet(std::ostream& out, const FeetFamily& family, size_t count, uint64_t seed) {
  for (const FeetCase& k : feet_cases_of(family, count, seed)) {
    const auto* curves = std::get_if<std::vector<QuadBezier>>(&k.figure);
    if (!curves || curves->size() != 1) return;
    const QuadBezier& c = curves->front();
    out << fmt::format("{},{:a},{:a},{:a},{:a},{:a},{:a},{:a},{:a}", family.name, c.p0.x, c.p0.y,
                       c.p1.x, c.p1.y, c.p2.x, c.p2.y, k.p.x, k.p.y);
    std::vector<TrueFoot> feet = true_feet(k);
    feet.resize(2);
    for (const TrueFoot& foot : feet) {
      const Foot& f = foot.foot;
      out << fmt::format(",{:a},{:a},{:a},{:a},{:a}", f.t, f.distance, f.normal.x, f.normal.y,
                         f.bend);
    }
    out << fmt::format(",{:a}\n", double(feet[1].barrier));
  }
}

}  // namespace mien::accuracy
