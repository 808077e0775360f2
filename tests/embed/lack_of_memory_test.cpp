// Every allocation fails once: what comes of it is the result or a sentence, and nothing is lost.
//
// MIEN_ALL_ALLOCATIONS=1 for the long form: all of a small verb's, of others the first thousand and every 97th.

#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/morph_file.h>
#include <mien/motion_file.h>
#include <mien/npy_basis.h>
#include <mien/obj.h>
#include <mien/pose.h>
#include <mien/render.h>
#include <mien/scene_from_face.h>
#include <mien/svg.h>
#include <mien/write.h>

#include <gtest/gtest.h>
#include <mien_c.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <optional>
#include <string>

#include "tests/support/faces/face_path.h"
#include "tests/support/process/failing_malloc.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::ScratchFolder;

/// How a piece of work ended: with this, or with a sentence.
struct Ended {
  bool done = false;
  std::string what;
};
using Work = std::function<Ended()>;

template <class T>
Ended ended(const Expected<T>& result, const std::string& what = "done") {
  test::stop_failing();
  return result ? Ended{true, what} : Ended{false, sentence(result.error())};
}

bool long_form() {
  return std::getenv("MIEN_ALL_ALLOCATIONS") != nullptr;
}

/// The next allocation to fail.
long after(long index, long all, bool small) {
  if (long_form()) return index + (small || index < 1000 ? 1 : 97);
  constexpr long kSamples = 60;
  return index + (index < 40 ? 1 : std::max(1l, all / kSamples));
}

/// How it ended where an allocation failed.
struct Failed {
  Ended end;
  bool thrown = false;
  long lost = 0;  // blocks
};

Failed failed_at(const Work& work, long index) {
  Failed failed;
  const long before = test::blocks_held();
  {
    Ended end;
    test::fail_allocation(index);
    try {
      end = work();
    } catch (const std::bad_alloc&) {
      failed.thrown = true;
      end.what = "memory ran out";
    }
    test::stop_failing();
    failed.end = end;
  }
  const long kept = long(failed.end.what.size() >= sizeof(std::string) / 2);  // its text
  failed.lost = test::blocks_held() - before - kept;
  return failed;
}

class LackOfMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::kFailsAllocations) GTEST_SKIP() << "a sanitizer has an allocator of its own";
  }

  /// `total`: a verb that has no error to return; std::bad_alloc is what it ends with.
  void fails_well(const char* name, const Work& work, bool small = false, bool total = false) {
    const Ended whole = work();
    ASSERT_TRUE(whole.done) << name << ": " << whole.what;
    work();  // what is made once is there now
    test::fail_allocation(0);
    work();
    test::stop_failing();
    const long all = test::allocations_tried();
    long tried = 0, refused = 0;
    for (long index = 1; index <= all && !HasFailure(); index = after(index, all, small), ++tried) {
      const Failed once = failed_at(work, index);
      // What is made once, by the first to get there, is not lost. A second time it is.
      const bool lost = once.lost != 0 && failed_at(work, index).lost != 0;
      const Ended& end = once.end;
      EXPECT_FALSE(lost) << name << ": allocation " << index;
      EXPECT_TRUE(total || !once.thrown)
          << name << ": std::bad_alloc comes out at allocation " << index;
      EXPECT_TRUE(!end.done || end.what == whole.what) << name << ": allocation " << index;
      EXPECT_TRUE(end.done || (!end.what.empty() && end.what.find('\n') == std::string::npos))
          << name << ": allocation " << index << ": " << end.what;
      refused += !end.done;
    }
    EXPECT_GT(refused, 0) << name;
    std::printf("%s: %ld of %ld allocations, %ld refused\n", name, tried, all, refused);
    EXPECT_TRUE(work().what == whole.what) << name << ": the next run";
  }
};

std::string face() {
  return test::face_path("toon");
}

Scene drawn() {
  return scene_from_face(pose_face(*read_face(face()), {}));
}

std::string pixels_of(const Image& image) {
  return {reinterpret_cast<const char*>(image.bytes.data()), image.bytes.size()};
}

const View kSmall{.width = 24, .height = 24};

TEST_F(LackOfMemory, ReadingIsASentence) {
  const std::filesystem::path file = face(), take = MIEN_SOURCE_DIR "/examples/take/open_face.csv",
                              track = MIEN_SOURCE_DIR "/examples/talk/hello.TextGrid",
                              basis = MIEN_SOURCE_DIR "/fuzz/lib/file/npy/npy_corpus/two.basis";
  fails_well("read_face", [&] { return ended(read_face(file)); });
  fails_well("face_from_code", [] { return ended(face_from_code("A66CB-AA5S0-14")); });
  fails_well("read_motion", [&] { return ended(read_motion(take)); });
  fails_well("read_motion of speech", [&] { return ended(read_motion(track)); });
  constexpr std::string_view kMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  fails_well(
      "read_obj", [&] { return ended(read_obj_text(kMesh)); }, true);
  fails_well("read_basis", [&] { return ended(read_basis(basis)); });
}

