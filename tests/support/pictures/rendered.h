#pragma once
#include <mien/render.h>

#include <gtest/gtest.h>

#include <utility>

namespace mien::test {

/// render(), where it can only succeed; else the test fails and the image is empty.
inline Image rendered(const Scene& scene, const View& view, const RenderOptions& how = {},
                      RenderStats* stats = nullptr) {
  auto image = render(scene, view, how, stats);
  EXPECT_TRUE(image) << sentence(image.error());
  return image ? *std::move(image) : Image{};
}

}  // namespace mien::test
