#include "lib/parts/compose/part_palette.h"

#include <mien/face_code.h>

#include "lib/base/nearest_name.h"
#include "lib/parts/code/keyed_chance.h"

#include <algorithm>
#include <map>

namespace mien {
namespace {

Oklch read_oklch(const Reading& in, const JsonNode& node) {
  const std::vector<double> three = in.numbers(node, 3, 3);
  return {three[0], three[1], three[2]};
}

struct Toned {
  Oklch color;
  double alpha = 1;
  std::string_view text;  ///< of a colour that the file spells itself
};

class PaletteRules {
 public:
  PaletteRules(const ChosenParts& parts, const PartGeometry& geometry)
      : parts_(parts), geometry_(geometry) {
    skin_ =
        skin_color(parts.library(), geometry.value("skin.tone"), geometry.value("skin.undertone"));
    constexpr double kLightest = 0.93, kSpan = 0.6;
    darkness_ = (kLightest - skin_.lightness) / kSpan;
  }

  /// `tones`: the style's, each of which changes the colour of its name before others are made from it.
  void read(const Reading& in, const JsonNode& rules, const PartStyle* tones = nullptr) {
    const JsonNode* own = tones ? tones->find("tones") : nullptr;
    in.for_each(rules, [&](const JsonNode& rule, int) {
      const std::string_view name = in.tree.key(rule);
      colors_.insert_or_assign(name, made(in, rule));
      if (const JsonNode* tone = own ? tones->in().find(*own, name) : nullptr)
        colors_.insert_or_assign(name, made(tones->in(), *tone));
    });
  }

  void write(TreeWriter& to) const {
    to.object();
    for (const auto& [name, toned] : colors_) {
      to.key(name);
      to.kept_string(toned.text.empty() ? hex_of(toned.color, toned.alpha)
                                        : std::string(toned.text));
    }
    to.close();
  }

 private:
  const Toned& known(const Reading& in, const JsonNode& node) const {
    const auto found = colors_.find(in.string(node));
    if (found != colors_.end()) return found->second;
    std::vector<std::string_view> names;
    for (const auto& [name, toned] : colors_) names.push_back(name);
    in.refuse(node, unknown_name("colour", in.string(node), names));
  }

  /// a, or a + b · darkness of the skin.
  double by_darkness(const Reading& in, const JsonNode& rule, std::string_view key,
                     double otherwise) const {
    const JsonNode* node = in.find(rule, key);
    if (!node) return otherwise;
    if (node->kind == JsonKind::number) return in.number(*node);
    const std::vector<double> two = in.numbers(*node, 2, 2);
    return two[0] + two[1] * darkness_;
  }

  Toned made(const Reading& in, const JsonNode& rule) const {
    if (rule.kind == JsonKind::string) {
      const std::string_view text = in.string(rule);
      if (!text.empty() && text[0] == '#') return {{}, 1, text};
      return known(in, rule);
    }
    if (const JsonNode* then = in.find(rule, "then"))
      return made(in, holds(in, rule) ? *then : in.need(rule, "else"));
    Toned toned = base(in, rule);
    Oklch& c = toned.color;
    if (const JsonNode* of = in.find(rule, "L_of")) c.lightness = known(in, *of).color.lightness;
    c.lightness = c.lightness * by_darkness(in, rule, "L_times", 1) + by_darkness(in, rule, "L", 0);
    c.chroma = c.chroma * by_darkness(in, rule, "C_times", 1) + by_darkness(in, rule, "C", 0);
    c.hue += by_darkness(in, rule, "h", 0);
    if (const JsonNode* adds = in.find(rule, "adds"))
      in.for_each(*adds, [&](const JsonNode& add, int) {
        const double by = geometry_.value(in.tree.key(add));
        const Oklch more = read_oklch(in, add);
        c = {c.lightness + by * more.lightness, c.chroma + by * more.chroma, c.hue + by * more.hue};
      });
    c.lightness = std::clamp(c.lightness, by_darkness(in, rule, "least", 0),
                             by_darkness(in, rule, "most", 1));
    c.chroma = std::max(c.chroma, 0.0);
    toned.alpha = by_darkness(in, rule, "alpha", 1);
    return toned;
  }

  /// {"chance": 0.5, "of": WORD}: of so many people, by the person; {"worn": {FAMILY: [PART, …]}}; {"lighter": COLOUR,
  /// "than": L}.
  bool holds(const Reading& in, const JsonNode& rule) const {
    if (const JsonNode* chance = in.find(rule, "chance"))
      return KeyedChance(parts_.person()).share(seed_from_word(in.string(in.need(rule, "of")))) <
             in.number(*chance);
    if (const JsonNode* lighter = in.find(rule, "lighter"))
      return known(in, *lighter).color.lightness > in.number(in.need(rule, "than"));
    return parts_.wears(in, in.need(rule, "worn"));
  }

  Toned base(const Reading& in, const JsonNode& rule) const {
    if (in.find(rule, "skin")) return {skin_, 1, {}};
    if (const JsonNode* is = in.find(rule, "is")) return {read_oklch(in, *is), 1, {}};
    if (const JsonNode* from = in.find(rule, "from")) return {known(in, *from).color, 1, {}};
    if (const JsonNode* family = in.find(rule, "part")) {
      const Part* part = parts_.of(in.string(*family));
      if (part) return {color_of(*part), 1, {}};
      return {known(in, in.need(rule, "else")).color, 1, {}};
    }
    const JsonNode& both = in.need(rule, "mix");
    const JsonNode& first = *in.tree.first(both);
    // In OKLab a mixture never has a hue that neither has.
    const glm::dvec3 a = known(in, first).color.lab(),
                     b = known(in, *in.tree.next(first)).color.lab();
    const double share = in.number(in.need(rule, "share"));
    return {Oklch::from_lab((1 - share) * a + share * b), 1, {}};
  }

  const ChosenParts& parts_;
  const PartGeometry& geometry_;
  Oklch skin_;
  double darkness_ = 0;
  std::map<std::string_view, Toned> colors_;
};

}  // namespace

Oklch color_of(const Part& part) {
  return read_oklch(part.at.in(), part.at.in().need(*part.at.node, "color"));
}

Oklch skin_color(const PartLibrary& library, double tone, double undertone) {
  constexpr double kTurn = 8;  // [degrees] of hue that an undertone of 1 makes
  const Reading& in = library.topology().in();
  std::vector<Oklch> tones;
  in.for_each(in.need(*library.topology().node, "skin_tones"),
              [&](const JsonNode& node, int) { tones.push_back(read_oklch(in, node)); });
  const double at = std::clamp(tone - 1, 0.0, double(tones.size()) - 1.001);
  const Oklch &a = tones[std::size_t(at)], &b = tones[std::size_t(at) + 1];
  const double share = at - double(std::size_t(at));
  // Not std::lerp: how it rounds is the library's own.
  const auto between = [&](double from, double to) { return from + share * (to - from); };
  return {between(a.lightness, b.lightness), between(a.chroma, b.chroma),
          between(a.hue, b.hue) + kTurn * undertone};
}

void write_palette(const ChosenParts& parts, const PartGeometry& geometry, const PartStyle& style,
                   TreeWriter& to) {
  PaletteRules rules(parts, geometry);
  const LibraryNode& topology = parts.library().topology();
  rules.read(topology.in(), topology.in().need(*topology.node, "palette"), &style);
  if (const JsonNode* own = style.find("palette")) rules.read(style.in(), *own);
  rules.write(to);
}

}  // namespace mien
