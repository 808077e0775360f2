#include "lib/parts/library/part_library.h"
#include "lib/base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

constexpr int kMostField = 1023;  // what two signs of a code hold

int permanent_number(const Reading& in, const JsonNode& of) {
  const JsonNode& node = in.need(of, "number");
  const double number = in.number(node);
  if (!(number >= 0 && number <= kMostField && number == double(int(number))))
    in.refuse(node, fmt::format("a permanent number is an integer from 0 to {}", kMostField));
  return int(number);
}

template <class T>
const T* named(const std::vector<T>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const T& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// A law of chances: numbers by name.
void expect_law(const Reading& in, const JsonNode& of, std::string_view key) {
  const JsonNode* law = in.find(of, key);
  if (!law) return;
  in.expect(*law, JsonKind::object);
  in.for_each(*law, [&](const JsonNode& node, int) { in.number(node); });
}

}  // namespace

const Part* Family::find(std::string_view part) const {
  return named(parts, part);
}

const std::string* PartLibrary::find_style(std::string_view name) const {
  for (const auto& [synonym, style] : style_synonyms_)
    if (synonym == name) return &style;
  const auto found = std::find(styles_.begin(), styles_.end(), name);
  return found == styles_.end() ? nullptr : &*found;
}

const Family* PartLibrary::find_family(std::string_view name) const {
  return named(families_, name);
}

const LibraryNumber* PartLibrary::find_number(std::string_view name) const {
  const auto found = number_of_.find(name);
  return found == number_of_.end() ? nullptr : &numbers_[found->second];
}

const LibraryNumber* PartLibrary::find_number(std::string_view name,
                                              std::string_view family) const {
  if (!family.empty()) {
    std::string own;
    own.reserve(family.size() + 1 + name.size());
    own.append(family).append(1, '.').append(name);
    if (const LibraryNumber* number = find_number(own)) return number;
  }
  return find_number(name);
}

void PartLibrary::read_numbers(const LibraryNode& from, std::string_view family) {
  const Reading& in = from.in();
  const JsonNode* all = in.find(*from.node, "numbers");
  if (!all) return;
  in.expect(*all, JsonKind::object);
  in.for_each(*all, [&](const JsonNode& node, int) {
    LibraryNumber made{.name = std::string(in.tree.key(node)),
                       .number = permanent_number(in, node)};
    if (!family.empty()) made.name = fmt::format("{}.{}", family, made.name);
    std::tie(made.lo, made.hi) = in.range(in.need(node, "range"));
    const JsonNode& rest = in.need(node, "rest");
    made.rest = in.number(rest);
    expect_law(in, node, "sampled");
    if (const JsonNode* law = in.find(node, "sampled")) made.law = {from.file, law};
    if (!(made.rest >= made.lo && made.rest <= made.hi))
      in.refuse(rest, "a number rests within its range");
    if (const LibraryNumber* known = find_number(made.name)) {  // parts of a family may share one
      if (known->number != made.number || known->lo != made.lo || known->hi != made.hi ||
          known->rest != made.rest)
        in.refuse(node, fmt::format("\"{}\" is another number in another part", made.name));
      return;
    }
    for (const LibraryNumber& other : numbers_)
      if (other.number == made.number)
        in.refuse(node, fmt::format("\"{}\" has the same permanent number", other.name));
    number_of_.emplace(made.name, numbers_.size());
    numbers_.push_back(std::move(made));
  });
}