TEST_F(LackOfMemory, PosingIsNothingElse) {
  const Face rest = *read_face(face());
  fails_well(
      "pose_face",
      [&] {
        const Face posed = pose_face(rest, {.time = 0.5});
        test::stop_failing();
        return Ended{true,
                     std::string(reinterpret_cast<const char*>(posed.vector.data()), 8) + "x"};
      },
      true, true);
  fails_well(
      "scene_from_face",
      [&] {
        const Scene scene = scene_from_face(rest);
        test::stop_failing();
        return Ended{true, std::to_string(scene.layers().size())};
      },
      true, true);
}

TEST_F(LackOfMemory, DrawingIsASentence) {
  const Scene scene = drawn();
  for (const int threads : {1, 2})
    fails_well(threads == 1 ? "render" : "render, two threads", [&] {
      const auto image = render(scene, kSmall, {.threads = {.count = threads}});
      test::stop_failing();
      return ended(image, image ? pixels_of(*image) + "x" : "");
    });
  fails_well("svg_text", [&] {
    const auto svg = svg_text(scene, {});
    test::stop_failing();
    return ended(svg, svg ? std::to_string(svg->text.size()) : "");
  });
}

TEST_F(LackOfMemory, AFileIsTheOldOneOrTheNew) {
  const Scene scene = drawn();
  const Image image = *render(scene, kSmall);
  const PictureOptions alone{.write = {.threads = {.count = 1}}};
  // libtiff 4.5 crashes as it closes a file for which its own memory did not suffice.
  for (const std::string name : {"a.png"}) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder / name;
    const auto written = [&](const Expected<Done>& done) {
      test::stop_failing();
      const std::string now = test::read_text(path);
      EXPECT_EQ(folder.names().size(), 1u) << path;
      EXPECT_TRUE(done || now == "old") << sentence(done.error());
      test::write_text(path, "old");
      return ended(done, now);
    };
    test::write_text(path, "old");
    fails_well(("write_image " + name).c_str(), [&] { return written(write_image(image, path)); });
    fails_well(("write_picture " + name).c_str(), [&] {
      const auto done = write_picture(scene, kSmall, path, alone);
      return written(done ? Expected<Done>(Done{}) : done.error());
    });
    fails_well("write_svg", [&] {
      const auto done = write_svg(scene, path);
      return written(done ? Expected<Done>(Done{}) : done.error());
    });
  }
}

constexpr char kFace[] = MIEN_SOURCE_DIR "/faces/compat/toon.face.json";

/// From a face file to pixels, through C.
Ended drawn_in_c() {
  mien_error* error = nullptr;
  mien_face* read = nullptr;
  mien_pose* pose = nullptr;
  mien_scene* scene = nullptr;
  mien_renderer* renderer = nullptr;
  mien_view view;
  mien_view_init(&view, sizeof view);
  view.width = view.height = 16;
  mien_render_options options;
  mien_render_options_init(&options, sizeof options);
  options.threads = 1;
  char bytes[16 * 16 * 4];
  mien_pixels pixels;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.data = bytes, pixels.bytes = sizeof bytes, pixels.stride = 64;
  mien_status status = mien_face_read(kFace, MIEN_NUL_ENDED, &read, &error);
  if (!status) status = mien_pose_new(read, &pose, &error);
  if (!status) status = mien_pose_set(pose, "blink=0.5", MIEN_NUL_ENDED, &error);
  if (!status) status = mien_scene_new(pose, &scene, &error);
  if (!status) status = mien_renderer_new(&renderer, &error);
  if (!status) status = mien_render(renderer, scene, &view, &pixels, &options, &error);
  test::stop_failing();
  Ended end{status == MIEN_OK, {}};
  EXPECT_NE(status, MIEN_MISUSE);
  EXPECT_NE(status, MIEN_UNEXPECTED) << mien_error_what(error);
  end.what = end.done ? std::string(bytes, 64) + "x" : mien_error_what(error);
  if (end.what.empty()) end.what = "no memory for a sentence";
  mien_error_free(error);
  mien_renderer_free(renderer), mien_scene_free(scene), mien_pose_free(pose), mien_face_free(read);
  return end;
}

TEST_F(LackOfMemory, IsAStatusInC) {
  fails_well("C", drawn_in_c);
}

}  // namespace
}  // namespace mien
