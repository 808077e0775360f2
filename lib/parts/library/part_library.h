#pragma once
// The library of parts: its topology, families of parts, numbers and styles, as JSON that was read once.

#include <mien/expected.h>
#include "lib/file/json/reading.h"
#include "lib/parts/library/shipped_parts.h"

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mien {

/// A file of the library, and the tree its parts refer to.
struct LibraryFile {
  LibraryFile(std::string file_name, std::string_view bytes, JsonTree json)
      : name(std::move(file_name)),
        text(bytes),
        tree(std::move(json)),
        reading(tree, limits, nullptr) {}
  LibraryFile(const LibraryFile&) = delete;

  std::string name;
  std::string_view text;
  JsonTree tree;
  FaceLimits limits;
  mutable Reading reading;
};

/// An object in one of the files.
struct LibraryNode {
  const LibraryFile* file = nullptr;
  const JsonNode* node = nullptr;

  const Reading& in() const { return file->reading; }
};

struct Part {
  std::string name;
  int number = 0;  ///< permanent, in its family
  LibraryNode at;
};

struct Family {
  std::string name;
  int number = 0;  ///< permanent; as a field of codes
  bool optional = false;
  bool first = false;  ///< drawn before the topology's own features, which may be beside its points
  LibraryNode at;
  std::vector<Part> parts;
  std::string usual;  ///< the part of a recipe that names none

  const Part* find(std::string_view part) const;
};

struct LibraryNumber {
  std::string name;
  int number = 0;  ///< permanent; as a field of codes
  double lo = 0, hi = 0, rest = 0;
  LibraryNode law;  ///< how it is sampled; none: at rest
};

/// What moves together on heads of one kind: a head that a person is somewhat like.
struct Archetype {
  std::string name;
  int number = 0;  ///< permanent; other numbers than parts, in no code
  LibraryNode at;
  bool drawn = false;           ///< by tickets; else as much as its law `by` says
  std::vector<double> offsets;  ///< of each of the library's common numbers, from its rest
};

class PartLibrary {
 public:
  /// The one that is compiled in; without anything in it if a file of it is broken.
  static const PartLibrary& shipped();
  /// The same; the error names what is broken and its place.
  static Expected<const PartLibrary*> shipped_or_why();

  /// Reads one topology and files of parts. Names and texts must outlive the library.
  static Expected<std::unique_ptr<PartLibrary>> read(const std::vector<ShippedPart>& files);

  const LibraryNode& topology() const { return topology_; }
  const std::vector<Family>& families() const { return families_; }
  const std::vector<LibraryNumber>& numbers() const { return numbers_; }
  const std::vector<Archetype>& archetypes() const { return archetypes_; }
  const std::vector<std::string>& styles() const { return styles_; }

  /// The style of a name, or of a former one ("style_synonyms" of the topology); null: none.
  const std::string* find_style(std::string_view name) const;
  const Family* find_family(std::string_view name) const;
  const LibraryNumber* find_number(std::string_view name) const;
  /// The number "FAMILY.NAME", or else "NAME".
  const LibraryNumber* find_number(std::string_view name, std::string_view family) const;

 private:
  void read_topology(const LibraryNode& root);
  void read_archetypes(const LibraryNode& root);
  void read_part(const LibraryNode& part);
  void choose_usual_parts();
  void check_avoided() const;
  void check_neutral() const;
  void read_numbers(const LibraryNode& from, std::string_view family);

  std::deque<LibraryFile> files_;
  LibraryNode topology_;
  std::vector<Family> families_;
  std::vector<LibraryNumber> numbers_;
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> number_of_;  ///< by name
  std::vector<std::string> styles_;
  std::vector<Archetype> archetypes_;
  std::vector<std::pair<std::string, std::string>> style_synonyms_;
};

}  // namespace mien
