// mien serve: the command's pictures over HTTP, and what strangers may do to it.

#include <gtest/gtest.h>
#include <webp/decode.h>

#include <filesystem>
#include <string>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/web_peer.h"

namespace mien {
namespace {

using test::body_of;
using test::code_of;
using test::has;
using test::header_of;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;

const std::string kFace = "A66CB-AA5S0-14";

class Faces : public test::WebPeer {
 public:
  explicit Faces(const std::vector<std::string>& more = {}) : WebPeer(words(more)) {}

 private:
  static std::vector<std::string> words(const std::vector<std::string>& more) {
    std::vector<std::string> words{"serve", "--listen",  "127.0.0.1:0", "--threads",
                                   "2",     "--timeout", "60"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

/// What `mien render` writes with these options.
std::string rendered(const std::string& name, std::vector<std::string> options) {
  const ScratchFolder folder;
  options.insert(options.begin(), {"render", kFace, "-o", (folder / name).string()});
  const Ran ran = run_mien(options);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return test::read_text(folder / name);
}

TEST(Serve, DrawsWhatTheCommandDraws) {
  const Faces faces;
  EXPECT_EQ(faces.address(), "http://127.0.0.1:" + std::to_string(faces.port()) + "/");
  const std::string png = faces.get("/" + kFace + ".png?size=64&emotion=joy%3D.7&yaw=15");
  EXPECT_EQ(code_of(png), "200");
  EXPECT_EQ(header_of(png, "Content-Type"), "image/png");
  EXPECT_TRUE(body_of(png) ==
              rendered("a.png", {"--size", "64", "--emotion", "joy=.7", "--set", "yaw=15"}));
  EXPECT_TRUE(body_of(faces.get("/" + kFace +
                                ".png?width=40&height=30&depth=16&transparent&"
                                "style=ink&neutral")) ==
              rendered("a.png", {"--size", "40x30", "--depth", "16", "--background", "transparent",
                                 "--style", "ink", "--neutral"}));
  const std::string svg = faces.get("/" + kFace + ".svg?size=64&viseme=oh");
  EXPECT_EQ(header_of(svg, "Content-Type"), "image/svg+xml");
  EXPECT_TRUE(has(header_of(svg, "Content-Security-Policy"), "sandbox"));
  EXPECT_TRUE(body_of(svg) == rendered("a.svg", {"--size", "64", "--set", "viseme.O=1"}));
}

TEST(Serve, DrawsWebp) {
  const Faces faces;
  const ScratchFolder folder;
  const std::string answer = faces.get("/" + kFace + ".webp?size=48&transparent");
  EXPECT_EQ(header_of(answer, "Content-Type"), "image/webp");
  const std::string webp = body_of(answer);
  int width = 0, height = 0;
  std::uint8_t* const pixels = WebPDecodeRGBA(reinterpret_cast<const std::uint8_t*>(webp.data()),
                                              webp.size(), &width, &height);
  ASSERT_NE(pixels, nullptr) << answer.substr(0, 300);
  ASSERT_EQ(width, 48);
  ASSERT_EQ(height, 48);
  test::write_text(folder / "a.png",
                   rendered("a.png", {"--size", "48", "--background", "transparent"}));
  const test::Read png = test::read(folder / "a.png");
  ASSERT_EQ(png.spec.nchannels, 4);
  int differ = 0;
  for (std::size_t i = 0; i < png.channels.size(); ++i)
    // Where nothing is seen it has no colour.
    differ += png.channels[i / 4 * 4 + 3] > 0 && int(png.channels[i] * 255 + 0.5f) != pixels[i];
  EXPECT_EQ(differ, 0);
  WebPFree(pixels);
}

TEST(Serve, KnowsSomebodyForAnyWord) {
  const Faces faces;
  const std::string code = run_mien({"code", "--seed", "ada lovelace"}).out;
  const std::string of_word = faces.get("/seed/ada%20lovelace.png?size=32");
  const std::string of_code = faces.get("/" + code.substr(0, code.size() - 1) + ".png?size=32");
  EXPECT_EQ(code_of(of_word), "200");
  EXPECT_TRUE(body_of(of_word) == body_of(of_code));
  EXPECT_EQ(header_of(of_word, "ETag"), header_of(of_code, "ETag"));
  EXPECT_EQ(header_of(of_code, "Cache-Control"), "public, max-age=31536000, immutable");
  EXPECT_EQ(header_of(of_word, "Cache-Control"), "public, max-age=86400");
}

TEST(Serve, AnswersWhoHasThePicture) {
  const Faces faces;
  const std::string target = "/" + kFace + ".png?size=32";
  const std::string etag = header_of(faces.get(target), "ETag");
  ASSERT_EQ(etag.size(), 34u) << etag;
  for (const std::string& tags : {etag, "W/" + etag, "\"x\", " + etag, std::string("*")}) {
    const std::string same =
        faces.get(target, "GET", "127.0.0.1", "If-None-Match: " + tags + "\r\n");
    EXPECT_EQ(code_of(same), "304") << tags;
    EXPECT_EQ(header_of(same, "ETag"), etag);
    EXPECT_EQ(body_of(same), "");
  }
  for (const std::string& tags : {std::string("\"x\""), etag.substr(0, 33), std::string(",")})
    EXPECT_EQ(code_of(faces.get(target, "GET", "127.0.0.1", "If-None-Match: " + tags + "\r\n")),
              "200")
        << tags;
  EXPECT_NE(header_of(faces.get(target + "&blink=1"), "ETag"), etag);
}

TEST(Serve, AnswersHeadAndNoRange) {
  const Faces faces;
  const std::string target = "/" + kFace + ".png?size=32";
  const std::string head = faces.get(target, "HEAD"), whole = faces.get(target);
  EXPECT_EQ(code_of(head), "200");
  EXPECT_EQ(body_of(head), "");
  EXPECT_EQ(header_of(head, "Content-Length"), std::to_string(body_of(whole).size()));
  EXPECT_EQ(header_of(head, "ETag"), header_of(whole, "ETag"));
  for (const char* range : {"bytes=0-9", "bytes=-5", "bytes=99999999-", "bytes=9-0", "lines=1"}) {
    const std::string answer =
        faces.get(target, "GET", "127.0.0.1", std::string("Range: ") + range + "\r\n");
    EXPECT_EQ(code_of(answer), "200") << range;
    EXPECT_EQ(header_of(answer, "Accept-Ranges"), "none");
    EXPECT_TRUE(body_of(answer) == body_of(whole)) << range;
  }
}

TEST(Serve, TellsHealth) {
  const Faces faces;
  const std::string answer = faces.get("/healthz");
  EXPECT_EQ(code_of(answer), "200");
  EXPECT_EQ(body_of(answer), "ok\n");
  EXPECT_EQ(header_of(answer, "Cache-Control"), "no-store");
}

TEST(Serve, RefusesInASentence) {
  const Faces faces;
  const auto said = [&](const std::string& target) {
    const std::string answer = faces.get(target);
    EXPECT_EQ(header_of(answer, "Content-Type"), "text/plain; charset=utf-8");
    EXPECT_EQ(header_of(answer, "Content-Length"), std::to_string(body_of(answer).size()));
    return code_of(answer) + " " + body_of(answer);
  };
  const std::string face = "/" + kFace;
  EXPECT_EQ(said(face + ".png?emotoin=joy"),
            "400 no key named \"emotoin\"; did you mean \"emotion\"?\n");
  EXPECT_EQ(said(face + ".png?emotion=sadnes"),
            "400 emotion=sadnes: no emotion named \"sadnes\"; did you mean \"sadness\"?\n");
  EXPECT_EQ(said(face + ".png?yaw=99"), "400 yaw=99: \"yaw\" goes from -30 to 30, got 99\n");
  EXPECT_EQ(said(face + ".png?clip=idle"), "400 clip=idle: a clip runs at a moment: say time\n");
  EXPECT_EQ(said(face + ".png?depth=half"), "400 depth=half: PNG holds 8 or 16\n");
  EXPECT_EQ(said(face + ".webp?depth=16"), "400 depth=16: WebP holds 8\n");
  EXPECT_EQ(said(face + ".svg?depth=8"),
            "400 depth: is for pictures of pixels; an SVG file holds shapes\n");
  EXPECT_EQ(said(face + ".png?id-prefix=a"),
            "400 id-prefix: is for SVG files; pixels have no ids\n");
  EXPECT_EQ(said(face + ".png?size=2048"),
            "400 size=2048: this server draws 1024 pixels a side at most\n");
  EXPECT_EQ(said("/toon.face.json"), "404 .json: pictures are .png, .svg or .webp here\n");
  EXPECT_EQ(code_of(faces.get(face + ".png?x=" + std::string(3000, 'y'))), "414");
  EXPECT_EQ(code_of(faces.get(face + ".png?x=" + std::string(300'000, 'y'))), "400");
  EXPECT_EQ(code_of(faces.get(face + ".png", "GET", "127.0.0.1",
                              "Cookie: " + std::string(20'000, 'y') + "\r\n")),
            "431");
  EXPECT_EQ(code_of(faces.get("/healthz")), "200") << "and goes on";
}

// A face file named like a code, beside the server and above it, is nobody's business.
TEST(Serve, ServesNoFile) {
  const Faces faces;
  for (const char* path :
       {"/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc%2fpasswd.png",
        "//etc/passwd", "/etc/passwd%00.png", "/toon.png", "/faces/toon.png", "/./toon.png",
        "/seed", "/seed/", "/seed/../../etc/passwd", "/\\..\\..\\boot.ini", "/%", "/%ff.png"}) {
    const std::string answer = faces.get(path);
    EXPECT_EQ(code_of(answer).substr(0, 1), "4") << path << "\n" << answer;
    EXPECT_FALSE(has(answer, "root:")) << path;
  }
  // Behind /seed/ every text is a word, and a word is a number.
  EXPECT_EQ(code_of(faces.get("/seed/..%2f..%2fetc%2fpasswd.png?size=16")), "200");
  EXPECT_EQ(code_of(faces.get("/seed/a.png?style=/etc/passwd")), "400");
  EXPECT_EQ(code_of(faces.get("/seed/a.png?arkit=/etc/passwd")), "400");
}

TEST(Serve, AnswersGetAndHeadAlone) {
  const Faces faces;
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"}) {
    const std::string answer = faces.get("/healthz", method);
    EXPECT_EQ(code_of(answer), "405") << method;
    EXPECT_EQ(header_of(answer, "Allow"), "GET, HEAD");
  }
  for (const char* bytes : {"nonsense\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n",
                            "\r\n\r\n\r\n\0", "GET /healthz HTTP/1.1\r\nno colon\r\n\r\n"})
    EXPECT_FALSE(has(faces.asked(std::string(bytes) + "\r\n"), " 200 ")) << bytes;
  EXPECT_EQ(code_of(faces.get("/healthz")), "200") << "and goes on";
}

TEST(Serve, AnswersOneAfterTheOtherOnOneConnection) {
  const Faces faces;
  const int handle = faces.connected();
  std::string all;
  for (int i = 0; i < 20; ++i)
    all += faces.request("/seed/" + std::to_string(i % 3) + ".png?size=16", "HEAD");
  all += faces.request("/healthz", "GET", "127.0.0.1", "Connection: close\r\n");
  test::WebPeer::say(handle, all);
  const std::string answer = test::WebPeer::heard(handle);
  int answers = 0;
  for (std::size_t at = 0; (at = answer.find("HTTP/1.1 200", at)) != answer.npos; ++at) ++answers;
  EXPECT_EQ(answers, 21);
  EXPECT_TRUE(answer.ends_with("\r\n\r\nok\n"));
}

TEST(Serve, EndsWithoutLosingWhoHasAsked) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Faces faces;
    test::wait_until_handled(faces.id(), signal);
    const int handle = faces.connected();
    test::WebPeer::say(handle, faces.request("/seed/last.png?size=512"));
    // The server has read it once it answers another.
    EXPECT_EQ(code_of(faces.get("/healthz")), "200");
    const Ran ran = faces.end(signal);
    EXPECT_EQ(ran.code, 0) << signal;
    EXPECT_EQ(ran.err, "");
    const std::string answer = test::WebPeer::heard(handle);
    EXPECT_EQ(code_of(answer), "200") << answer.substr(0, 300);
    EXPECT_EQ(body_of(answer).size(), std::stoul("0" + header_of(answer, "Content-Length")));
  }
}

TEST(Serve, SaysThatItCannotListen) {
  const Faces faces;
  const auto said = [](const std::string& place) {
    const Ran ran = run_mien({"serve", "--listen", place});
    EXPECT_EQ(ran.code, 1);
    return ran.err;
  };
  const std::string taken = "127.0.0.1:" + std::to_string(faces.port());
  EXPECT_EQ(said(taken), "mien: --listen " + taken +
                             ": another program has this port; port 0 takes one that is free\n");
  EXPECT_EQ(said("203.0.113.7:0"),
            "mien: --listen 203.0.113.7:0: this machine has no such address; 127.0.0.1 is its own, "
            "0.0.0.0 all\n");
}

}  // namespace
}  // namespace mien
