// mien set: a face file with other numbers and colours, and nothing else changed.

#include <mien/face_edit.h>
#include "render/image/file/written_file.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mien::command {

int set_command(const SetArguments& arguments) {
  if (is_given_as_code(arguments.face))
    return complain({arguments.face, "a code is no file; 'mien new --flat --code' writes one"},
                    kUsedWrongly);
  if (!read_face_or_report(arguments.face)) return kFailed;
  const auto edited = edit_face(arguments.face, arguments.settings, {}, face_letters());
  if (!edited) return complain(edited.error(), kUsedWrongly);
  if (!edited->left.empty())
    return complain(
        {arguments.face,
         fmt::format("cannot hold {}: a file holds the points, numbers and colours that "
                     "it writes itself; poses are for --set, and a recipe is of parts",
                     fmt::join(edited->left, ", "))},
        kUsedWrongly);
  const std::string& text = edited->text;
  const auto done = write_file(arguments.output,
                               [&](const PutBytes& put) { return put(text.data(), text.size()); });
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
