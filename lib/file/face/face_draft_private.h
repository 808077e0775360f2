#pragma once
// A face while it is being read, and the parts of its file that add to it.

#include <mien/face_model.h>
#include <mien/letters.h>
#include <mien/name_table.h>
#include "lib/file/face/placed_face_private.h"
#include "lib/file/json/reading.h"

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

inline constexpr std::array<std::string_view, 2> kSides{"left", "right"};  ///< as files say

/// A slice that a name in the file refers to, and whether the numbers beside the name were written for its
/// mirror image.
struct DriveTarget {
  int slice;
  bool mirrored;
};

/// How a file's node gives a slice's numbers: as they are, those of the other side, or not at all.
enum class Written : unsigned char { plain, mirrored, nowhere };

inline Written written(bool mirrored) {
  return mirrored ? Written::mirrored : Written::plain;
}

/// A channel of a control, and the side it acts on.
struct SidedChannel {
  Side side;
  Index<Channel> channel;
};

struct FaceDraft {
  FaceModel model;
  FaceVector vector;
  NameTable features, controls;  ///< of the model's, by name
  std::vector<Side>
      channel_sides;  ///< the half of a control that a channel stands for; shorter: none
  /// What the area of a feature is made of, clips and all.
  struct AreaSize {
    int depth;            ///< how many features deep
    std::size_t figures;  ///< how many figures decide it
  };
  std::vector<AreaSize> areas;       ///< per feature
  std::size_t area_figures = 0;      ///< of all areas, beyond what plain features have
  int pattern_figures = 0;           ///< of all patterns
  const Letters* letters = nullptr;  ///< what texts are made with; null: nothing
  int text_signs = 0;                ///< of all texts
  std::vector<char> mirrored;  ///< per feature: whether its numbers were written for the other side
  std::vector<std::string> mirrored_eyes;

  SlicePlaces* places = nullptr;  ///< where each slice stands; null: nobody asks

  /// Appends a slice with its values at rest; `node` is where they stand, `how` the file gives them.
  /// The name is given in parts: {"brow.left", "/", "spine"}.
  int add_slice(const Reading& in, const JsonNode& node,
                std::initializer_list<std::string_view> name, SliceKind kind,
                std::span<const double> values, Written how = Written::plain);

  /// The slice that an author's name ("opening/upper") refers to on a side; if there is none, the slice
  /// without a side; −1: none.
  int find_slice(std::string_view name, Side side) const;
  /// The slice "OWNER/PART"; −1: none.
  int find_slice_of(std::string_view owner, std::string_view part) const {
    return model.layout.find(joined({owner, "/", part}));
  }
  /// The slice "FEATURE.left/PART" of a feature that has sides; −1: none.
  int find_slice_of(std::string_view feature, Side side, std::string_view slash_and_part) const {
    return model.layout.find(joined({feature, ".", side_name(side), slash_and_part}));
  }
  /// The same for a feature.
  int find_feature(std::string_view name, Side side) const;
  /// The feature of exactly that name; with a side, of exactly that side's: −1: none.
  int feature_named(std::string_view name, Side side = Side::none) const;
  /// The control of exactly that name; none: there is none.
  Index<Control> find_control(std::string_view name) const;
  /// "gaze.left.x" of "gaze.x", or "gaze.x" itself, which must be there.
  Index<Control> control_on(const Reading& in, const JsonNode& node, std::string_view name,
                            Side side) const;

  /// Resolves a slice's name. The error for an unknown one names the nearest.
  int slice_named(const Reading& in, const JsonNode& node, std::string_view name, Side side) const;
  /// Reads "@NAME": a slice of that kind and size.
  int reference(const Reading& in, const JsonNode& node, Side side, SliceKind kind, int size) const;

  /// The slices that a name refers to, for something that acts on a side: that side's slice. For something
  /// without a side: the unsided slice, or those of both sides. `mirror`: the numbers beside the name are
  /// mirrored where the feature is. "FEATURE/*" means every point that the feature writes itself. Refuses unknown names.
  std::vector<DriveTarget> targets(const Reading& in, const JsonNode& node, std::string_view name,
                                   Side side, bool mirror) const;

