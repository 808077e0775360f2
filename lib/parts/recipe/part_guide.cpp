#include "lib/parts/recipe/part_guide.h"

#include <algorithm>
#include <iterator>

namespace mien {
namespace {

struct Guide {
  std::string_view family, text;
};

constexpr Guide kGuides[] = {
    {"head",
     R"(points of the feature head: one half of the outline, from the crown down to the chin, in face widths.
Keep six, in this order: other parts know them as head.crown, head.upper, head.temple, head.cheek,
head.jaw and head.chin. Hair, ears, beards, muscles and patterns of the skin are beside them.
Each is a bend: the outline runs towards it and passes at some distance, so draw points a little outside.
adds: how far a point moves while a number does: crown, forehead, temple, cheek, jaw, chin_width, chin.
People differ by these numbers. [1, 0] moves a point sideways as far as the number goes, [0, 1] upwards.
turn: how much nearer than the face a point is when the head turns: the chin in front, the crown behind.
hair.top: on which small hats lie, if no hair is higher.
paint: the skin's light and rim. skin, skin_warm and skin_rim are the person's own colours.)"},
    {"ears",
     R"(One ear, to the right in the picture; the other is its image. Its middle is near [0.45, -0.05].
ear.lobe, ear.rim_low, ear.rim, ear.rim_top: where jewels hang, from the lobe upwards along the rim.)"},
    {"eyes",
     R"(One eye, to the right in the picture; the other is its image. Its middle is near [0.236, 0.036].
eye.inner, eye.outer: the corners, in which both lids end.
eye.upper, eye.lower: which way the lids bend. A lid comes half as far as its point, seen from the corners.
eye.iris: the middle of the iris. eye.iris_light: the middle of its lighter part.
iris.radius: half the height of the iris; pupil and lighter part follow.
crease.in, crease.mid, crease.out: the fold above the lid. crease.width: half its width in the middle.
lid.in, lid.mid, lid.out: half the width of the upper lid's line at the inner corner, in the middle and at
the outer corner. lid.low: of the lower lid's. lid.fold: how far the lid's own colour goes round the eye.
lash.wing: half the width of the lashes at the outer corner. lash.room: the most that lashes take; 0: none.
Lids move by themselves: blinks, gaze and emotions hold these points. Draw the eye open and at rest.
glint, glint_soft: lights on the eye. Each eye has its own, because both are lit from the same side.)"},
    {"brows",
     R"(One brow, to the right in the picture; the other is its image: spine [inner end, body, outer end].
Keep three points: other parts and the muscles know them as brow.in, brow.body and brow.out.
adds: brow.arch lifts the body, brow.thickness widens, asymmetry lifts the other side's brow, which is "right".)"},
    {"nose",
     R"(Keep the features nose, nose_light and nose_side: other parts and the muscles are beside them.
nose.base: the middle below the nose, where the upper lip's way ends and small tubes begin.)"},
    {"mouth",
     R"(The mouth at rest: one half, from the middle to the corner on the right; the other is its image.
lips.middle, lips.handle, lips.corner: the edge of the upper lip. It begins in the middle, runs towards the
handle without reaching it, and ends in the corner. lips.corner_other: the corner of the other half, as if it
were in this one; a crooked mouth has another place for it.
lips.low, lips.low_handle: the edge of the lower lip, which ends in the same corner. Where they are the same
points as the upper edge's, the mouth rests shut; lower down, it rests open, and shuts in speech.
line.upper, line.lower, line.end: half the width of the line on either edge, and of both in the corner.
lips.top, lips.top_side: the middle of the upper lip's red, which ends in the corner.
lips.bottom, lips.bottom_side: of the lower lip's.
lip.upper.mid, lip.upper.side: half the height of the upper lip in the middle and beside it.
lip.lower.mid, lip.lower.side: of the lower lip. lip.light: half the height of the light on the lower lip.
The mouth opens and smiles by itself: muscles hold these points. Teeth and tongue are there already.
gone: what of them is not shown, such as lip_upper and lip_lower of a mouth that is a line.
features: what there is besides, such as braces on the teeth. Most mouths have nothing.)"},
    {"hair",
     R"(hairline: where brows and muscles of the forehead stop: half its width, and its height.
hair.top: the highest point, on which small hats lie.
tail.root, pigtail.root: where tails begin, which hats may move below their brim.
Order is by slot: hair.far and hair.behind lie behind the head, hair.shade and hair before it.)"},
    {"beard",
     R"(adds: chin_width and chin, the head's numbers. What is "at" head.jaw or head.chin moves by itself.)"},
    {"jewel", R"(adds: brow.thickness, so that what is worn in the brow stays on its rim.)"},
    {"headwear",
     R"(hairline: where brows and muscles of the forehead stop: half the brim's width, and its height.
tail.root, pigtail.root: where tails of hair come out, below the brim.
hair_room: a feature of role "none". Hair is seen inside of it only.)"},
    {"clothes",
     R"(adds: neck, half the width of the neck, and shoulder, how high the shoulders are.)"},
    {"aid", R"(adds: neck, half the width of the neck.)"},
    {"lashes",
     R"(One eye's lashes, to the right in the picture: strokes from the lid towards a bend to a tip.
lash.bend, lash.tip: the wing at the outer corner. lash_b, lash_c, lash_d: three more on the upper lid;
lash_low_0, lash_low_1, lash_low_2: on the lower one; each with its .bend and .tip.
lash.root, lash.middle: half the width of the wing at its root and in the middle. lash.spike: of the three
others at their roots. lash.low: of the lower ones. adds: lash, the number by which lashes are longer.)"}};

}  // namespace

std::string_view part_guide(std::string_view family) {
  const auto* found = std::find_if(std::begin(kGuides), std::end(kGuides),
                                   [&](const Guide& guide) { return guide.family == family; });
  return found == std::end(kGuides) ? std::string_view() : found->text;
}

}  // namespace mien
