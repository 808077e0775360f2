#include "tools/mien/batch/opened_batch.h"

#include <utility>

namespace mien::command {

Expected<OpenedBatch> open_batch(const std::string& plan, const std::string& folder) {
  namespace fs = std::filesystem;
  if (folder.empty()) return Error{"FOLDER", "its name is empty"};
  std::error_code failed;
  const fs::path file = fs::absolute(plan, failed), to = fs::absolute(folder, failed);
  if (failed) return Error{plan, failed.message()};
  fs::current_path(file.parent_path(), failed);
  if (failed) return Error{plan, "its folder: " + failed.message()};
  auto read = read_batch_plan(file, plan);
  if (!read) return read.error();
  return OpenedBatch{*std::move(read), to.lexically_normal()};
}

}  // namespace mien::command
