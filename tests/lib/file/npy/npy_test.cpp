// Item P1: NumPy's files in and out. Against NumPy itself: tests/tools/pca_numpy_test.py.

#include <gtest/gtest.h>

#include <mien/npy.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::ScratchFolder;

std::string header_of(const std::string& dictionary, int version = 1) {
  std::string text = dictionary + "\n", out = "\x93NUMPY";
  out += char(version);
  out += '\0';
  for (int i = 0; i < (version == 1 ? 2 : 4); ++i) out += char(text.size() >> (8 * i) & 0xff);
  return out + text;
}

std::string dictionary(const char* type, const char* order, const char* shape) {
  return std::string("{'descr': '") + type + "', 'fortran_order': " + order +
         ", 'shape': " + shape + ", }";
}

template <class Real>
std::string bytes_of_numbers(const std::vector<Real>& numbers, bool swap = false) {
  std::string bytes;
  for (const Real number : numbers) {
    char one[sizeof(Real)];
    std::memcpy(one, &number, sizeof one);
    if (swap) std::reverse(one, one + sizeof one);
    bytes.append(one, sizeof one);
  }
  return bytes;
}

std::vector<double> all_of(const FrameFile& file) {
  const MatrixSource source = file.source();
  std::vector<double> numbers(source.rows * source.columns);
  const auto read = source.read({0, source.rows, 0, source.columns}, numbers.data());
  EXPECT_TRUE(read) << (read ? "" : sentence(read.error()));
  return numbers;
}

TEST(Npy, EveryTypeOrderAndVersion) {
  const ScratchFolder folder;
  const std::vector<float> c_order{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const std::vector<float> fortran{1, 7, 3, 9, 5, 11, 2, 8, 4, 10, 6, 12};  // of [2, 3, 2]
  const std::vector<double> wanted(c_order.begin(), c_order.end());
  for (const int version : {1, 2, 3})
    for (const bool is_fortran : {false, true})
      for (const bool big : {false, true})
        for (const bool wide : {false, true}) {
          const auto& numbers = is_fortran ? fortran : c_order;
          const std::string type = std::string(big ? ">" : "<") + (wide ? "f8" : "f4");
          const std::string bytes =
              wide ? bytes_of_numbers(std::vector<double>(numbers.begin(), numbers.end()), big)
                   : bytes_of_numbers(numbers, big);
          test::write_text(
              folder / "a.npy",
              header_of(dictionary(type.c_str(), is_fortran ? "True" : "False", "(2, 3, 2)"),
                        version) +
                  bytes);
          const auto file = FrameFile::open(folder / "a.npy");
          ASSERT_TRUE(file) << sentence(file.error());
          EXPECT_EQ(file->frames(), 2u);
          EXPECT_EQ(file->vertices(), 3u);
          EXPECT_EQ(file->dimensions(), 2u);
          EXPECT_EQ(all_of(*file), wanted);
          double part[4];  // rows 0, 1; columns 3, 4
          ASSERT_TRUE(file->source().read({0, 2, 3, 2}, part));
          EXPECT_EQ(std::vector<double>(part, part + 4), (std::vector<double>{4, 5, 10, 11}));
        }
}

TEST(Npy, HalvesAndPython2) {
  const ScratchFolder folder;
  // 1, -2, the largest, the least normal, the least subnormal and −0.
  const std::vector<std::uint16_t> halves{0x3c00, 0xc000, 0x7bff, 0x0400, 0x0001, 0x8000};
  const std::vector<double> wanted{1, -2, 65504, 0x1p-14, 0x1p-24, -0.0};
  for (const bool big : {false, true}) {
    test::write_text(folder / "a.npy",
                     header_of(dictionary(big ? ">f2" : "<f2", "False", "(2L, 3L)")) +
                         bytes_of_numbers(halves, big));
    const auto file = FrameFile::open(folder / "a.npy");
    ASSERT_TRUE(file) << sentence(file.error());
    EXPECT_EQ(all_of(*file), wanted);
  }
  test::write_text(folder / "a.npy", header_of(dictionary("<f2", "False", "(1, 1)")) +
                                         bytes_of_numbers(std::vector<std::uint16_t>{0x7c00}));
  double number = 0;
  EXPECT_FALSE(FrameFile::open(folder / "a.npy")->source().read({0, 1, 0, 1}, &number));
}

template <class Number>
void expect_integers(const char* type, std::vector<Number> numbers) {
  const ScratchFolder folder;
  for (const bool big : {false, true}) {
    const std::string name = (sizeof(Number) == 1 ? "|" : big ? ">" : "<") + std::string(type);
    test::write_text(folder / "a.npy", header_of(dictionary(name.c_str(), "False", "(1, 4)")) +
                                           bytes_of_numbers(numbers, big));
    const auto file = FrameFile::open(folder / "a.npy");
    ASSERT_TRUE(file) << sentence(file.error());
    EXPECT_EQ(all_of(*file), std::vector<double>(numbers.begin(), numbers.end())) << name;
  }
}

TEST(Npy, IntegersOfAllWidths) {
  expect_integers<std::int8_t>("i1", {0, 1, -128, 127});
  expect_integers<std::uint8_t>("u1", {0, 1, 128, 255});
  expect_integers<std::int16_t>("i2", {0, 258, -32768, 32767});
  expect_integers<std::uint16_t>("u2", {0, 258, 32768, 65535});
  expect_integers<std::int32_t>("i4", {0, 0x1020304, INT32_MIN, INT32_MAX});
  expect_integers<std::uint32_t>("u4", {0, 0x1020304, 0x80000000, UINT32_MAX});
  expect_integers<std::int64_t>("i8", {0, 0x102030405060708, INT64_MIN, INT64_MAX});
  expect_integers<std::uint64_t>("u8", {0, 0x102030405060708, 1ull << 63, UINT64_MAX});
  expect_integers<char>("b1", {0, 1, 1, 0});
}

struct BadHeader {
  std::string bytes, what;
};

TEST(Npy, BadFilesAreOneSentence) {
  const ScratchFolder folder;
  const std::string ones(4 * 6, '\0');
  const std::string nan = bytes_of_numbers(std::vector<float>{1, 2, NAN, 4, 5, 6});
  const BadHeader bads[] = {
      {"", "is not a .npy file"},
      {"\x93NUM", "is not a .npy file"},
      {"hello, hello, hello", "is not a .npy file"},
      {header_of(dictionary("<f4", "False", "(2, 3)"), 9) + ones,
       "has .npy format version 9.0; known are 1 to 3"},
      {"PK\3\4hello, hello",
       "is not a .npy file; it looks like an .npz, an archive of them: "
       "np.save('a.npy', np.load(FILE)[NAME]) makes a .npy of one"},
      {header_of(dictionary("<c8", "False", "(2, 3)")) + ones,
       "expected reals or integers ('<f2' to '<f8', '<i1' to '<u8'), got the type \"<c8\""},
      {header_of(dictionary("<f16", "False", "(2, 3)")) + ones,
       "expected reals or integers ('<f2' to '<f8', '<i1' to '<u8'), got the type \"<f16\"; "
       ".astype('f8') makes it one of them"},
      {header_of(dictionary("", "False", "(2, 3)")) + ones,
       "expected reals or integers ('<f2' to '<f8', '<i1' to '<u8'), got the type \"\""},
      {header_of(dictionary("xi4", "False", "(2, 3)")) + ones,
       "expected reals or integers ('<f2' to '<f8', '<i1' to '<u8'), got the type \"xi4\""},
      {header_of(dictionary("<i2", "False", "(2, 7)")) + ones,
       "is cut off: its shape (2, 7) takes 28 bytes, and 24 are there"},
      {header_of(dictionary("<f4", "False", "(2L, 3LL)")) + ones, "has a header that is none"},
      {header_of(dictionary("<f4", "False", "(6,)")) + ones,
       "expected the shape [frames, vertices, dimensions] or [frames, numbers] with nothing 0, got "
       "[6]"},
      {header_of(dictionary("<f4", "False", "(2, 0, 3)")),
       "expected the shape [frames, vertices, dimensions] or [frames, numbers] with nothing 0, got "
       "[2, 0, 3]"},
      {header_of(dictionary("<f4", "False", "(2, 4)")) + ones,
       "is cut off: its shape (2, 4) takes 32 bytes, and 24 are there"},
      {header_of(dictionary("<f4", "False", "(2, 2)")) + ones,
       "has 8 bytes more than its shape takes"},
      {header_of(dictionary("<f4", "False", "(4611686018427387904, 4, 3)")) + ones,
       "has an impossible shape \"(4611686018427387904, 4, 3)\""},
      {header_of("{'descr': '<f4'}") + ones,
       "has a header that is none: \"{'descr': '<f4'}\\x0A\""},
      {header_of(dictionary("<f4", "False", "(2, 3")) + ones, "has a header that is none"},
  };
  for (const BadHeader& bad : bads) {
    test::write_text(folder / "a.npy", bad.bytes);
    const auto file = FrameFile::open(folder / "a.npy");
    ASSERT_FALSE(file) << bad.what;
    EXPECT_EQ(file.error().what.substr(0, bad.what.size()), bad.what);
    EXPECT_EQ(file.error().where, (folder / "a.npy").string());
  }
  EXPECT_FALSE(FrameFile::open(folder.path()));
  EXPECT_EQ(FrameFile::open(folder / "none.npy").error().what,
            "cannot be read: No such file or directory");
  test::write_text(folder / "a.npy", header_of(dictionary("<f4", "False", "(2, 3)")) + nan);
  const auto file = FrameFile::open(folder / "a.npy");
  ASSERT_TRUE(file);
  double number[6];
  const auto read = file->source().read({0, 2, 0, 3}, number);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().what, "frame 0, vertex 2: nan is not a finite number");
}

