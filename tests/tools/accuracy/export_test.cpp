// The published cases, read back as others would read them.

#include "tools/accuracy/export.h"

#include <gtest/gtest.h>

#include "tools/accuracy/reference.h"

#include <cstdlib>
#include <sstream>
#include <vector>

namespace mien::accuracy {
namespace {

TEST(Export, ReadBackIsTheCasesToTheLastBit) {
  size_t compared = 0;
  for (const Family& family : bezier_families()) {
    std::stringstream file;
    write_cases_header(file, 3);
    write_cases(file, family, 5, 3);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line.front(), '#');
    std::getline(file, line);
    EXPECT_EQ(line, "family,x0,y0,x1,y1,x2,y2,px,py,distance,distance_rest");
    for (const Case& k : cases_of(family, 5, 3)) {
      ASSERT_TRUE(std::getline(file, line)) << family.name;
      std::stringstream cells(line);
      std::string name, cell;
      std::getline(cells, name, ',');
      EXPECT_EQ(name, family.name);
      std::vector<double> n;
      while (std::getline(cells, cell, ',')) n.push_back(std::strtod(cell.c_str(), nullptr));
      ASSERT_EQ(n.size(), 10u) << line;
      const QuadBezier& c = std::get<QuadBezier>(k.figure);
      const double coordinates[8] = {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y, k.p.x, k.p.y};
      for (size_t i = 0; i < 8; ++i) EXPECT_EQ(n[i], coordinates[i]) << line;
      const Quad truth = true_distance(k), read = Quad(n[8]) + Quad(n[9]);
      EXPECT_LE(double(magnitude(read - truth)), 0x1p-105 * double(truth)) << line;
      ++compared;
    }
    EXPECT_FALSE(std::getline(file, line)) << line;
  }
  EXPECT_EQ(compared, 5 * bezier_families().size());
}

}  // namespace
}  // namespace mien::accuracy
