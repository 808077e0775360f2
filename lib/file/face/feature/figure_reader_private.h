#pragma once
// The figures of features, read one side at a time.

#include "lib/file/face/face_draft_private.h"
#include "lib/file/face/feature/part_name.h"

#include <string_view>
#include <vector>

namespace mien {

/// Reads one side of one feature: adds its slices to the face.
class FigureReader {
 public:
  /// `instead`: what differs on this side; may be null. `features`: the whole list, for errors.
  FigureReader(Reading& in, FaceDraft& face, const JsonNode& features, const JsonNode& node,
               const JsonNode* instead, std::string_view name, Side side, bool mirrored)
      : in_(in),
        face_(face),
        features_(features),
        node_(node),
        instead_(instead),
        name_(name),
        side_(side),
        mirrored_(mirrored) {}

  BandFigure band();
  EllipseFigure ellipse();
  DiscFigure disc();
  CutDiscFigure cut_disc();
  StrokeFigure stroke();
  PolylineFigure polyline();
  PathFigure path();
  OpeningFigure opening();
  RoundedFigure rounded();
  AreaFigure area();
  // pattern_reader.cpp
  ScatterFigure scatter();
  RepeatFigure repeat();
  StripesFigure stripes();
  // text_reader.cpp
  TextFigure text();

  /// A member's value for this side, and whether it was written for the other one.
  struct Field {
    const JsonNode* node;
    bool mirrored;
  };
  Field field(std::string_view key) const;

  int slice(std::string_view key, SliceKind kind, int size);

 private:
  Field need(std::string_view key) const;
  int add(const JsonNode& node, std::string_view part, SliceKind kind, int size, bool mirrored);
  int point(const JsonNode& node, std::string_view part, bool mirrored);
  std::vector<int> point_list(const Field& points, std::string_view part, int least);
  int pen_width();
  int optional_tilt();
  PathFigure::Node path_node(const JsonNode& node, std::string_view part, bool mirrored);
  PathFigure::Loop loop(const JsonNode& node, std::string_view part, bool mirrored);
  std::vector<Index<Feature>> operands(std::string_view key) const;

  std::shared_ptr<const TextOutline> text_outline(const JsonNode& node);

  PatternPatch patch();
  PatternMark mark();
  PatternChance chance(bool sways) const;
  double number_between(std::string_view key, double lo, double hi) const;
  bool flag(std::string_view key) const;
  int count(const JsonNode& node) const;

  Reading& in_;
  FaceDraft& face_;
  const JsonNode& features_;
  const JsonNode& node_;
  const JsonNode* instead_;
  std::string_view name_;
  Side side_;
  bool mirrored_;
};

/// A kind of feature: its name, its own keys and how it is read.
struct FigureKind {
  std::string_view name;
  std::vector<std::string_view>
      keys;           ///< and those of all features; those that may differ on a side first
  std::size_t sided;  ///< how many may
  Figure (*read)(FigureReader&);
};
const std::vector<FigureKind>& figure_kinds();
/// Their names.
const std::vector<std::string_view>& figure_names();

/// The earlier feature that a name means on a side. `features` is the whole list, so that the error can say
/// that the name comes later than what it `what`.
Index<Feature> earlier_feature(const Reading& in, const JsonNode& node, Side side,
                               const FaceDraft& face, const JsonNode& features,
                               std::string_view what);

}  // namespace mien
