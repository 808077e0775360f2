#include "lib/rig/speech/phone_visemes.h"

#include "lib/face/standard_names.h"

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

namespace mien {
namespace {

Viseme first(PhoneAlphabet alphabet, std::string_view name) {
  return phone_meaning(alphabet, name).shapes[0].viseme;
}

TEST(PhoneVisemes, KnowTheSoundsOfEveryAlphabet) {
  for (const char* name : {"P", "B", "M"})
    EXPECT_EQ(first(PhoneAlphabet::arpabet, name), Viseme::PP);
  for (const char* name : {"p", "b", "m", "pʰ", "mː", "ˈp"})
    EXPECT_EQ(first(PhoneAlphabet::ipa, name), Viseme::PP) << name;
  EXPECT_EQ(first(PhoneAlphabet::ipa, "tʃ"), Viseme::CH) << "not as t";
  EXPECT_EQ(first(PhoneAlphabet::sampa, "tS"), Viseme::CH);
  EXPECT_EQ(first(PhoneAlphabet::sampa, "T"), Viseme::TH);
  EXPECT_EQ(first(PhoneAlphabet::arpabet, "T"), Viseme::DD);
  EXPECT_EQ(first(PhoneAlphabet::rhubarb, "B"), Viseme::SS);
  EXPECT_EQ(first(PhoneAlphabet::visemes, "ou"), Viseme::U);
  for (const char* name : {"", "sp", "SIL", "_", "pau"})
    for (const auto alphabet : {PhoneAlphabet::arpabet, PhoneAlphabet::ipa, PhoneAlphabet::sampa})
      EXPECT_EQ(first(alphabet, name), Viseme::sil) << name;
}

TEST(PhoneVisemes, DivideDiphthongsAndSoftenWhatIsUnstressed) {
  const PhoneMeaning now = phone_meaning(PhoneAlphabet::arpabet, "AW1");
  EXPECT_EQ(now.count, 2);
  EXPECT_EQ(now.shapes[1].viseme, Viseme::U);
  EXPECT_LT(phone_meaning(PhoneAlphabet::arpabet, "AH0").shapes[0].strength, 1);
  EXPECT_EQ(phone_meaning(PhoneAlphabet::arpabet, "AH1").shapes[0].strength, 1);
}

TEST(PhoneVisemes, TakeTheNearestForWhatTheyDoNotKnow) {
  const PhoneMeaning near = phone_meaning(PhoneAlphabet::arpabet, "MX");
  EXPECT_FALSE(near.known);
  EXPECT_EQ(near.shapes[0].viseme, Viseme::PP);
  EXPECT_FALSE(phone_meaning(PhoneAlphabet::ipa, "☃").known);
  EXPECT_EQ(first(PhoneAlphabet::ipa, "☃"), Viseme::kk);
}

/// A word or a slip, whose letters are sounds each for itself.
TEST(PhoneVisemes, TellWordsFromSounds) {
  using enum PhoneAlphabet;
  for (const char* name :
       {"hello", "blorp", "xq", "xx", "the", "ahoi", "aeiou", "pm", "ʃt", "ab", "paɪ"})
    EXPECT_FALSE(phone_meaning(ipa, name).known) << name;
  for (const char* name : {"b@U", "tSV", "n1a"})
    EXPECT_FALSE(phone_meaning(sampa, name).known) << name;
  EXPECT_EQ(first(ipa, "hello"), Viseme::kk) << "as it begins";
  // Aligners' and synthesisers' own: MFA's and espeak's.
  for (const char* name :
       {"tʃ",  "t͡ʃ",  "tʰ", "kʷ", "ɟʷ", "t̪",  "n̩",  "aː",  "ɑːɹ", "əl", "ən", "əm", "aɪə",
        "aɪɚ", "oːɹ", "ɔø", "pf", "kx", "nj", "nʲ", "ˈɛɹ", "a˥",  "ɑ5", "iə", "dʑ"})
    EXPECT_TRUE(phone_meaning(ipa, name).known) << name;
  for (const char* name : {"tS", "a:", "@U", "a_~", "i:6", "O6", "E@", "n_=", "\"aI"})
    EXPECT_TRUE(phone_meaning(sampa, name).known) << name;
}

/// Whoever writes a track by hand mixes them.
TEST(PhoneVisemes, KnowVisemesAmongPhones) {
  for (const PhoneAlphabet in : {PhoneAlphabet::ipa, PhoneAlphabet::arpabet})
    for (const char* name : {"PP", "FF", "kk", "nn"}) {
      const PhoneMeaning meaning = phone_meaning(in, name);
      EXPECT_TRUE(meaning.known) << name;
      EXPECT_EQ(kVisemeNames[int(meaning.shapes[0].viseme)], std::string_view(name));
    }
  EXPECT_EQ(first(PhoneAlphabet::ipa, "O"), Viseme::O);
  for (const PhoneAlphabet in : {PhoneAlphabet::ipa, PhoneAlphabet::visemes}) {
    EXPECT_EQ(first(in, "M"), Viseme::PP) << "of ARPABET";
    EXPECT_TRUE(phone_meaning(in, "OW1").known);
    EXPECT_TRUE(phone_meaning(in, "HH").known);
  }
  EXPECT_EQ(first(PhoneAlphabet::arpabet, "TH"), Viseme::TH);
}

TEST(PhoneVisemes, TellAlphabetsApart) {
  const auto of = [](std::vector<std::string_view> names) { return alphabet_of(names); };
  EXPECT_EQ(of({"X", "A", "D", "B"}), PhoneAlphabet::rhubarb);
  EXPECT_EQ(of({"sil", "PP", "aa", "E"}), PhoneAlphabet::visemes);
  EXPECT_EQ(of({"sil", "HH", "AH0", "L", "OW1"}), PhoneAlphabet::arpabet);
  EXPECT_EQ(of({"h", "ə", "l", "əʊ"}), PhoneAlphabet::ipa);
}

TEST(PhoneVisemes, KnowAzuresIds) {
  for (int id = 0; id < 22; ++id) EXPECT_TRUE(azure_viseme(id)) << id;
  EXPECT_EQ(azure_viseme(21)->shapes[0].viseme, Viseme::PP);
  EXPECT_EQ(azure_viseme(18)->shapes[0].viseme, Viseme::FF);
  for (const double id : {-1.0, 22.0, 0.5}) EXPECT_FALSE(azure_viseme(id)) << id;
}

TEST(PhoneVisemes, TellTheStress) {
  using enum PhoneAlphabet;
  EXPECT_EQ(phone_meaning(arpabet, "AH1").stress, 1);
  EXPECT_EQ(phone_meaning(arpabet, "AH2").stress, 0.5);
  EXPECT_EQ(phone_meaning(arpabet, "AH0").stress, 0);
  EXPECT_EQ(phone_meaning(ipa, "ˈəʊ").stress, 1);
  EXPECT_EQ(phone_meaning(ipa, "ˌa").stress, 0.5);
  EXPECT_EQ(phone_meaning(ipa, "ˈb").stress, 1) << "for the vowel that comes";
  EXPECT_EQ(phone_meaning(ipa, "a").stress, 0);
  EXPECT_EQ(phone_meaning(sampa, "\"E").stress, 1);
  EXPECT_EQ(phone_meaning(visemes, "aa").stress, 0);
}

}  // namespace
}  // namespace mien
