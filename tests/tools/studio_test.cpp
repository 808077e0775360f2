// mien studio: a folder for browsers of this machine, and nothing beside it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/process/web_peer.h"

namespace mien {
namespace {

using test::body_of;
using test::code_of;
using test::has;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;

const std::string kWasm("\0asm\1\0\0\0", 8);

/// A folder that looks like the web package, beside a secret.
void fill(const ScratchFolder& scratch) {
  std::filesystem::create_directories(scratch / "web/studio/faces");
  test::write_text(scratch / "web/studio/index.html", "<title>studio</title>");
  test::write_text(scratch / "web/studio/faces/a.face.json", "{}");
  test::write_text(scratch / "web/mien.js", "export {};");
  test::write_text(scratch / "web/a.png", "png");
  test::write_text(scratch / "web/a.svg", "<svg/>");
  test::write_text(scratch / "web/nothing.css", "");
  test::write_text(scratch / "web/with space.html", "space");
  test::write_text(scratch / "web/mien.wasm", kWasm);
  test::write_text(scratch / "secret.txt", "secret");
  std::filesystem::create_symlink("../secret.txt", scratch / "web/link.txt");
}

/// The studio in a process of its own.
class Studio : public test::WebPeer {
 public:
  explicit Studio(const ScratchFolder& scratch,
                  const std::vector<std::string>& more = {"--port", "0"})
      : WebPeer(words(scratch, more)) {}

 private:
  static std::vector<std::string> words(const ScratchFolder& scratch,
                                        const std::vector<std::string>& more) {
    std::vector<std::string> words{"studio", "--folder", (scratch / "web").string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

TEST(Studio, ServesThePackage) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  EXPECT_EQ(studio.address(), "http://127.0.0.1:" + std::to_string(studio.port()) + "/studio/");
  EXPECT_EQ(body_of(studio.get("/studio/")), "<title>studio</title>");
  EXPECT_EQ(body_of(studio.get("/mien.wasm?1#2")), kWasm);
  EXPECT_EQ(body_of(studio.get("/with%20space.html", "GET", "localhost")), "space");
  const std::string nothing = studio.get("/nothing.css");
  EXPECT_EQ(code_of(nothing), "200");
  EXPECT_TRUE(has(nothing, "Content-Length: 0\r\n")) << nothing;
}

TEST(Studio, SaysWhatFilesAre) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  for (const auto& [path, type] : std::vector<std::pair<std::string, std::string>>{
           {"/mien.wasm", "application/wasm\r\n"},
           {"/mien.js", "text/javascript; charset=utf-8\r\n"},
           {"/studio/faces/a.face.json", "application/json\r\n"},
           {"/a.svg", "image/svg+xml\r\n"},
           {"/a.png", "image/png\r\n"},
           {"/studio/index.html", "text/html; charset=utf-8\r\n"}}) {
    const std::string answer = studio.get(path);
    EXPECT_EQ(code_of(answer), "200") << path;
    EXPECT_TRUE(has(answer, "Content-Type: " + type)) << answer;
  }
}

TEST(Studio, ShowsTheWayToFolders) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  for (const char* path : {"/", "/studio"}) {
    const std::string answer = studio.get(path);
    EXPECT_EQ(code_of(answer), "302") << path;
    EXPECT_TRUE(has(answer, "Location: /studio/\r\n")) << answer;
  }
  EXPECT_EQ(code_of(studio.get("/studio/faces/")), "404") << "a list of files is nobody's business";
}

TEST(Studio, KeepsToItsFolder) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  for (const char* path : {"/../secret.txt", "/%2e%2e/secret.txt", "/studio/../../secret.txt",
                           "/studio/%2E%2e%2f..%2Fsecret.txt", "/..", "/link.txt"}) {
    const std::string answer = studio.get(path);
    EXPECT_EQ(code_of(answer), "403") << path;
    EXPECT_FALSE(has(answer, "\r\n\r\nsecret")) << path;
  }
  const std::string beside = "/" + (scratch / "secret.txt").string();
  for (const std::string& path : {std::string("/missing"), std::string("//secret.txt"),
                                  std::string("/%00"), std::string("/mien.wasm%00.html"), beside}) {
    const std::string answer = studio.get(path);
    EXPECT_EQ(code_of(answer).substr(0, 1), "4") << path;
    EXPECT_FALSE(has(answer, "\r\n\r\nsecret")) << path;
  }
}

TEST(Studio, AnswersGetAndHeadAlone) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  const std::string head = studio.get("/mien.wasm", "HEAD");
  EXPECT_EQ(code_of(head), "200");
  EXPECT_TRUE(has(head, "Content-Length: 8\r\n")) << head;
  EXPECT_EQ(body_of(head), "");
  EXPECT_EQ(body_of(studio.get("/missing", "HEAD")), "");
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    const std::string answer = studio.get("/mien.wasm", method);
    EXPECT_EQ(code_of(answer), "405") << method;
    EXPECT_TRUE(has(answer, "Allow: GET, HEAD\r\n")) << answer;
  }
  EXPECT_FALSE(has(studio.asked("nonsense\r\n\r\n"), " 200 "));
  EXPECT_EQ(code_of(studio.get("/mien.js")), "200") << "and goes on";
}

