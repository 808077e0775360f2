#include "tools/mien/batch/batch_plan.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "lib/file/json/reading.h"
#include "tools/mien/batch/items.h"
#include "tools/mien/batch/plan_hash.h"
#include "tools/mien/batch/whole_picture.h"
#include "tools/mien/cli/file_roles.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/data/file_format.h"
#include "tools/mien/data/stimulus_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace mien::command {
namespace {

/// Commands that make one file of their arguments alone.
constexpr std::array<std::string_view, 9> kCommands{
    "render", "animate", "sheet", "new", "chernoff", "morph", "mesh", "say", "stimuli"};
/// What a plan or mien batch itself says.
constexpr std::array<std::string_view, 4> kTaken{"-o", "--output", "--progress", "--help"};
constexpr int kMostJobs = 10'000, kMostNames = 16, kMostWords = 1000, kMostCuts = 1000;

class BatchPlanReader {
 public:
  explicit BatchPlanReader(Reading& in) : in_(in) {}

  BatchPlan read(const JsonNode& root) {
    in_.expect_only(root, {"$schema", "format", "format_version", "jobs"});
    expect_format(in_, root, "mien-batch");
    const JsonNode& jobs = in_.need(root, "jobs");
    in_.expect(jobs, JsonKind::array);
    if (jobs.count < 1 || jobs.count > kMostJobs)
      in_.refuse(jobs, fmt::format("expected 1 to {} jobs", kMostJobs));
    in_.for_each(jobs, [&](const JsonNode& node, int) { read_job(node); });
    return std::move(plan_);
  }

 private:
  long whole(const JsonNode& node, double least, double most) const {
    const double value = in_.number(node);
    if (!(value >= least && value <= most) || value != double(long(value)))
      in_.refuse(node, fmt::format("expected a whole number from {} to {:.0f}, got {}", least, most,
                                   value));
    return long(value);
  }

  void read_job(const JsonNode& node) {
    in_.expect_only(node, {"run", "each", "output", "join"});
    BatchJob job;
    job.where = in_.tree.where(node);
    read_run(in_.need(node, "run"), job);
    if (const JsonNode* each = in_.find(node, "each")) {
      in_.expect(*each, JsonKind::object);
      if (each->count > kMostNames) in_.refuse(*each, fmt::format("{} names at most", kMostNames));
      in_.for_each(*each, [&](const JsonNode& one, int) { read_variable(one, job); });
      check_count(*each, job);
    }
    const JsonNode& output = in_.need(node, "output");
    job.output = in_.string(output);
    check_braces(output, job.output, job);
    check_frames(output, job);
    if (const JsonNode* join = in_.find(node, "join")) read_join(*join, job);
    in_.for_each(in_.need(node, "run"), [&](const JsonNode& word, int i) {
      check_braces(word, job.run[std::size_t(i)], job);
    });
    job.first = plan_.items;
    plan_.items += job.count;
    plan_.jobs.push_back(std::move(job));
    finish(node, plan_.jobs.back());
  }

  void read_run(const JsonNode& node, BatchJob& job) const {
    in_.expect(node, JsonKind::array);
    if (node.count < 1 || node.count > kMostWords)
      in_.refuse(node,
                 fmt::format("expected a command and its arguments, 1 to {} words", kMostWords));
    in_.for_each(node, [&](const JsonNode& word, int i) {
      job.run.push_back(word.kind == JsonKind::number ? json_number(in_.number(word))
                                                      : std::string(in_.string(word)));
      const std::string_view text = job.run.back();
      if (i == 0) in_.word(word, "command for a plan", kCommands);
      for (const std::string_view taken : kTaken)
        if (text == taken ||
            (text.starts_with(taken) && (taken == "-o" || text[taken.size()] == '=')))
          in_.refuse(word, fmt::format("{} is not for a plan: \"output\" names the file",
                                       in_quotes(text)));
    });
  }

