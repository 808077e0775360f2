#include "render/image/tiff/icc_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace mien {
namespace {

struct Reader {
  const std::vector<std::uint8_t>& bytes;
  std::uint32_t number(std::size_t at) const {
    return std::uint32_t(bytes.at(at)) << 24 | std::uint32_t(bytes.at(at + 1)) << 16 |
           std::uint32_t(bytes.at(at + 2)) << 8 | bytes.at(at + 3);
  }
  double fixed(std::size_t at) const { return double(std::int32_t(number(at))) / 65536; }
  std::string name(std::size_t at) const {
    return {bytes.begin() + long(at), bytes.begin() + long(at) + 4};
  }
  std::map<std::string, std::size_t> tags() const {
    std::map<std::string, std::size_t> all;
    for (std::size_t i = 0; i < number(128); ++i) {
      const std::size_t at = 132 + 12 * i;
      EXPECT_EQ(number(at + 4) % 4, 0u);
      EXPECT_LE(number(at + 4) + number(at + 8), bytes.size());
      all[name(at)] = number(at + 4);
    }
    return all;
  }
};

TEST(IccProfile, HasAHeaderAndTagsInsideItself) {
  for (ToneCurve curve : {ToneCurve::srgb, ToneCurve::linear}) {
    const auto profile = icc_profile(curve);
    const Reader read{profile};
    EXPECT_EQ(read.number(0), profile.size());
    EXPECT_EQ(read.name(36), "acsp");
    for (const char* name :
         {"desc", "cprt", "wtpt", "rXYZ", "gXYZ", "bXYZ", "rTRC", "gTRC", "bTRC"}) {
      EXPECT_EQ(read.tags().count(name), 1u) << name;
    }
  }
}

TEST(IccProfile, PrimariesAddUpToD50) {
  const auto profile = icc_profile(ToneCurve::srgb);
  const Reader read{profile};
  auto tags = read.tags();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = 8 + 4 * i;
    EXPECT_NEAR(read.fixed(tags["rXYZ"] + at) + read.fixed(tags["gXYZ"] + at) +
                    read.fixed(tags["bXYZ"] + at),
                read.fixed(tags["wtpt"] + at), 1e-4);
  }
}

TEST(IccProfile, CurvesAreThoseNamed) {
  const auto encoded = icc_profile(ToneCurve::srgb), linear = icc_profile(ToneCurve::linear);
  const Reader srgb{encoded}, light{linear};
  const std::size_t at = srgb.tags()["gTRC"] + 12;
  const double g = srgb.fixed(at), a = srgb.fixed(at + 4), b = srgb.fixed(at + 8);
  EXPECT_NEAR(std::pow(a * 0.5 + b, g), std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-4);
  EXPECT_EQ(light.fixed(light.tags()["gTRC"] + 12), 1.0);
}

}  // namespace
}  // namespace mien