TEST(Npy, OnlyRealsAreWritten) {
  const auto sink = [](const void*, std::size_t) -> Expected<Done> { return Done{}; };
  const std::size_t shape[] = {1, 1};
  const std::vector<double> one{1};
  const auto done = write_npy(sink, NpyType::int16, shape, matrix_in_memory(one, 1, 1));
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "arrays are written as float32 or float64");
  EXPECT_NE(npy_header(NpyType::uint8, shape).find("'|u1'"), std::string::npos);
}

TEST(Npy, WhatIsWrittenReadsBack) {
  const ScratchFolder folder;
  const std::vector<double> numbers{0.5, -1, 2, 1e-3, 5, 1e30};
  for (const NpyType type : {NpyType::float32, NpyType::float64}) {
    std::string bytes;
    const std::size_t shape[] = {2, 1, 3};
    ASSERT_TRUE(write_npy(
        [&](const void* from, std::size_t size) -> Expected<Done> {
          bytes.append(static_cast<const char*>(from), size);
          return Done{};
        },
        type, shape, matrix_in_memory(numbers, 2, 3)));
    EXPECT_EQ((bytes.size() - 6 * bytes_of(type)) % 64, 0u);
    test::write_text(folder / "a.npy", bytes);
    const auto file = FrameFile::open(folder / "a.npy");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->header().shape, (std::vector<std::size_t>{2, 1, 3}));
    const auto back = all_of(*file);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(back[i], type == NpyType::float32 ? double(float(numbers[i])) : numbers[i]);
  }
}

}  // namespace
}  // namespace mien
