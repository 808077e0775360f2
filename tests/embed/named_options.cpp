// Options by name, as users write them: -Wextra must not ask for those that are left out.

#include <mien/mien.h>
#include <mien/pca.h>
#include <mien/svg.h>
#include <mien/write.h>

extern const mien::View kNamedView;
extern const mien::Pose kNamedPose;
extern const mien::RenderOptions kNamedRender;
extern const mien::WriteOptions kNamedWrite;
extern const mien::PictureOptions kNamedPicture;
extern const mien::SvgOptions kNamedSvg;
extern const mien::PcaOptions kNamedPca;

const mien::View kNamedView{.width = 1};
const mien::Pose kNamedPose{.unwrap = 1};
const mien::RenderOptions kNamedRender{.threads = {.count = 1}};
const mien::WriteOptions kNamedWrite{.half = true};
const mien::PictureOptions kNamedPicture{.memory = 1};
const mien::SvgOptions kNamedSvg{.width = 1};
const mien::PcaOptions kNamedPca{.single = true};
