#include "render/svg/xml_text.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(XmlText, EscapesWhatXmlReads) {
  EXPECT_EQ(xml_escaped("a<b>&\"c\"'"), "a&lt;b&gt;&amp;&quot;c&quot;'");
  EXPECT_EQ(xml_escaped(""), "");
}

TEST(XmlText, KeepsUtf8AndReplacesWhatIsNone) {
  const std::string good = "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\xEE\x80\x80";
  EXPECT_EQ(xml_escaped(good), good);
  for (const char* bad : {"\x01", "\r", "\x7F\x80" + 1, "\xC0\xAF", "\xED\xA0\x80", "\xEF\xBF\xBF",
                          "\xF4\x90\x80\x80", "\xC3", "\xE2\x82"}) {
    const std::string made = xml_escaped(bad);
    EXPECT_EQ(made.find(bad), std::string::npos);
    EXPECT_EQ(made.substr(0, 3), "\xEF\xBF\xBD");
  }
  EXPECT_EQ(xml_escaped("\xC3x"), "\xEF\xBF\xBDx");
}

TEST(XmlText, IdsOccurOnceAndBeginWithALetter) {
  XmlIds ids("");
  EXPECT_EQ(ids.unique("iris.left"), "iris.left");
  EXPECT_EQ(ids.unique("iris.left"), "iris.left-2");
  EXPECT_EQ(ids.unique("iris.left-2"), "iris.left-2-2");
  EXPECT_EQ(ids.unique("iris.left"), "iris.left-3");
  EXPECT_EQ(ids.unique("1 eye"), "_1_eye");
  EXPECT_EQ(ids.unique(""), "_");
  EXPECT_EQ(XmlIds("a b-").unique("7"), "a_b-7");
}

}  // namespace
}  // namespace mien
