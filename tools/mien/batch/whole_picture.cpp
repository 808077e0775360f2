#include "tools/mien/batch/whole_picture.h"
#include <mien/face_model.h>
#include "tools/mien/commands/posed_face.h"

namespace mien::command {

Expected<RenderPlan> whole_picture(const RenderArguments& arguments) {
  if (arguments.region) return Error{"--region", "the plan's regions say it"};
  auto plan = plan_render(arguments);
  if (!plan) return plan;
  const auto face = read_face_or_code(arguments.posed.face, arguments.posed.style);
  if (!face) return face.error();
  const FaceCanvas& canvas = face->model->canvas;
  if (auto done = plan_view(*plan, arguments, {canvas.box, canvas.y_up}); !done)
    return done.error();
  return plan;
}

}  // namespace mien::command
