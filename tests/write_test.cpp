// write_image as a whole: where files appear, what happens when they cannot.

#include <mien/write.h>

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <functional>
#include <random>
#include <thread>

#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace fs = std::filesystem;

namespace {

using test::read_text;
using test::sample_image;
using test::ScratchFolder;
using test::write_text;

// Children forked here write pictures too, and a child has none of its parent's threads:
// OpenImageIO is to start none.
const bool single_threaded = OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);

constexpr const char* kFileNames[] = {"a.png", "a.tif", "a.exr", "a.jpg"};

/// Runs `work` in a process of its own and gives what it returns.
int in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(WriteImage, WritesEveryKindAndNothingElse) {
  const ScratchFolder folder;
  for (const char* name : kFileNames) {
    const auto done = write_image(sample_image(33, 22, Depth::u8, true), folder / name);
    ASSERT_TRUE(done) << sentence(done.error());
    EXPECT_TRUE(OIIO::ImageInput::open((folder / name).string())) << name;
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "a.jpg", "a.png", "a.tif"}));
}

TEST(WriteImage, TheTypeMayBeGiven) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_image(sample_image(3, 2, Depth::u8, true), folder / "picture",
                          {.type = FileType::png}));
  EXPECT_EQ(read_text(folder / "picture").substr(1, 3), "PNG");
}

TEST(WriteImage, LinksStayLinks) {
  const ScratchFolder folder;
  fs::create_directory(folder / "deep");
  fs::create_symlink("deep/real.png", folder / "link.png");
  ASSERT_TRUE(write_image(sample_image(3, 2, Depth::u8, true), folder / "link.png"));
  EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
  EXPECT_TRUE(fs::is_regular_file(folder / "deep/real.png"));
}

TEST(WriteImage, ErrorsAreSentencesAndKeepTheOldFile) {
  const ScratchFolder folder;
  write_text(folder / "a.jpg", "old");
  EXPECT_EQ(sentence(write_image(sample_image(3, 2, Depth::u8, false), folder / "a.jpg").error()),
            (folder / "a.jpg").string() +
                ": JPEG cannot hold transparency; give the picture an opaque background or another "
                "format");
  EXPECT_EQ(sentence(write_image(sample_image(3, 2, Depth::u8, true), folder / "b.gif").error()),
            (folder / "b.gif").string() +
                ": unknown extension .gif; known are .png .tif .tiff .exr .jpg .jpeg, and .svg "
                "to `mien render` and write_svg");
  EXPECT_EQ(
      sentence(
          write_image(sample_image(3, 2, Depth::u8, true), "-", {.type = FileType::exr}).error()),
      "standard output: takes PNG only, not EXR");
  EXPECT_EQ(read_text(folder / "a.jpg"), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.jpg"});
}

TEST(WriteImage, ACancelledOneKeepsTheOldFile) {
  const ScratchFolder folder;
  for (const char* name : kFileNames) {
    write_text(folder / name, "old");
    const WriteOptions how{.progress = [](double done) { return done < 0.4; }};
    EXPECT_EQ(
        sentence(write_image(sample_image(10, 600, Depth::u8, true), folder / name, how).error()),
        (folder / name).string() + ": cancelled");
    EXPECT_TRUE(read_text(folder / name) == "old");
  }
  EXPECT_EQ(folder.names().size(), std::size(kFileNames));
}

/// A limit on a file's size fails like a full disk, wherever it strikes; so every length is tried
/// up to the whole.
TEST(WriteImage, AFileCutAnywhereIsAnErrorAndKeepsTheOldFile) {
  const Image image = sample_image(70, 50, Depth::u8, true);
  for (const char* name : kFileNames) {
    const ScratchFolder folder;
    ASSERT_TRUE(write_image(image, folder / name));
    const auto size = fs::file_size(folder / name);
    write_text(folder / name, "old");
    const int result = in_child([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      for (std::uintmax_t limit = 0; limit < size; limit += 1 + size / 97) {
        const rlimit bytes{limit, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &bytes);
        const auto done = write_image(image, folder / name);
        if (done || done.error().what != "cannot be written: File too large") return 1;
      }
      const rlimit last{rlim_t(size - 1), RLIM_INFINITY};
      ::setrlimit(RLIMIT_FSIZE, &last);
      return write_image(image, folder / name) ? 2 : 0;
    });
    EXPECT_EQ(result, 0) << name;
    EXPECT_TRUE(read_text(folder / name) == "old") << name;
    EXPECT_EQ(folder.names(), std::vector<std::string>{name});
  }
}

TEST(WriteImage, AFullDiskIsAnErrorAndKeepsTheOldFile) {
  const ScratchFolder folder;
  if (::mount("none", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "may not mount a small disk";
  Image noise = sample_image(300, 200, Depth::u16, true);  // not to be made smaller
  std::mt19937 dice(1);
  for (auto& byte : noise.bytes) byte = std::byte(dice());
  for (const char* name : kFileNames) {
    write_text(folder / name, "old");
    const auto done = write_image(noise, folder / name);
    EXPECT_FALSE(done);
    if (!done) {
      EXPECT_EQ(sentence(done.error()),
                (folder / name).string() + ": cannot be written: No space left on device");
    }
    EXPECT_TRUE(read_text(folder / name) == "old");
  }
  EXPECT_EQ(folder.names().size(), std::size(kFileNames));
  EXPECT_EQ(::umount(folder.path().c_str()), 0);
}

TEST(WriteImage, AKilledOneLeavesTheOldFileAndTheNextOneCleansUp) {
  const ScratchFolder folder;
  const Image image = sample_image(400, 3000, Depth::u8, true);
  write_text(folder / "a.png", "old");
  const int status = in_child([&] {
    const WriteOptions how{
        .progress = [](double done) { return done < 0.5 || ::raise(SIGKILL) == 0; }};
    return write_image(image, folder / "a.png", how) ? 0 : 1;
  });
  EXPECT_EQ(status, -SIGKILL);
  EXPECT_EQ(read_text(folder / "a.png"), "old");
  EXPECT_EQ(folder.names().size(), 2u) << "the killed run's temporary";
  ASSERT_TRUE(write_image(sample_image(3, 2, Depth::u8, true), folder / "b.png"));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "b.png"}));
}

