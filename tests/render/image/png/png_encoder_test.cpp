#include "render/image/png/png_encoder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cstring>
#include <map>

#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

struct Chunk {
  std::string name, data;
};

std::uint32_t number(const std::string& bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) n = n << 8 | std::uint8_t(bytes[at + i]);
  return n;
}

/// Every chunk, its check sum checked.
std::vector<Chunk> chunks(const std::string& file) {
  EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::vector<Chunk> found;
  for (std::size_t at = 8; at < file.size();) {
    const std::uint32_t length = number(file, at);
    found.push_back({file.substr(at + 4, 4), file.substr(at + 8, length)});
    const auto* named = reinterpret_cast<const Bytef*>(file.data() + at + 4);
    EXPECT_EQ(number(file, at + 8 + length), ::crc32(0, named, length + 4)) << found.back().name;
    at += 12 + length;
  }
  return found;
}

std::string png_of(const Image& image, WriteOptions how = {}) {
  const test::ScratchFolder folder;
  EXPECT_TRUE(test::encode_to(folder / "a.png", image, FileType::png, how));
  return test::read_text(folder / "a.png");
}

TEST(PngEncoder, SaysWhatThePixelsAre) {
  const auto found = chunks(png_of(test::sample_image(40, 30, Depth::u16, false)));
  std::map<std::string, std::string> by_name;
  for (const Chunk& chunk : found) by_name[chunk.name] = chunk.data;
  EXPECT_EQ(found.front().name, "IHDR");
  EXPECT_EQ(found.front().data, std::string("\0\0\0\x28\0\0\0\x1e\x10\x06\0\0\0", 13));
  EXPECT_EQ(by_name["sRGB"], std::string(1, '\0'));
  EXPECT_EQ(number(by_name["gAMA"], 0), 45455u);
  EXPECT_EQ(by_name["cHRM"].size(), 32u);
  EXPECT_EQ(by_name["tEXt"].substr(0, 14), std::string("Software\0mien ", 14));
  EXPECT_EQ(found.back().name, "IEND");
  EXPECT_EQ(chunks(png_of(test::sample_image(40, 30, Depth::f32, true))).front().data[9], '\x02');
}

TEST(PngEncoder, SaysHowLargeItIsOnPaper) {
  const auto size_of = [](double dpi) {
    for (const Chunk& chunk :
         chunks(png_of(test::sample_image(3, 2, Depth::u8, true), {.dpi = dpi})))
      if (chunk.name == "pHYs") return chunk.data;
    return std::string();
  };
  EXPECT_EQ(size_of(0), "");
  EXPECT_EQ(size_of(300), std::string("\0\0\x2e\x23\0\0\x2e\x23\1", 9));  // 11811 pixels a metre
  EXPECT_EQ(size_of(1e300), size_of(WriteOptions::kMostDpi));
}

TEST(PngEncoder, TheStreamIsZlibsWithItsCheckSum) {
  const Image image = test::sample_image(301, 1000, Depth::u8, true);  // several strips and pieces
  std::string stream;
  for (const Chunk& chunk : chunks(png_of(image))) {
    if (chunk.name == "IDAT") stream += chunk.data;
  }
  std::string rows((301 * 3 + 1) * 1000, '\0');
  uLongf size = rows.size();
  ASSERT_EQ(::uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                         reinterpret_cast<const Bytef*>(stream.data()), uLong(stream.size())),
            Z_OK)
      << "zlib compares the check sum";
  EXPECT_EQ(size, rows.size());
}

TEST(PngEncoder, TextIsLatin1OrUtf8) {
  const auto text_of = [](const std::string& recipe) {
    for (const Chunk& chunk :
         chunks(png_of(test::sample_image(3, 2, Depth::u8, true), {.recipe = recipe}))) {
      if (chunk.data.starts_with("Description")) return chunk;
    }
    return Chunk{};
  };
  EXPECT_EQ(text_of("{}").name, "tEXt");
  EXPECT_EQ(text_of("{}").data, std::string("Description\0{}", 14));
  EXPECT_EQ(text_of("é").name, "iTXt");
  EXPECT_EQ(text_of("é").data, std::string("Description\0\0\0\0\0é", 18));
}

TEST(PngEncoder, ThreadsChangeNoByte) {
  const Image image = test::sample_image(500, 3000, Depth::u8, true);
  const test::ScratchFolder folder;
  std::string first;
  for (int threads : {1, 2, 7}) {
    WriteOptions how;
    how.threads.count = threads;
    ASSERT_TRUE(write_image(image, folder / "a.png", how));
    const std::string file = test::read_text(folder / "a.png");
    if (first.empty()) first = file;
    EXPECT_TRUE(file == first) << threads;
  }
}

TEST(PngEncoder, MemoryChangesNoByte) {
  const Image image = test::sample_image(1500, 2100, Depth::u8, true);  // noise: chunk after chunk
  const test::ScratchFolder folder;
  std::vector<int> pieces;
  std::vector<std::string> files;
  for (const std::uint64_t memory : {std::uint64_t(8) << 20, std::uint64_t(256) << 20}) {
    const int descriptor = ::open((folder / "a.png").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    FileOutput out(descriptor, false);
    const WriteOptions how;
    const auto made = png_encoder(
        {{image.width, image.height, Depth::u8, true}, FileType::png, how, {1, memory}, out});
    ASSERT_TRUE(made);
    for (int i = 0; i < (*made)->pieces(); ++i) {
      PreparedPiece piece;
      auto* from = const_cast<std::byte*>(image.bytes.data());
      from += image.stride() * std::size_t((*made)->piece(i).y);
      (*made)->prepare(i, 0, {from, image.stride(), Depth::u8}, piece, [] { return false; });
      EXPECT_TRUE((*made)->put(i, piece));
    }
    EXPECT_TRUE((*made)->finish());
    ::close(descriptor);
    pieces.push_back((*made)->pieces());
    files.push_back(test::read_text(folder / "a.png"));
  }
  EXPECT_GT(pieces[0], pieces[1]);
  EXPECT_TRUE(files[0] == files[1]);
  EXPECT_EQ(chunks(files[0])[5].data.size(), 65536u);
}

TEST(PngEncoder, WidePicturesAreCutIntoFewRows) {
  const WriteOptions how;
  FileOutput out(-1, false);
  const auto made =
      png_encoder({{1 << 20, 64, Depth::u16, true}, FileType::png, how, {4, 256 << 20}, out});
  ASSERT_TRUE(made);
  EXPECT_EQ((*made)->slots(), 3);
  EXPECT_EQ((*made)->piece(0).height, 1);
  const auto refused =
      png_encoder({{1 << 20, 64, Depth::u16, true}, FileType::png, how, {4, 8 << 20}, out});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what.substr(0, 15), "needs at least ");
}

}  // namespace
}  // namespace mien