  /// The same for "FEATURE/*".
  std::vector<DriveTarget> points_of(const Reading& in, const JsonNode& node,
                                     std::string_view feature, Side side, bool mirror) const;

  /// Reads numbers that are added to every slice that the node's key refers to on a side.
  std::vector<Offset> offsets(const Reading& in, const JsonNode& node, Side side,
                              bool mirror) const;

  /// Appends a feature.
  void add_feature(Feature feature, bool written_mirrored);
  /// Appends a control; its name, which the model's names keep, must be new.
  void add_control(const Reading& in, const JsonNode& name_node, Control control);
  /// Appends a control of all these channels and, for each of them that acts on a side, that side's
  /// own control: "NAME.left".
  void add_control(const Reading& in, const JsonNode& name_node, Control control,
                   std::span<const SidedChannel> channels);
  /// Appends a channel.
  Index<Channel> add_channel(Channel channel);
  /// The control of that name; refuses unknown ones.
  Index<Control> control_named(const Reading& in, const JsonNode& node,
                               std::string_view name) const;

  /// Whether numbers written for this slice belong to its mirror image.
  bool is_mirrored(int slice) const;

  /// Reads the numbers of one slice, mirrored if asked to. They stay until the next are read.
  std::span<double> slice_values(const Reading& in, const JsonNode& node, SliceKind kind, int least,
                                 int most, bool mirror) const;

 private:
  /// A name in parts as one text, which stays until the next.
  std::string_view joined(std::initializer_list<std::string_view> parts) const;

  mutable std::string name_;  ///< memory of joined
  mutable std::vector<double> numbers_;
};

void read_canvas(Reading& in, const JsonNode& node, FaceDraft& face);
void read_palette(Reading& in, const JsonNode& node, FaceDraft& face);
int read_paint(Reading& in, const JsonNode& node, const FaceDraft& face);

/// The feature whose paint is read; its numbers may have been written for the other side.
struct PaintPlace {
  std::string_view feature;  ///< "iris.left"
  Side side;
  bool mirrored;
};
/// A colour's name or a gradient.
void read_feature_paint(Reading& in, const JsonNode& node, const PaintPlace& place, FaceDraft& face,
                        Feature& feature);
/// `of`: what has that opacity: "iris.left", "groups/tint".
int read_opacity(Reading& in, const JsonNode& node, std::string_view of, FaceDraft& face);
Index<FaceRelief> read_relief(Reading& in, const JsonNode& node, const PaintPlace& place,
                              FaceDraft& face);
/// The keys "shadow", "glow" and "contour" of a feature; each null where it has none.
struct SurroundingNodes {
  const JsonNode *shadow, *glow, *contour;
};
Index<FaceSurroundings> read_surroundings(Reading& in, const SurroundingNodes& nodes,
                                          std::string_view feature, Side side, FaceDraft& face);
void read_groups(Reading& in, const JsonNode& node, FaceDraft& face);  ///< before the features
Index<FaceGroup> group_named(Reading& in, const JsonNode& node, const FaceDraft& face);
void read_group_clips(Reading& in, const JsonNode& node, FaceDraft& face);  ///< after them
void read_light(Reading& in, const JsonNode& node, FaceDraft& face);

void read_features(Reading& in, const JsonNode& node, FaceDraft& face);
void read_controls(Reading& in, const JsonNode& node, FaceDraft& face);
void read_poses(Reading& in, const JsonNode& node, FaceDraft& face);
void read_turn(Reading& in, const JsonNode& node, FaceDraft& face);
void read_eyes(Reading& in, const JsonNode& node, FaceDraft& face);
void read_mouth(Reading& in, const JsonNode& node, FaceDraft& face);
void read_clips(Reading& in, const JsonNode& node, FaceDraft& face);
void read_muscles(Reading& in, const JsonNode& node, FaceDraft& face);
void read_emotions(Reading& in, const JsonNode& node, FaceDraft& face);
/// {EMOTION: strength at rest}; null: none. Whether the face has a mood.
bool read_mood(Reading& in, const JsonNode* node, FaceDraft& face);
void read_expressions(Reading& in, const JsonNode& node, FaceDraft& face);

}  // namespace mien
