// mien inside somebody else's program: linked as its users link it, through mien.h alone.

#include <gtest/gtest.h>
#include <mien/mien.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/faces/face_path.h"
#include "tests/support/pictures/rendered.h"

namespace mien {
namespace {

const std::string kFace = test::face_path("toon");

Face toon() {
  auto face = read_face(kFace);
  if (!face) ADD_FAILURE() << sentence(face.error());
  return *face;
}

Image picture(const Face& face, double time, int width, const RenderOptions& how = {}) {
  return test::rendered(scene_from_face(pose_face(face, {.time = time})),
                        {.width = width, .height = width * 9 / 16}, how);
}

TEST(Embed, EightThreadsAtOnceDrawWhatOneDraws) {
  const Face face = toon();
  std::vector<Image> alone, together(8);
  for (int i = 0; i < 8; ++i)
    alone.push_back(picture(face, 0.1 * i, 200 + 40 * i, {.threads = {.count = 1}}));
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([&, i] {
        const Face own = i % 2 ? face : toon();  // a shared face, and one each
        for (int again = 0; again < 3; ++again)
          together[std::size_t(i)] =
              picture(own, 0.1 * i, 200 + 40 * i, {.threads = {.count = i % 3}});
      });
    }
  }
  for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(together[i].bytes == alone[i].bytes) << i;
}

TEST(Embed, AllWorkRunsOnTheCallersThreads) {
  const Face face = toon();
  std::mutex mutex;
  std::set<std::thread::id> own, seen;
  const Executor mine = [&](int count, const std::function<void(int)>& job) {
    std::atomic<int> next = 0;
    std::vector<std::jthread> threads;
    for (int t = 0; t < 3; ++t) {
      threads.emplace_back([&] {
        {
          const std::lock_guard lock(mutex);
          own.insert(std::this_thread::get_id());
        }
        for (int i = next++; i < count; i = next++) job(i);
      });
    }
  };
  const Progress watch = [&](double) {
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
    return true;
  };
  const Image by_mine = picture(face, 0.2, 640, {.threads = {.executor = mine}, .progress = watch});
  EXPECT_TRUE(by_mine.bytes == picture(face, 0.2, 640).bytes);
  EXPECT_FALSE(own.empty());
  own.insert(std::this_thread::get_id());  // outlines are made where the caller calls
  EXPECT_FALSE(seen.empty());
  for (const auto& id : seen) EXPECT_TRUE(own.contains(id)) << "a thread that is not the caller's";
}

TEST(Embed, ACallersBufferKeepsWhatLiesBetweenItsRows) {
  const Scene scene = scene_from_face(toon());
  for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
    const View view{.width = 160, .height = 90, .region = PixelRect{20, 10, 100, 70}};
    const Image whole = test::rendered(scene, view, {.depth = depth});
    ASSERT_EQ(whole.width, 100);
    ASSERT_EQ(whole.height, 70);
    const std::size_t row = whole.stride(), stride = row + 48;
    std::vector<unsigned char> buffer(stride * 70 + 48, 0xCD);
    ASSERT_TRUE(
        render_into({.data = buffer.data(), .stride = stride, .depth = depth}, scene, view));
    for (std::size_t y = 0; y < 70; ++y) {
      ASSERT_EQ(std::memcmp(&buffer[y * stride], whole.row(int(y)), row), 0) << "row " << y;
      for (std::size_t gap = row; gap < stride; ++gap) ASSERT_EQ(buffer[y * stride + gap], 0xCD);
    }
    for (std::size_t end = stride * 70; end < buffer.size(); ++end) ASSERT_EQ(buffer[end], 0xCD);
  }
}

TEST(Embed, ProgressRisesToOneFromOneThreadAtATime) {
  std::atomic<int> inside = 0;
  std::vector<double> done;
  const Progress watch = [&](double share) {
    EXPECT_EQ(++inside, 1);
    done.push_back(share);
    --inside;
    return true;
  };
  picture(toon(), 0.2, 1280, {.threads = {.count = 4}, .progress = watch});
  ASSERT_FALSE(done.empty());
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_GE(done.front(), 0.0);
  EXPECT_EQ(done.back(), 1.0);
}

TEST(Embed, ACancelledPictureStopsSoon) {
  const Scene scene = scene_from_face(toon());
  const View view{.width = 8192, .height = 8192};
  constexpr unsigned char kUntouched = 0xA5;
  std::vector<unsigned char> buffer(std::size_t(8192) * 8192 * 4, kUntouched);
  bool stopped = false;
  int after = 0;
  const Progress stop_once_drawing = [&](double share) {
    after += stopped;
    stopped = share > 0;
    return !stopped;
  };
  RenderStats stats;
  EXPECT_FALSE(render_into({.data = buffer.data(), .stride = 8192 * 4}, scene, view,
                           {.threads = {.count = 2}, .progress = stop_once_drawing}, &stats));
  EXPECT_TRUE(stats.cancelled);
  EXPECT_EQ(after, 0) << "asked again after the answer was no";
  long drawn = 0;  // rows: those that were begun are ended
  for (std::size_t y = 0; y < 8192; ++y) drawn += buffer[y * 8192 * 4 + 3] != kUntouched;
  EXPECT_GT(drawn, 0);
  EXPECT_LT(drawn, 8192 / 4);
}

TEST(Embed, AFaceFromMemoryIsTheFaceFromTheFile) {
  std::ifstream file(kFace);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto from_memory = read_face_text(text);
  ASSERT_TRUE(from_memory) << sentence(from_memory.error());
  EXPECT_EQ(from_memory->vector, toon().vector);
  EXPECT_TRUE(picture(*from_memory, 0.2, 320).bytes == picture(toon(), 0.2, 320).bytes);
}

TEST(Embed, NothingIsPrintedAndNothingThrown) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_NO_THROW({
    const Face face = toon();
    EXPECT_FALSE(read_face("no/such/face.json"));
    EXPECT_FALSE(read_face(MIEN_SOURCE_DIR));
    EXPECT_FALSE(read_face_text("{"));
    EXPECT_FALSE(read_face_text(""));
    EXPECT_FALSE(read_setting(face, "no such name=1"));
    EXPECT_FALSE(read_setting(face, ""));
    settable_names(face);
    picture(face, 1.25, 64);
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Embed, APosedFaceDoesNotDependOnWhatWasDrawnBefore) {
  const Face face = toon();
  const Image first = picture(face, 0.3, 320);
  for (double time : {4.1, 17.0, 1e9}) picture(face, time, 64);
  EXPECT_TRUE(picture(face, 0.3, 320).bytes == first.bytes);
}

}  // namespace
}  // namespace mien