TEST(WriteImage, PipesAndDevicesAreWrittenStraightInto) {
  const ScratchFolder folder;
  EXPECT_TRUE(
      write_image(sample_image(30, 20, Depth::u8, true), "/dev/null", {.type = FileType::tiff}));
  EXPECT_EQ(sentence(write_image(sample_image(30, 20, Depth::u8, true), "/dev/full",
                                 {.type = FileType::png})
                         .error()),
            "/dev/full: cannot be written: No space left on device");
  ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read_text(folder / "pipe.png"); });
  const auto done = write_image(sample_image(30, 20, Depth::u8, true), folder / "pipe.png");
  reader.join();
  ASSERT_TRUE(done) << sentence(done.error());
  ASSERT_TRUE(write_image(sample_image(30, 20, Depth::u8, true), folder / "file.png"));
  EXPECT_TRUE(got == read_text(folder / "file.png"));
}

TEST(WriteImage, IntoAPipeThatNobodyReadsTellsSo) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  EXPECT_EQ(sentence(write_image(sample_image(3, 2, Depth::u8, true), folder / "pipe.png").error()),
            (folder / "pipe.png").string() + ": is a pipe that nobody reads");
}

TEST(CheckTarget, SaysBeforehandWhatWouldFail) {
  const ScratchFolder folder;
  EXPECT_TRUE(check_output_path(folder / "a.png"));
  EXPECT_TRUE(check_output_path("-"));
  EXPECT_EQ(
      sentence(check_output_path(folder / "none/a.png").error()),
      sentence(write_image(sample_image(3, 2, Depth::u8, true), folder / "none/a.png").error()));
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteSvg, WritesTheWholeFileAndSaysWhatIsSimplified) {
  const ScratchFolder folder;
  SceneBuilder build({}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0, 0}, 0.3});
  const Relief relief{.area = disc, .profile = Profile::bevel, .width = 0.1, .height = 0.1};
  build.layer("disc", disc, {.color = {1, 0, 0, 1}, .relief = shared(relief)});
  const Scene scene = std::move(build).finish();
  const auto done = write_svg(scene, folder / "a.svg", {.width = 64, .height = 64});
  ASSERT_TRUE(done) << sentence(done.error());
  EXPECT_EQ(done->size(), 1u);
  EXPECT_EQ(read_text(folder / "a.svg"), svg_text(scene, {.width = 64, .height = 64})->text);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.svg"});
}

TEST(WriteSvg, ErrorsAreSentencesAndKeepTheOldFile) {
  const ScratchFolder folder;
  write_text(folder / "a.svg", "old");
  const auto refused = write_svg({}, folder / "a.svg", {.width = std::nan("")});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, (folder / "a.svg").string());
  EXPECT_EQ(read_text(folder / "a.svg"), "old");
  EXPECT_FALSE(write_svg({}, folder / "none" / "a.svg"));
  const auto full = write_svg({}, "/dev/full");
  ASSERT_FALSE(full);
  EXPECT_EQ(sentence(full.error()), "/dev/full: cannot be written: No space left on device");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.svg"});
}

}  // namespace
}  // namespace mien
