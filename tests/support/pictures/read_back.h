#pragma once
// Files as another program reads them.

#include <mien/write.h>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace mien::test {

/// What a file holds, as another program reads it: levels as they are, no alpha multiplied in.
struct Read {
  OIIO::ImageSpec spec;
  std::vector<float> channels;  ///< 0 … 1
  bool good = false;
};

inline Read read(const std::filesystem::path& path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto in = OIIO::ImageInput::open(path.string(), &config);
  if (!in) {
    ADD_FAILURE() << path << ": " << OIIO::geterror();
    return {};
  }
  Read got{in->spec(), {}, true};
  got.channels.resize(std::size_t(got.spec.width) * std::size_t(got.spec.height) *
                      std::size_t(got.spec.nchannels));
  got.good =
      in->read_image(0, 0, 0, got.spec.nchannels, OIIO::TypeDesc::FLOAT, got.channels.data());
  EXPECT_TRUE(got.good) << in->geterror();
  return got;
}

inline Expected<Done> encode_to(const std::filesystem::path& path, const Image& image,
                                FileType type, WriteOptions how = {}) {
  how.type = type;
  how.threads.count = 1;
  return write_image(image, path, how);
}

/// The value of one channel of the image in 0 … 1, as its depth means it.
inline double value(const Image& image, int x, int y, int c) {
  const std::uint8_t* row = image.row(y);
  switch (image.depth) {
    case Depth::u8:
      return row[4 * x + c] / 255.0;
    case Depth::u16:
      return reinterpret_cast<const std::uint16_t*>(row)[4 * x + c] / 65535.0;
    case Depth::f32:
      return double(reinterpret_cast<const float*>(row)[4 * x + c]);
  }
  return 0;
}

}  // namespace mien::test
