#include "tools/mien/batch/part_records.h"
#include <mien/version.h>
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "lib/file/json/reading.h"
#include "render/image/file/system_error.h"
#include "render/image/file/written_file.h"
#include "sdf/distance/instruction_sets.h"
#include "tools/mien/data/file_format.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <utility>

namespace mien::command {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kManifest = "manifest-", kJournal = ".mien-journal-", kLines = ".jsonl";
constexpr std::size_t kMostRecordBytes = std::size_t(4) << 30;
constexpr double kLargestNumber = 1e9;

std::string header_line(const PartHeader& header) {
  return fmt::format(
      "{{\"format\": \"mien-batch-part\", \"format_version\": 1, \"plan\": \"{}\", \"mien\": "
      "\"{}\", "
      "\"instructions\": \"{}\", \"part\": {}, \"of\": {}, \"items\": {}}}\n",
      header.plan, header.version, header.instructions, header.part, header.of, header.items);
}

std::string item_line(const std::string& item, const std::string& hash) {
  return fmt::format("{{\"item\": {}, \"sha256\": \"{}\"}}\n", json_string(item), hash);
}

long whole_of(const Reading& in, const JsonNode& object, const char* key, double least) {
  const JsonNode& node = in.need(object, key);
  const double value = in.number(node);
  if (!(value >= least && value <= kLargestNumber) || value != double(long(value)))
    in.refuse(node, fmt::format("expected a whole number from {}", least));
  return long(value);
}

void read_line(PartRecord& record, const Reading& in, bool first) {
  const JsonNode& root = in.tree.root();
  in.expect(root, JsonKind::object);
  if (!first) {
    const std::string_view item = in.string(in.need(root, "item"));
    record.items.emplace_back(item, in.string(in.need(root, "sha256")));
    return;
  }
  expect_format(in, root, "mien-batch-part");
  record.header = {.plan = std::string(in.string(in.need(root, "plan"))),
                   .version = std::string(in.string(in.need(root, "mien"))),
                   .instructions = std::string(in.string(in.need(root, "instructions"))),
                   .part = whole_of(in, root, "part", 1),
                   .of = whole_of(in, root, "of", 1),
                   .items = whole_of(in, root, "items", 0)};
}

/// Whole lines alone: what a journal's last write left of another is no line.
Expected<PartRecord> read_part_record(const fs::path& path) {
  const auto text = read_bytes(path, kMostRecordBytes);
  if (!text) return text.error();
  PartRecord record{.header = {}, .file = path.filename().string(), .journal = false, .items = {}};
  record.journal = record.file.starts_with(kJournal);
  std::size_t number = 0, from = 0;
  const FaceLimits limits;
  for (std::size_t end; (end = text->find('\n', from)) != std::string::npos; from = end + 1) {
    const auto line = std::string_view(*text).substr(from, end - from);
    const auto tree = JsonTree::read(line, path.string(), limits, ++number);
    if (!tree && record.journal) break;  // what a machine that failed kept of it
    if (!tree) return tree.error();
    try {
      read_line(record, Reading(*tree, limits, nullptr), number == 1);
    } catch (const Refusal& refusal) {
      return refusal.error;
    }
  }
  if (!record.journal && (number == 0 || from < text->size()))
    return Error{path.string(), "is no whole manifest: its last line has no end"};
  return record;
}

}  // namespace

PartHeader header_here(const std::string& plan_hash, long part, long of, long items) {
  const auto sets = batch::instruction_sets();
#ifdef MIEN_SAME_BITS_WITHOUT_FMA
  const bool fused = true;  // emulated where it is missing
#else
  const bool fused = sets.front().fused;
#endif
  return {.plan = plan_hash,
          .version = MIEN_VERSION_STRING,
          .instructions = fused ? "fused" : "unfused",
          .part = part,
          .of = of,
          .items = items};
}

std::string manifest_name(long part, long of) {
  return fmt::format("{}{}-of-{}{}", kManifest, part, of, kLines);
}

bool is_record_name(std::string_view name) {
  return name.ends_with(kLines) && (name.starts_with(kManifest) || name.starts_with(kJournal));
}

Expected<std::vector<PartRecord>> read_part_records(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
    if (is_record_name(at->path().filename().native())) paths.push_back(at->path());
  if (failed) return Error{folder.string(), "cannot be read: " + failed.message()};
  std::ranges::sort(paths);
  std::vector<PartRecord> records;
  for (const fs::path& path : paths) {
    auto record = read_part_record(path);
    // Another run of the same part may just have finished, and taken its journal away.
    if (!record && !fs::exists(path, failed)) continue;
    if (!record) return record.error();
    if (!record->header.plan.empty()) records.push_back(*std::move(record));
  }
  return records;
}

Expected<Done> write_manifest_file(const fs::path& folder, const PartHeader& header,
                                   const std::vector<std::pair<std::string, std::string>>& items) {
  return write_file((folder / manifest_name(header.part, header.of)).string(),
                    [&](const PutBytes& put) -> Expected<Done> {
                      std::string text = header_line(header);
                      for (const auto& [item, hash] : items) text += item_line(item, hash);
                      return put(text.data(), text.size());
                    });
}

Expected<PartJournal> PartJournal::begin(const fs::path& folder, const PartHeader& header) {
  std::random_device dice;
  const fs::path path = folder / fmt::format("{}{}-of-{}-{:08x}{:08x}{}", kJournal, header.part,
                                             header.of, dice(), dice(), kLines);
  const int descriptor =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) return Error{folder.string(), "cannot be written in: " + system_error(errno)};
  PartJournal journal(path, descriptor);
  if (auto done = journal.put(header_line(header)); !done) {
    ::unlink(path.c_str());
    return done.error();
  }
  return journal;
}

PartJournal::PartJournal(fs::path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

PartJournal::PartJournal(PartJournal&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

PartJournal::~PartJournal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Expected<Done> PartJournal::add(const std::string& item, const std::string& hash) {
  return put(item_line(item, hash));
}

Expected<Done> PartJournal::put(const std::string& line) {
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  ssize_t put = -1;
  do put = ::write(descriptor_, line.data(), line.size());
  while (put < 0 && errno == EINTR);
  if (put == ssize_t(line.size())) return Done{};
  const int failed = put < 0 ? errno : ENOSPC;
  if (put > 0 && ::ftruncate(descriptor_, before) != 0) {
    // The line has no end, so whoever reads it leaves it out.
  }
  return Error{path_.string(), "cannot be written: " + system_error(failed)};
}

}  // namespace mien::command
