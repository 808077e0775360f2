// Films that are animated pictures, as other programs read them: they are the stills, at their moments.

#include "tools/mien/film/film.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>

#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/read_film.h"
#include "tests/support/process/run_command.h"

namespace mien::command {
namespace {

using test::face_path;
using test::read_film;
using test::ReadFilm;
using test::run_mien;
using test::ScratchFolder;

constexpr const char* kNames[] = {"a.apng", "a.webp", "a.gif"};

using DrawPixel = std::function<void(long frame, int x, int y, std::uint8_t* rgba)>;

/// A film of drawn frames.
FilmPlan plan_of(const char* name, long frames, double fps, bool transparent, DrawPixel draw) {
  return {.type = *film_type(name),
          .width = 40,
          .height = 30,
          .fps = fps,
          .transparent = transparent,
          .frames = frames,
          .draw = [draw = std::move(draw)](long frame) -> Expected<Image> {
            Image image{40, 30, Depth::u8, false, std::vector<std::byte>(40 * 30 * 4)};
            for (int y = 0; y < 30; ++y)
              for (int x = 0; x < 40; ++x)
                draw(frame, x, y,
                     reinterpret_cast<std::uint8_t*>(&image.bytes[std::size_t(4 * (40 * y + x))]));
            return image;
          }};
}

Expected<Done> write_film(const std::string& path, const FilmPlan& plan) {
  auto film = begin_film(path, plan);
  if (!film) return film.error();
  for (long frame = 0; frame < plan.frames; ++frame)
    if (auto done = (*film)->add(*plan.draw(frame)); !done) return done;
  return (*film)->finish();
}

/// A square of 20 colours that goes to the right; on it, and around it, nothing is there if so asked.
DrawPixel moving_square(bool transparent) {
  return [=](long frame, int x, int y, std::uint8_t* rgba) {
    const int inside = x - int(frame) / 2;
    const bool there = inside >= 0 && inside < 12 && y >= 5 && y < 25;
    rgba[0] = there ? std::uint8_t(250 - 10 * y) : 0;
    rgba[1] = there ? 90 : 0, rgba[2] = there ? 30 : 0;
    rgba[3] = there || !transparent ? 255 : 0;
  };
}

// Every format, with few colours: exact, also where pixels turn transparent.
TEST(PictureFilms, ShowTheFramesAtTheirMoments) {
  for (const bool transparent : {false, true})
    for (const char* name : kNames) {
      const ScratchFolder folder;
      const std::string path = (folder / name).string();
      const FilmPlan plan = plan_of(name, 50, 30, transparent, moving_square(transparent));
      ASSERT_TRUE(write_film(path, plan));
      const ReadFilm film = read_film(path);
      ASSERT_EQ(film.frames.size(), 25u) << name << ": two frames each are equal";
      EXPECT_TRUE(film.endless) << name;
      EXPECT_NEAR(film.seconds(), 50 / 30.0, 0.005) << name;
      for (long frame = 0; frame < 50; ++frame) {
        const Image drawn = *plan.draw(frame);
        EXPECT_EQ(0, std::memcmp(film.at((double(frame) + 0.5) / 30).pixels.data(), drawn.row(0),
                                 drawn.bytes.size()))
            << name << ' ' << frame << transparent;
      }
    }
}

TEST(PictureFilms, RoundingsOfTimesDoNotAddUp) {
  const auto blinking = [](long frame, int x, int, std::uint8_t* rgba) {
    rgba[0] = rgba[1] = rgba[2] = std::uint8_t(x == frame % 40 ? 255 : 0), rgba[3] = 255;
  };
  for (const double fps : {30.0, 24000.0 / 1001, 29.97, 12.5, 7.0})
    for (const char* name : kNames) {
      const ScratchFolder folder;
      const std::string path = (folder / name).string();
      ASSERT_TRUE(write_film(path, plan_of(name, 150, fps, false, blinking)));
      const ReadFilm film = read_film(path);
      ASSERT_EQ(film.frames.size(), 150u) << name << fps;
      const double tick = film_type(name) == FilmType::gif ? 0.01 : 0.001;
      double begin = 0;
      for (std::size_t frame = 0; frame < 150; ++frame) {
        EXPECT_NEAR(begin, double(frame) / fps, tick / 2 + 1e-9) << name << fps << ' ' << frame;
        begin += film.frames[frame].seconds;
      }
    }
}

// Players show a GIF's frames of one hundredth of a second ten times as long.
TEST(PictureFilms, AFastGifLeavesFramesOut) {
  const auto flicker = [](long frame, int x, int y, std::uint8_t* rgba) {
    const long later = std::min(frame, 300L);  // then it rests
    rgba[0] = std::uint8_t(later & 255), rgba[1] = std::uint8_t(later >> 8 | x),
    rgba[2] = std::uint8_t(y);
    rgba[3] = 255;
  };
  for (const double fps : {60.0, 75.0, 144.0, 1000.0}) {
    const ScratchFolder folder;
    const std::string path = (folder / "a.gif").string();
    ASSERT_TRUE(write_film(path, plan_of("a.gif", 400, fps, false, flicker)));
    const ReadFilm film = read_film(path);
    for (const auto& frame : film.frames) EXPECT_GE(frame.seconds, 0.02);
    EXPECT_NEAR(film.seconds(), 400 / fps, 0.011) << fps;
    EXPECT_NEAR(double(film.frames.size()), 300 / fps * 50, 2) << fps;
  }
}

TEST(PictureFilms, WhatRestsIsOneFrame) {
  const auto grey = [](long, int, int, std::uint8_t* rgba) { std::fill_n(rgba, 4, 255); };
  for (const char* name : kNames) {
    const ScratchFolder folder;
    const std::string path = (folder / name).string();
    ASSERT_TRUE(write_film(path, plan_of(name, 90, 30, false, grey)));
    EXPECT_EQ(read_film(path).frames.size(), 1u) << name;
    // And longer than a frame of the format may last.
    ASSERT_TRUE(write_film(path, plan_of(name, 20, 0.01, false, grey)));
    const ReadFilm film = read_film(path);
    if (film.frames.size() > 1) {
      EXPECT_NEAR(film.seconds(), 2000, 0.01) << name;
    }
    EXPECT_LE(film.frames.size(), 31u) << name;
  }
}

TEST(PictureFilms, AFullDiskIsAnErrorAndLeavesNothing) {
  const auto noise = [](long frame, int x, int y, std::uint8_t* rgba) {
    const unsigned dice = unsigned(frame * 7919 + x * 104729 + y * 1299709) * 2654435761u;
    rgba[0] = std::uint8_t(dice >> 24), rgba[1] = std::uint8_t(dice >> 16),
    rgba[2] = std::uint8_t(dice >> 8);
    rgba[3] = 255;
  };
  for (const char* name : kNames) {
    const ScratchFolder folder;
    const std::string path = (folder / name).string();
    const FilmPlan plan = plan_of(name, 6, 30, false, noise);
    ASSERT_TRUE(write_film(path, plan));
    const auto size = std::filesystem::file_size(path);
    test::write_text(path, "old");
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGXFSZ, SIG_IGN);
      int wrong = 0;
      for (std::uintmax_t limit = 0; limit < size && !wrong; limit += 1 + size / 13) {
        const rlimit bytes{limit, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &bytes);
        const auto done = write_film(path, plan);
        wrong = done || done.error().what != "cannot be written: File too large" ||
                done.error().where != path;
      }
      ::_exit(wrong);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << name;
    EXPECT_EQ(test::read_text(path), "old") << name;
    EXPECT_EQ(folder.names().size(), 1u) << "no temporaries";
  }
}

TEST(PictureFilms, SayWhichSidesTheyHave) {
  const ScratchFolder folder;
  FilmPlan wide{.type = FilmType::webp, .width = 20000, .height = 1, .frames = 1};
  EXPECT_EQ(begin_film((folder / "a.webp").string(), wide).error().what,
            "a WebP has 16383 pixels a side at most");
  wide.type = FilmType::gif, wide.width = 70000;
  EXPECT_EQ(begin_film((folder / "a.gif").string(), wide).error().what,
            "a GIF has 65535 pixels a side at most");
  EXPECT_TRUE(folder.names().empty());
}

std::vector<std::uint8_t> levels_of(const std::filesystem::path& png) {
  const test::Read still = test::read(png);
  std::vector<std::uint8_t> levels;
  for (std::size_t i = 0; i < still.channels.size(); ++i) {
    levels.push_back(std::uint8_t(std::lround(255 * still.channels[i])));
    if (still.spec.nchannels == 3 && i % 3 == 2) levels.push_back(255);
  }
  return levels;
}

// A face of many colours, by the command and without ffmpeg: APNG and WebP are the stills; GIF is near, and rests where
// they rest.
TEST(PictureFilms, OfAFaceAreItsStills) {
  const ScratchFolder folder;
  const auto animate = [&](const std::string& output) {
    return run_mien({"animate", face_path("toon"), "--frames", "20-39", "--size", "160", "-o",
                     (folder / output).string()},
                    {}, {"PATH=/nowhere"});
  };
  ASSERT_EQ(animate("%d.png").code, 0);
  for (const char* name : {"a.apng", "a.webp", "a.gif", "a.png"}) {
    const auto ran = animate(name);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const ReadFilm film = read_film(folder / name);
    std::vector<std::uint8_t> still_before, seen_before;
    for (int frame = 0; frame < 20; ++frame) {
      const auto still = levels_of(folder / fmt::format("{}.png", 20 + frame));
      const auto& seen = film.at((frame + 0.5) / 30).pixels;
      ASSERT_EQ(still.size(), seen.size());
      double sum = 0;
      for (std::size_t i = 0; i < still.size(); ++i) sum += std::abs(int(still[i]) - int(seen[i]));
      EXPECT_LE(sum / double(still.size()), name == std::string("a.gif") ? 0.5 : 0.0) << name;
      for (std::size_t i = 0; i + 4 <= still.size() && frame > 0; i += 4)
        ASSERT_FALSE(std::equal(&still[i], &still[i] + 4, &still_before[i]) &&
                     !std::equal(&seen[i], &seen[i] + 4, &seen_before[i]))
            << name << " flickers at pixel " << i / 4;
      still_before = still, seen_before = seen;
    }
  }
}

TEST(PictureFilms, HoldEightBits) {
  const ScratchFolder folder;
  const auto ran = run_mien({"animate", face_path("seed0"), "--frames", "0", "--depth", "16",
                             "--size", "32", "-o", (folder / "a.apng").string()});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("--depth 16: films hold 8 bits"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace mien::command