// A page elsewhere whose name was given this machine's address is refused: browsers say whom they think they ask.
TEST(Studio, AnswersToItsOwnNamesAlone) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  EXPECT_EQ(code_of(studio.get("/mien.js", "GET", "elsewhere.example")), "421");
}

TEST(Studio, EndsAtCtrlC) {
  const ScratchFolder scratch;
  fill(scratch);
  for (const int signal : {SIGINT, SIGTERM}) {
    Studio studio(scratch);
    test::wait_until_handled(studio.id(), signal);
    const Ran ran = studio.end(signal);
    EXPECT_EQ(ran.code, 0) << signal;
    EXPECT_EQ(ran.err, "");
  }
}

TEST(Studio, SaysThatAPortIsTaken) {
  const ScratchFolder scratch;
  fill(scratch);
  const Studio studio(scratch);
  const std::string port = std::to_string(studio.port());
  const Ran ran = run_mien({"studio", "--folder", (scratch / "web").string(), "--port", port});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "mien: --port " + port +
                         ": another program has this port; port 0 takes one that is free\n");
}

TEST(Studio, TakesAnotherPortThanItsOwnIfNobodyAsked) {
  const ScratchFolder scratch, again;
  fill(scratch), fill(again);
  const Studio first(scratch, {}), second(again, {});
  EXPECT_NE(first.port(), second.port());
  EXPECT_EQ(code_of(second.get("/mien.js")), "200");
}

TEST(Studio, SaysWhatIsWrongWithAFolder) {
  const ScratchFolder scratch;
  const std::string how =
      "tools/portable web makes it, in build/web/bind/web/package, and --folder says where it is\n";
  const auto said = [&](const std::string& folder) {
    const Ran ran = run_mien({"studio", "--port", "0", "--folder", folder});
    EXPECT_EQ(ran.code, 1);
    return ran.err;
  };
  const std::string missing = (scratch / "missing").string(), file = (scratch / "file").string(),
                    empty = (scratch / "empty").string();
  test::write_text(file, "");
  std::filesystem::create_directory(empty);
  EXPECT_EQ(said(missing), "mien: --folder " + missing + ": there is no such folder; " + how);
  EXPECT_EQ(said(file), "mien: --folder " + file + ": this is no folder\n");
  EXPECT_EQ(said(empty),
            "mien: --folder " + empty +
                ": there is no studio/index.html in it, as in the web package: " + how);
  const Ran installed =
      run_mien({"studio", "--port", "0"});  // the build's program, beside which nothing is
  EXPECT_EQ(installed.code, 1);
  EXPECT_TRUE(
      has(installed.err,
          "share/mien/web: there is no such folder; the web package is not installed: " + how))
      << installed.err;
}

}  // namespace
}  // namespace mien
