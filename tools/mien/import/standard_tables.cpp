// Sources: Apple's descriptions of ARKit's blend shapes; the muscles of each action unit as in
// P. Ekman, W. Friesen, J. Hager, Facial Action Coding System, 2002; VRM 1.0's presets by the
// feelings they are called; visemes by the lips' and jaw's part in them. Amounts are chosen by eye.

#include "standard_tables_private.h"

namespace mien {
namespace {

constexpr StandardTable kTables[] = {
    {"arkit", R"(
browDown* corrugator 0.6 procerus 0.8
browInnerUp inner-occipitofrontalis 1
browOuterUp* outer-occipitofrontalis 1
cheekPuff orbicularis-oris 0.4
cheekSquint* orbicularis-oculi 0.5
eyeBlink* orbicularis-oculi 1
eyeLookDown*
eyeLookIn*
eyeLookOut*
eyeLookUp*
eyeSquint* orbicularis-oculi 0.6
eyeWide* levator-palpabrae 1
jawForward mentalis 0.3
jawLeft left.buccinator 0.5
jawOpen jaw 1
jawRight right.buccinator 0.5
mouthClose mentalis 0.5
mouthDimple* buccinator 0.5
mouthFrown* depressor-anguli-oris 1
mouthFunnel orbicularis-oris 0.7 jaw 0.2
mouthLeft left.buccinator 0.6 left.zygomaticus 0.2
mouthLowerDown* jaw 0.3
mouthPress* orbicularis-oris 0.3 mentalis 0.2
mouthPucker orbicularis-oris 1
mouthRight right.buccinator 0.6 right.zygomaticus 0.2
mouthRollLower mentalis 0.4
mouthRollUpper orbicularis-oris 0.2
mouthShrugLower mentalis 1
mouthShrugUpper levator-labii 0.4
mouthSmile* zygomaticus 1
mouthStretch* buccinator 1
mouthUpperUp* levator-labii 0.8
noseSneer* levator-labii 0.5
tongueOut
)"},
    {"facs", R"(
AU1 inner-occipitofrontalis 1
AU2 outer-occipitofrontalis 1
AU4 corrugator 0.8 procerus 1
AU5 levator-palpabrae 1
AU6 orbicularis-oculi 0.7
AU7 orbicularis-oculi 0.5
AU9 levator-labii 0.6 procerus 0.4
AU10 levator-labii 1
AU11 levator-labii 0.4 zygomaticus 0.3
AU12 zygomaticus 1
AU13 zygomaticus 0.6
AU14 buccinator 0.6
AU15 depressor-anguli-oris 1
AU16 jaw 0.3
AU17 mentalis 1
AU18 orbicularis-oris 1
AU20 buccinator 1
AU22 orbicularis-oris 0.7 jaw 0.2
AU23 orbicularis-oris 0.6
AU24 orbicularis-oris 0.5 mentalis 0.4
AU25 jaw 0.25
AU26 jaw 0.6
AU27 jaw 1
AU28 orbicularis-oris 0.3 mentalis 0.5
AU41 orbicularis-oculi 0.4
AU42 orbicularis-oculi 0.6
AU43 orbicularis-oculi 1
AU44 orbicularis-oculi 0.7
AU45 orbicularis-oculi 1
AU46 orbicularis-oculi 1
)"},
    {"vrm", R"(
happy joy 1
angry anger 1
sad sadness 1
relaxed joy 0.4
surprised surprise 1
neutral
aa jaw 0.8
ih jaw 0.3 buccinator 0.4
ou orbicularis-oris 0.9 jaw 0.2
ee buccinator 0.7 jaw 0.2
oh jaw 0.6 orbicularis-oris 0.6
blink orbicularis-oculi 1
blink* orbicularis-oculi 1
)"},
    {"viseme", R"(
sil
PP orbicularis-oris 0.3 mentalis 0.3
FF levator-labii 0.3 mentalis 0.3
TH jaw 0.25
DD jaw 0.25 buccinator 0.2
kk jaw 0.3
CH orbicularis-oris 0.6 jaw 0.2
SS buccinator 0.4 jaw 0.1
nn jaw 0.2 buccinator 0.2
RR orbicularis-oris 0.4 jaw 0.2
aa jaw 0.9
E jaw 0.4 buccinator 0.5
I jaw 0.2 buccinator 0.7
O jaw 0.6 orbicularis-oris 0.6
U jaw 0.2 orbicularis-oris 0.9
)"},
};

}  // namespace

std::span<const StandardTable> standard_tables() {
  return kTables;
}

}  // namespace mien