/// {"round": {"number": 1, "tickets": {"any": 6}, "numbers": {"jaw": 0.44}}}, or "by" instead of "tickets".
void PartLibrary::read_archetypes(const LibraryNode& root) {
  const Reading& in = root.in();
  const JsonNode* all = in.find(*root.node, "archetypes");
  if (!all) return;
  in.expect(*all, JsonKind::object);
  in.for_each(*all, [&](const JsonNode& node, int) {
    Archetype made{.name = std::string(in.tree.key(node)),
                   .number = permanent_number(in, node),
                   .at = {root.file, &node},
                   .drawn = in.find(node, "by") == nullptr,
                   .offsets = std::vector<double>(numbers_.size())};
    for (const Archetype& other : archetypes_)
      if (other.number == made.number)
        in.refuse(node, fmt::format("\"{}\" has the same permanent number", other.name));
    in.need(node, made.drawn ? "tickets" : "by");
    for (const char* law : {"tickets", "by"}) expect_law(in, node, law);
    in.for_each(in.need(node, "numbers"), [&](const JsonNode& value, int) {
      const LibraryNumber* number = find_number(in.tree.key(value));
      if (!number) {
        std::vector<std::string_view> names;
        for (const LibraryNumber& one : numbers_) names.push_back(one.name);
        in.refuse(value, unknown_name("number", in.tree.key(value), names));
      }
      const double given = in.number(value);
      if (!(given >= number->lo && given <= number->hi))
        in.refuse(value,
                  fmt::format("{} goes from {} to {}", number->name, number->lo, number->hi));
      made.offsets[std::size_t(number - numbers_.data())] = given - number->rest;
    });
    archetypes_.push_back(std::move(made));
  });
}

void PartLibrary::read_topology(const LibraryNode& root) {
  const Reading& in = root.in();
  if (topology_.node) in.refuse(*root.node, "a library has one topology");
  topology_ = root;
  const JsonNode& families = in.need(*root.node, "families");
  in.expect(families, JsonKind::array);
  in.for_each(families, [&](const JsonNode& node, int) {
    const auto is = [&](std::string_view key) {
      const JsonNode* said = in.find(node, key);
      return said && in.boolean(*said);
    };
    for (const char* law : {"none", "worn", "apart"}) expect_law(in, node, law);
    families_.push_back({.name = in.name(in.need(node, "name")),
                         .number = permanent_number(in, node),
                         .optional = is("optional"),
                         .first = is("first"),
                         .at = {root.file, &node},
                         .parts = {}});
  });
  read_numbers(root, "");
  read_archetypes(root);
  const JsonNode& styles = in.need(*root.node, "styles");
  in.expect(styles, JsonKind::object);
  in.for_each(styles,
              [&](const JsonNode& style, int) { styles_.emplace_back(in.tree.key(style)); });
  if (const JsonNode* synonyms = in.find(*root.node, "style_synonyms"))
    in.for_each(*synonyms, [&](const JsonNode& one, int) {
      const std::vector<std::string_view> known(styles_.begin(), styles_.end());
      style_synonyms_.emplace_back(in.tree.key(one), styles_[in.word(one, "style", known)]);
    });
}

void PartLibrary::read_part(const LibraryNode& part) {
  const Reading& in = part.in();
  const JsonNode& family_node = in.need(*part.node, "family");
  const std::string_view family_name = in.string(family_node);
  const auto family = std::find_if(families_.begin(), families_.end(),
                                   [&](const Family& f) { return f.name == family_name; });
  if (family == families_.end()) {
    std::vector<std::string_view> names;
    for (const Family& f : families_) names.push_back(f.name);
    in.refuse(family_node, unknown_name("family", family_name, names));
  }
  Part made{in.name(in.need(*part.node, "name")), permanent_number(in, *part.node), part};
  for (const Part& other : family->parts)
    if (other.name == made.name || other.number == made.number)
      in.refuse(*part.node,
                fmt::format("\"{}\" has the same name or permanent number", other.name));
  expect_law(in, *part.node, "tickets");
  family->parts.push_back(std::move(made));
  read_numbers(part, family_name);
}

