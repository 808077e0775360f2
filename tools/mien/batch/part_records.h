#pragma once
// What a part of a batch tells of its work: the plan, the version of mien, and each file's SHA-256.
//
// While a part is worked on, a journal takes a line for each file that is written: it is never rewritten, so a kill costs its last
// line at most, and two runs of one part do not disturb each other. At the part's end a manifest of the same lines appears whole,
// and its journals go. Nothing asks a clock or the time of a file.

#include <mien/expected.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mien::command {

/// What must be the same of all parts that belong together.
struct PartHeader {
  std::string plan;     ///< its hash
  std::string version;  ///< of mien
  std::string
      instructions;  ///< the class of instructions on which bytes may depend: "fused" or "unfused"
  long part = 1, of = 1;
  long items = 0;  ///< of the part
};

/// The header of a part that this process works on.
PartHeader header_here(const std::string& plan_hash, long part, long of, long items);

struct PartRecord {
  PartHeader header;
  std::string file;  ///< its name, without the folder
  bool journal = false;
  std::vector<std::pair<std::string, std::string>>
      items;  ///< name and SHA-256, in the file's order
};

/// "manifest-3-of-16.jsonl".
std::string manifest_name(long part, long of);
/// Whether a file in the folder itself may be a manifest or a journal.
bool is_record_name(std::string_view name);

/// All manifests and journals of a folder, in the order of their names. A journal's last line may be cut, and counts for nothing
/// then. Errors, with file and line: what is no record.
Expected<std::vector<PartRecord>> read_part_records(const std::filesystem::path& folder);

/// Writes the manifest, whole or not at all.
Expected<Done> write_manifest_file(const std::filesystem::path& folder, const PartHeader& header,
                                   const std::vector<std::pair<std::string, std::string>>& items);

/// A journal that is written to.
class PartJournal {
 public:
  /// Makes a new one. Errors have its address.
  static Expected<PartJournal> begin(const std::filesystem::path& folder, const PartHeader& header);
  PartJournal(PartJournal&& other) noexcept;
  PartJournal& operator=(PartJournal&&) = delete;
  ~PartJournal();

  /// One line more, in one write. What a full disk took of it is taken back.
  Expected<Done> add(const std::string& item, const std::string& hash);
  const std::filesystem::path& path() const { return path_; }

 private:
  PartJournal(std::filesystem::path path, int descriptor);
  Expected<Done> put(const std::string& line);

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace mien::command
