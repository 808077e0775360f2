// mien stimuli: the pictures of an experiment, from a plan or again from their manifest.

#include "lib/base/one_line.h"
#include "render/image/file/written_file.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/data/shown_stimulus.h"
#include "tools/mien/data/stimulus_manifest.h"
#include "tools/mien/data/stimulus_plan.h"
#include "tools/mien/output/sha256.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

namespace mien::command {
namespace {

/// Draws all, the first alone: what is wrong with one is mostly wrong with all.
Expected<StimulusManifest> show_all(const std::vector<Stimulus>& what, int size,
                                    const std::filesystem::path& folder) {
  std::vector<std::optional<Expected<ShownStimulus>>> shown(what.size());
  const auto draw = [&](std::size_t i) {
    shown[i] = show_stimulus(what[i], size, folder / what[i].file);
  };
  draw(0);
  if (!*shown[0]) return shown[0]->error();
  watched_for("pictures", int(what.size()) - 1, {}, [&](int i) { draw(std::size_t(i) + 1); });
  StimulusManifest manifest{.size = size, .shown = {}};
  for (auto& one : shown) {
    if (!*one) return one->error();
    manifest.shown.push_back(**std::move(one));
  }
  return manifest;
}

/// A warning for each factor that alone tells two pictures apart that are one.
std::vector<Error> equal_pictures(const StimulusPlan& plan,
                                  const std::vector<ShownStimulus>& shown) {
  std::vector<Error> warnings;
  std::set<std::size_t> told;
  std::map<std::string, const ShownStimulus*> first;
  for (const ShownStimulus& one : shown) {
    const auto [found, is_new] = first.emplace(one.sha256, &one);
    if (is_new) continue;
    const auto &levels = one.stimulus.levels, &others = found->second->stimulus.levels;
    std::vector<std::size_t> differ;
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (levels[i] != others[i]) differ.push_back(i);
    if (differ.empty() || !told.insert(differ.front()).second) continue;
    const std::size_t factor = differ.front();
    const auto of = std::ranges::find_if(plan.factors, [&](const Factor& any) {
      return std::ranges::count(any.columns(), levels[factor].first) > 0;
    });
    warnings.push_back(
        {of->where,
         fmt::format("{} and {} are the same picture, though {} is {} and {}",
                     found->second->stimulus.file, one.stimulus.file,
                     in_quotes(levels[factor].first), one_line(others[factor].second, 60),
                     one_line(levels[factor].second, 60))});
  }
  return warnings;
}

Expected<Done> make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{folder.string(), "cannot be made: " + failed.message()};
  return Done{};
}

Expected<Done> write_manifest(const StimulusManifest& manifest,
                              const std::filesystem::path& folder) {
  const std::string text = manifest_text(manifest);
  return write_file((folder / "manifest.json").string(),
                    [&](const PutBytes& put) { return put(text.data(), text.size()); });
}

/// The manifest that is in the folder, of an earlier plan; empty where there is none.
StimulusManifest earlier_manifest(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "manifest.json";
  if (!is_stimulus_manifest(file)) return {};
  auto manifest = read_stimulus_manifest(file);
  return manifest ? *std::move(manifest) : StimulusManifest{};
}

/// Removes the pictures of an earlier manifest that are not drawn again and still are what it tells; how many.
int remove_others(const StimulusManifest& earlier, const StimulusManifest& manifest,
                  const std::filesystem::path& folder) {
  std::set<std::string> drawn;
  for (const ShownStimulus& shown : manifest.shown) drawn.insert(shown.stimulus.file);
  int removed = 0;
  for (const ShownStimulus& shown : earlier.shown) {
    const std::filesystem::path file = folder / shown.stimulus.file;
    std::error_code failed;
    if (drawn.contains(shown.stimulus.file) || !std::filesystem::is_regular_file(file, failed))
      continue;
    if (const auto now = sha256_of_file(file); now && *now == shown.sha256)
      removed += std::filesystem::remove(file, failed);
  }
  return removed;
}

/// Writes the manifest of what was drawn, and tells how much that is.
int finish(const StimulusManifest& earlier, const StimulusManifest& manifest,
           const std::filesystem::path& folder, std::string_view more) {
  if (const auto done = write_manifest(manifest, folder); !done)
    return complain(done.error(), kFailed);
  const int removed = remove_others(earlier, manifest, folder);
  return print(
      fmt::format("{} pictures{}{}\n", manifest.shown.size(), more,
                  removed > 0 ? fmt::format("; {} of an earlier plan are removed", removed) : ""));
}

int draw_plan(const StimuliArguments& arguments) {
  std::vector<Error> warnings;
  const auto plan = read_stimulus_plan(arguments.plan, &warnings);
  warn(warnings);
  if (!plan) return complain(plan.error(), kFailed);
  warnings.clear();
  const auto what = stimuli(*plan, &warnings);
  warn(warnings);
  if (!what) return complain(what.error(), kFailed);
  if (const auto made = make_folder(arguments.output); !made)
    return complain(made.error(), kFailed);
  const StimulusManifest earlier = earlier_manifest(arguments.output);
  const auto manifest = show_all(*what, plan->size, arguments.output);
  if (!manifest) return complain(manifest.error(), kFailed);
  warn(equal_pictures(*plan, manifest->shown));
  return finish(earlier, *manifest, arguments.output, "");
}

/// The same pictures again: each must have the SHA-256 that the manifest says. Their own manifest says it, too.
int draw_again(const StimuliArguments& arguments) {
  const auto manifest = read_stimulus_manifest(arguments.plan);
  if (!manifest) return complain(manifest.error(), kFailed);
  std::vector<Stimulus> what;
  for (const ShownStimulus& shown : manifest->shown) what.push_back(shown.stimulus);
  if (what.empty()) return complain({arguments.plan, "no pictures"}, kFailed);
  if (const auto made = make_folder(arguments.output); !made)
    return complain(made.error(), kFailed);
  const StimulusManifest earlier = earlier_manifest(arguments.output);
  const auto again = show_all(what, manifest->size, arguments.output);
  if (!again) return complain(again.error(), kFailed);
  std::size_t others = 0;
  std::string first;
  for (std::size_t i = 0; i < what.size(); ++i) {
    if (again->shown[i].sha256 == manifest->shown[i].sha256) continue;
    if (others++ == 0) first = what[i].file;
  }
  if (others > 0)
    return complain({arguments.plan,
                     fmt::format("{} of {} pictures are not the ones it tells of; the first is {}",
                                 others, what.size(), in_quotes(first))},
                    kFailed);
  return finish(earlier, *again, arguments.output, ", all as the manifest says");
}

}  // namespace

int stimuli_command(const StimuliArguments& arguments) {
  return is_stimulus_manifest(arguments.plan) ? draw_again(arguments) : draw_plan(arguments);
}

}  // namespace mien::command
