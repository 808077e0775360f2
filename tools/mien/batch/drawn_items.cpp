#include "tools/mien/batch/drawn_items.h"
#include "tools/mien/commands/run_command.h"
#include "tools/mien/data/shown_stimulus.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/outer_work.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien::command {
namespace {

constexpr long kTogether = 64;  // frames: a kill costs their records at most

bool is_frame(const BatchItem& item) {
  return item.job->cuts() && item.job->each.back().kind == Variable::Kind::frames;
}

std::string without_percent(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '%' ? std::string("%%") : std::string(1, c);
  return out;
}

}  // namespace

std::string frame_pattern(const BatchItem& item) {
  const Variable& frames = item.job->each.back();
  const std::string place = "{" + frames.name + "}";
  const std::string& output = item.job->output;
  const std::size_t at = output.find(place);
  return without_percent(filled(output.substr(0, at), item)) +
         fmt::format("%0{}d", frames.text(0).size()) +
         without_percent(filled(output.substr(at + place.size()), item));
}

long ItemDrawer::together(long first, long end) const {
  const BatchItem item = item_of(plan_, first);
  if (!is_frame(item)) return 1;
  const std::string pattern = frame_pattern(item);
  long count = 1;
  for (; first + count < end && count < kTogether; ++count) {
    const BatchItem next = item_of(plan_, first + count);
    if (next.job != item.job || frame_pattern(next) != pattern ||
        next.at.back() != item.at.back() + count)
      break;
  }
  return count;
}

int ItemDrawer::make_folder(const BatchItem& item) {
  const std::filesystem::path folder = path_of(item).parent_path();
  if (folder == made_) return kDone;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return complain({folder.string(), "cannot be made: " + failed.message()}, kFailed);
  made_ = folder;
  return kDone;
}

int ItemDrawer::draw_stimulus(const BatchItem& item) {
  const std::string& file = item.job->each.back().file;
  if (experiments_.count(file) == 0) {
    std::vector<Error> warnings;  // mien stimuli tells them
    auto plan = read_stimulus_plan(file, &warnings);
    if (!plan) return complain(plan.error(), kFailed);
    auto what = stimuli(*plan, &warnings);
    if (!what) return complain(what.error(), kFailed);
    experiments_.emplace(file, Experiment{*std::move(plan), *std::move(what)});
  }
  const Experiment& experiment = experiments_.at(file);
  const auto shown = show_stimulus(experiment.what[std::size_t(item.at.back())],
                                   experiment.plan.size, path_of(item));
  return shown ? int(kDone) : complain(shown.error(), kFailed);
}

int ItemDrawer::draw(long first, long count, const Progress& whole, double from, double to) {
  const BatchItem item = item_of(plan_, first);
  const OuterWork within(fmt::format("{}: {}", item.job->where, item.name), whole, from, to);
  if (const int code = make_folder(item); code != kDone) return code;
  if (item.job->cuts() && item.job->each.back().kind == Variable::Kind::stimuli)
    return draw_stimulus(item);
  if (!is_frame(item)) return run_command(command_of(item, path_of(item).string()));
  CommandLine line =
      command_of(item, without_percent(folder_.string()) + "/" + frame_pattern(item), true);
  if (auto* const frames = std::get_if<AnimateArguments>(&line)) {
    const long begin = item.job->each.back().first + item.at.back();
    frames->frames = fmt::format("{}-{}", begin, begin + count - 1);
  }
  return run_command(line);
}

}  // namespace mien::command
