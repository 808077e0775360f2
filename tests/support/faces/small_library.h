#pragma once
// The least library of parts: a head, two noses, a frame, a few numbers. Tests add to it what they are about.

#include "lib/parts/library/part_library.h"

#include <memory>
#include <string>

namespace mien::test {

struct SmallLibrary {
  std::string topology = R"({"format": "mien-topology", "families": [
      {"name": "head", "number": 0, "first": true}, {"name": "nose", "number": 1, "optional": true}],
    "slots": ["back", "front"],
    "frames": {"face": {"from": [0, 0], "to": [0, 0]},
               "eye": {"from": [1, 2], "to": {"xy": [1, 2], "adds": {"apart": [1, 0]}},
                       "scale": {"xy": [1, 1], "adds": {"size": [1, 0.5]}}}},
    "anchors": {"chin": "head/points/0"},
    "numbers": {"apart": {"number": 10, "range": [-1, 1], "rest": 0},
                "size": {"number": 11, "range": [0, 2], "rest": 1, "sampled": {"spread": 0.5}},
                "skin.tone": {"number": 12, "range": [1, 10], "rest": 4},
                "skin.undertone": {"number": 13, "range": [-1, 1], "rest": 0}},
    "skin_tones": [[0.9, 0.04, 50], [0.5, 0.08, 60]],
    "palette": {"skin": {"skin": true}, "dark": {"from": "skin", "L": -0.1}},
    "styles": {"soft": {}, "ink": {"palette": {"dark": "#000000"},
               "roles": {"hair": {"paint": "skin"}}, "gone": ["shine"]}},
    "features": []})";
  std::string head = R"({"format": "mien-part", "family": "head", "name": "oval", "number": 1,
    "features": [{"name": "head", "slot": "back", "role": "skin", "in": "face", "kind": "path", "half": true, "turn": 0,
                  "points": [{"xy": [0.5, -1], "turn": 0.2}, [0, 1]]}]})";
  std::string noses = R"({"format": "mien-parts", "parts": [
    {"family": "nose", "name": "snub", "number": 1, "color": [0.5, 0.1, 20],
     "numbers": {"length": {"number": 20, "range": [0, 1], "rest": 0.5}}},
    {"family": "nose", "name": "long", "number": 2, "color": [0.6, 0.1, 20]}]})";

  Expected<std::unique_ptr<PartLibrary>> read() const {
    return PartLibrary::read(
        {{"topology.json", topology}, {"head.json", head}, {"noses.json", noses}});
  }
};

/// The same with a word of it replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace mien::test