  void read_variable(const JsonNode& node, BatchJob& job) {
    Variable variable;
    variable.name = in_.tree.key(node);
    const bool plain = std::ranges::all_of(
        variable.name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (variable.name.empty() || !plain || variable.name == kThousand)
      in_.refuse(node, variable.name == kThousand
                           ? "this name is built in: it counts items by thousands"
                           : "a name has letters, digits and _ alone");
    if (job.cuts())
      in_.refuse(node, fmt::format("{} has pieces of one file, so it is the last name",
                                   in_quotes(job.each.back().name)));
    if (node.kind == JsonKind::array)
      read_words(node, variable);
    else
      read_source(node, variable, job);
    if (std::ranges::count(job.each, variable.name, &Variable::name) > 0)
      in_.refuse(node, "this name is there already");
    job.each.push_back(std::move(variable));
  }

  void read_words(const JsonNode& node, Variable& variable) const {
    in_.for_each(node, [&](const JsonNode& word, int) {
      variable.words.push_back(word.kind == JsonKind::number ? json_number(in_.number(word))
                                                             : std::string(in_.string(word)));
    });
    variable.count = long(variable.words.size());
    if (variable.count == 0) in_.refuse(node, "no value is named");
  }

  void read_source(const JsonNode& node, Variable& variable, const BatchJob& job) {
    in_.expect(node, JsonKind::object);
    in_.expect_only(node, {"people", "seed", "from", "to", "frames", "regions", "stimuli"});
    constexpr double kMost = 1e15;
    if (const JsonNode* people = in_.find(node, "people")) {
      variable.kind = Variable::Kind::people;
      variable.count = whole(*people, 1, kMost);
      const JsonNode* seed = in_.find(node, "seed");
      variable.seed = seed ? in_.string(*seed) : "1";
      if (variable.seed.empty()) in_.refuse(*seed, "an empty word is no seed");
    } else if (const JsonNode* frames = in_.find(node, "frames")) {
      variable.kind = Variable::Kind::frames;
      const auto range = read_frames(in_.string(*frames));
      if (!range) in_.refuse(*frames, range.error().what);
      variable.first = range->first, variable.count = range->count();
      need_command(node, job, "animate", "frames");
    } else if (const JsonNode* regions = in_.find(node, "regions")) {
      variable.kind = Variable::Kind::regions;
      const glm::dvec2 cuts = in_.pair(*regions);
      for (const double side : {cuts.x, cuts.y})
        if (!(side >= 1 && side <= kMostCuts) || side != double(int(side)))
          in_.refuse(*regions, fmt::format("expected columns and rows, 1 to {}", kMostCuts));
      variable.columns = int(cuts.x), variable.rows = int(cuts.y);
      variable.count = long(variable.columns) * variable.rows;
      need_command(node, job, "render", "regions");
    } else if (const JsonNode* stimuli = in_.find(node, "stimuli")) {
      need_command(node, job, "stimuli", "stimuli");
      read_stimuli(*stimuli, variable);
    } else {
      variable.kind = Variable::Kind::numbers;
      variable.first = whole(in_.need(node, "from"), 0, kMost);
      variable.count =
          whole(in_.need(node, "to"), double(variable.first), kMost) - variable.first + 1;
    }
  }

  void need_command(const JsonNode& node, const BatchJob& job, const char* command,
                    const char* what) const {
    if (job.run.front() != command)
      in_.refuse(node, fmt::format("{} are of {}, not of {}", what, in_quotes(command),
                                   in_quotes(job.run.front())));
  }

  void read_stimuli(const JsonNode& node, Variable& variable) const {
    variable.kind = Variable::Kind::stimuli;
    variable.file = in_.string(node);
    std::vector<Error> warnings;  // mien stimuli tells them
    const auto plan = read_stimulus_plan(variable.file, &warnings);
    if (!plan) in_.refuse(node, sentence(plan.error()));
    const auto what = mien::command::stimuli(*plan, &warnings);
    if (!what) in_.refuse(node, sentence(what.error()));
    for (const Stimulus& one : *what) variable.words.push_back(one.file);
    variable.count = long(variable.words.size());
  }

  /// As doubles, which do not overflow here.
  void check_count(const JsonNode& each, BatchJob& job) const {
    double all = 1;
    std::string product;
    for (const Variable& one : job.each) {
      all *= double(one.count);
      product += fmt::format("{}{}", product.empty() ? "" : " × ", one.count);
    }
    if (all + double(plan_.items) > double(kMostItems))
      in_.refuse(each, fmt::format("{} = {:.0f} items{}; a plan has {} at most", product, all,
                                   plan_.items > 0 ? fmt::format(", after {}", plan_.items) : "",
                                   kMostItems));
    job.count = long(all);
  }

  void check_braces(const JsonNode& node, const std::string& text, const BatchJob& job) const {
    std::vector<std::string_view> known{kThousand};
    for (const Variable& one : job.each) known.push_back(one.name);
    for (const std::string& name : names_in(text))
      if (std::ranges::count(known, name) == 0)
        in_.refuse(node, unknown_name("value", one_line(name, 60), known));
  }

  /// Frames are drawn many at once, by names with one place for a number.
  void check_frames(const JsonNode& node, const BatchJob& job) const {
    if (job.each.empty() || job.each.back().kind != Variable::Kind::frames) return;
    const std::vector<std::string> names = names_in(job.output);
    if (std::ranges::count(names, job.each.back().name) != 1)
      in_.refuse(node,
                 fmt::format("expected {{{}}} once, for the frame's number", job.each.back().name));
  }

  void read_join(const JsonNode& node, BatchJob& job) const {
    job.join = std::string(in_.string(node));
    if (!job.cuts())
      in_.refuse(node,
                 "needs pieces: the last name of \"each\" has \"regions\", \"frames\" or "
                 "\"stimuli\"");
    check_braces(node, *job.join, job);
    for (const std::string& name : names_in(*job.join))
      if (name == job.each.back().name || name == kThousand)
        in_.refuse(node, fmt::format("{{{}}} differs from piece to piece", name));
  }

  /// What the command itself says of the job's first item, and where regions lie.
  void finish(const JsonNode& node, BatchJob& job) {
    const JsonNode& run = in_.need(node, "run");
    if (job.run.front() == "stimuli") {
      if (!job.cuts() || job.run.size() != 1)
        in_.refuse(run,
                   "stimuli has no other words; the last name of \"each\" says its plan: "
                   "{\"stimuli\": FILE}");
      return;
    }
    BatchItem first{.job = &job, .at = std::vector<long>(job.each.size(), 0), .name = {}};
    const std::string output = filled(job.output, first);
    const CommandLine line = command_of(first, output, true);
    if (const auto* wrong = std::get_if<WrongUse>(&line)) in_.refuse(run, wrong->sentence);
    if (std::holds_alternative<Help>(line)) in_.refuse(run, "makes no file");
    for (const FileRole& file : file_roles(line).written)
      if (file.path != output)
        in_.refuse(run, fmt::format("an item is one file: {} writes another", file.what));
    if (job.cuts() && job.each.back().kind == Variable::Kind::regions)
      cut(run, std::get<RenderArguments>(line), job);
  }

  void cut(const JsonNode& run, const RenderArguments& arguments, BatchJob& job) const {
    const auto whole = whole_picture(arguments);
    if (!whole) in_.refuse(run, sentence(whole.error()));
    Variable& regions = job.each.back();
    if (regions.columns > whole->view.width || regions.rows > whole->view.height)
      in_.refuse(run,
                 fmt::format("{} x {} pixels cannot be cut into {} x {} regions", whole->view.width,
                             whole->view.height, regions.columns, regions.rows));
    regions.rects =
        cut_regions(whole->view.width, whole->view.height, regions.columns, regions.rows);
  }

  Reading& in_;
  BatchPlan plan_;
};

}  // namespace

Expected<BatchPlan> read_batch_plan(const std::filesystem::path& path, const std::string& name) {
  const FaceLimits limits;
  const auto text = read_bytes(path, limits.bytes);
  if (!text) return Error{name, text.error().what};
  const auto tree = JsonTree::read(*text, name, limits);
  if (!tree) return tree.error();
  Reading in(*tree, limits, nullptr);
  try {
    BatchPlan plan = BatchPlanReader(in).read(tree->root());
    plan.name = name;
    if (const auto named = check_names(plan); !named) return named.error();
    auto hash = plan_hash(plan, *text);
    if (!hash) return hash.error();
    plan.hash = *std::move(hash);
    return plan;
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace mien::command