/// The choice of the topology, or else the part of the lowest permanent number: more parts, and names of files, change
/// neither.
void PartLibrary::choose_usual_parts() {
  for (Family& family : families_) {
    if (family.parts.empty()) continue;
    family.usual =
        std::min_element(family.parts.begin(), family.parts.end(),
                         [](const Part& a, const Part& b) { return a.number < b.number; })
            ->name;
    const Reading& in = family.at.in();
    const JsonNode* said = in.find(*family.at.node, "usual");
    if (!said) continue;
    std::vector<std::string_view> names;
    for (const Part& part : family.parts) names.push_back(part.name);
    family.usual = in.name(*said);
    if (!family.find(family.usual))
      in.refuse(*said, unknown_name(family.name, family.usual, names));
  }
}

/// Parts avoid what was chosen before them: families that stand before their own, or parts of these.
void PartLibrary::check_avoided() const {
  for (std::size_t own = 0; own < families_.size(); ++own)
    for (const Part& part : families_[own].parts) {
      const Reading& in = part.at.in();
      const JsonNode* avoids = in.find(*part.at.node, "avoids");
      if (!avoids) continue;
      in.expect(*avoids, JsonKind::array);
      in.for_each(*avoids, [&](const JsonNode& node, int) {
        const std::string_view name = in.string(node), family = name.substr(0, name.find('/'));
        std::vector<std::string_view> known;
        for (std::size_t f = 0; f < own; ++f) {
          known.push_back(families_[f].name);
          if (families_[f].name != family || family.size() == name.size()) continue;
          known.clear();
          for (const Part& one : families_[f].parts) known.push_back(one.name);
          break;
        }
        const std::string_view wanted =
            name.substr(family.size() < name.size() ? family.size() + 1 : 0);
        if (std::find(known.begin(), known.end(), wanted) == known.end())
          in.refuse(node, unknown_name("family or part before it", wanted, known));
      });
    }
}

/// What stands for a part that shows an expression, where nobody shows one, does not show one itself.
void PartLibrary::check_neutral() const {
  for (const Family& family : families_)
    for (const Part& part : family.parts) {
      const Reading& in = part.at.in();
      const JsonNode* neutral = in.find(*part.at.node, "neutral");
      if (!neutral) continue;
      std::vector<std::string_view> known;
      for (const Part& one : family.parts)
        if (!one.at.in().find(*one.at.node, "neutral")) known.push_back(one.name);
      if (std::find(known.begin(), known.end(), in.string(*neutral)) == known.end())
        in.refuse(*neutral, unknown_name("neutral " + family.name, in.string(*neutral), known));
    }
}

Expected<std::unique_ptr<PartLibrary>> PartLibrary::read(const std::vector<ShippedPart>& files) {
  auto library = std::make_unique<PartLibrary>();
  try {
    for (const ShippedPart& file : files) {
      auto tree = JsonTree::read(file.text, file.name, {});
      if (!tree) return tree.error();
      library->files_.emplace_back(std::string(file.name), file.text, *std::move(tree));
    }
    const auto format_of = [](const LibraryFile& file) {
      return file.reading.string(file.reading.need(file.tree.root(), "format"));
    };
    for (const LibraryFile& file : library->files_)
      if (format_of(file) == "mien-topology") library->read_topology({&file, &file.tree.root()});
    if (!library->topology_.node) return Error{"parts", "there is no topology among them"};
    for (const LibraryFile& file : library->files_) {
      const Reading& in = file.reading;
      if (format_of(file) == "mien-part") library->read_part({&file, &file.tree.root()});
      if (format_of(file) != "mien-parts") continue;
      in.for_each(in.need(file.tree.root(), "parts"), [&](const JsonNode& node, int) {
        library->read_part({&file, &node});
      });
    }
    library->choose_usual_parts();
    library->check_avoided();
    library->check_neutral();
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
  return library;
}

Expected<const PartLibrary*> PartLibrary::shipped_or_why() {
  static const auto library = read({shipped_parts().begin(), shipped_parts().end()});
  if (!library) return library.error();
  return library->get();
}

const PartLibrary& PartLibrary::shipped() {
  static const PartLibrary nothing;
  return *shipped_or_why().value_or(&nothing);
}

}  // namespace mien
