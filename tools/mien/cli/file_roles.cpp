#include "tools/mien/cli/file_roles.h"
#include "lib/base/one_line.h"
#include "render/image/file/output_path.h"
#include "render/image/file_type.h"
#include "tools/mien/cli/named_file.h"
#include "tools/mien/film/film.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

namespace mien::command {
namespace {

namespace fs = std::filesystem;

/// The roles of each command's files.
class Roles {
 public:
  FileRoles operator()(const Help&) { return {}; }
  FileRoles operator()(const WrongUse&) { return {}; }
  FileRoles operator()(const RenderArguments& a) {
    read(a.posed);
    write("--output", a.output, lower_extension(a.output) == ".svg" ? Kind::data : Kind::picture);
    return draw("--error-map", a.error_map).all_;
  }
  FileRoles operator()(const BenchArguments&) { return {}; }
  FileRoles operator()(const CheckArguments& a) {
    for (const std::string& face : a.faces) read("FACE", face);
    return draw("--output", a.output).all_;
  }
  FileRoles operator()(const SceneArguments&) { return {}; }
  FileRoles operator()(const ListArguments&) { return {}; }
  FileRoles operator()(const FitArguments&) { return {}; }
  FileRoles operator()(const CodeArguments&) { return {}; }
  FileRoles operator()(const StudioArguments&) { return {}; }
  FileRoles operator()(const ServeArguments&) { return {}; }
  FileRoles operator()(const BatchArguments& a) { return read("PLAN", a.plan).all_; }
  FileRoles operator()(const JoinArguments& a) { return read("PLAN", a.plan).all_; }
  FileRoles operator()(const SetArguments&) { return {}; }  // FACE may be written again
  FileRoles operator()(const PcaArguments& a) {
    read("FRAMES", a.input).read("BASIS", a.basis).read("WEIGHTS", a.weights);
    read("--face", a.face).read("--mesh", a.mesh);
    const bool drawn = a.verb == PcaArguments::Verb::compare || a.verb == PcaArguments::Verb::sheet;
    write("--output", a.output, drawn ? Kind::picture : Kind::data);
    return draw("--plot", a.plot).all_;
  }
  FileRoles operator()(const MorphArguments& a) {
    read("REST", a.rest).read("MAP", a.map).read("NEUTRAL", a.neutral);
    for (const std::string& person : a.people) read("PEOPLE", person);
    read_named(a.targets);
    const bool drawn = !a.people.empty() && !film_type(a.output);
    return write("--output", a.output, drawn ? Kind::picture : Kind::data).all_;
  }
  FileRoles operator()(const MeshArguments& a) {
    read("NEUTRAL", a.neutral).read_named(a.targets);
    return draw("--output", a.output).all_;
  }
  FileRoles operator()(const AnimateArguments& a) {
    read(a.render.posed);
    read("--sound", a.sound);
    return write("--output", a.render.output, Kind::looked_after).all_;
  }
  FileRoles operator()(const SayArguments& a) {
    read(a.animate.render.posed);
    write("--sound", a.animate.sound);
    return write("--output", a.animate.render.output, Kind::looked_after).all_;
  }
  FileRoles operator()(const ImportArguments& a) {
    for (const std::string& file : a.files) read("FILES", name_and_file(file).second);
    return write("--output", a.output).all_;
  }
  FileRoles operator()(const SheetArguments& a) {
    read("FACE", a.face).read_named(a.pictures);
    return draw("--output", a.output).all_;
  }
  FileRoles operator()(const NewArguments& a) {
    read("--code", a.code).read("--near", a.near);
    for (const auto* two : {&a.between, &a.child_of})
      for (const std::string& one : *two) read(two == &a.between ? "--between" : "--child-of", one);
    return write("--output", a.output).all_;
  }
  FileRoles operator()(const PartsArguments& a) {
    for (const std::string& file : a.files) read("FILE", file);
    const bool begun = a.verb == PartsArguments::Verb::begin;
    return write("--output", a.output, begun ? Kind::data : Kind::picture).all_;
  }
  FileRoles operator()(const ChernoffArguments& a) {
    read("TABLE", a.table).read("--map", a.map);
    draw("--output", a.output).draw("--legend", a.legend).write("--manifest", a.manifest);
    return all_;
  }
  FileRoles operator()(const StimuliArguments& a) {
    return read("PLAN", a.plan)
        .write("--output", (fs::path(a.output) / "manifest.json").string(), Kind::looked_after)
        .all_;
  }

 private:
  using Kind = FileRole::Kind;

  Roles& read(const std::string& what, const std::optional<std::string>& path) {
    if (path && !path->empty()) all_.read.push_back({what, *path});
    return *this;
  }
  Roles& write(const std::string& what, const std::optional<std::string>& path,
               Kind kind = Kind::data) {
    if (path && !path->empty()) all_.written.push_back({what, *path, kind});
    return *this;
  }
  Roles& draw(const std::string& what, const std::optional<std::string>& path) {
    return write(what, path, Kind::picture);
  }
  Roles& read_named(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) read("FILES", name_and_file(text).second);
    return *this;
  }
  void read(const PosedFace& posed) {
    read("FACE", posed.face)
        .read("--arkit", posed.arkit)
        .read("--motion", posed.motion)
        .read("--speech", posed.speech)
        .read("--basis", posed.basis);
    for (const std::string& file : posed.morphs) read("--morphs", file);
  }

  FileRoles all_;
};

/// What a file is, whatever it is called: device and inode, or the place where a new one would be. Nothing: a device,
/// a pipe, standard output, a folder, or no place at all.
std::optional<std::string> identity(const std::string& path) {
  struct stat info = {};
  if (path == "-") return {};
  if (::stat(path.c_str(), &info) == 0) {
    if (!S_ISREG(info.st_mode)) return {};
    return fmt::format("{}:{}", info.st_dev, info.st_ino);
  }
  const auto target = find_output_path(path);
  if (!target) return {};
  std::error_code failed;
  const fs::path folder = fs::canonical(folder_of(target->path), failed);
  if (failed) return {};
  return (folder / target->path.filename()).string();
}

}  // namespace

FileRoles file_roles(const CommandLine& line) {
  return std::visit(Roles{}, line);
}

Expected<Done> check_file_roles(const FileRoles& roles) {
  std::vector<std::pair<std::string, std::string>> taken;  // identity and role
  for (const FileRole& file : roles.read)
    if (auto is = identity(file.path)) taken.emplace_back(*std::move(is), file.what + " reads it");
  int outputs = 0;
  for (const FileRole& file : roles.written) {
    const std::string where = file.what + " " + one_line(file.path, 60);
    if (file.path == "-" && outputs++ > 0)
      return Error{where, "two outputs cannot share standard output"};
    const auto is = identity(file.path);
    if (!is) continue;
    for (const auto& [other, role] : taken)
      if (other == *is) return Error{where, "would overwrite a file of this command: " + role};
    taken.emplace_back(*is, file.what + " writes it");
  }
  for (const FileRole& file : roles.written)
    if (file.kind == FileRole::Kind::picture)
      if (const auto type = file_type(file.path); !type) return type.error();
  return Done{};
}

Expected<Done> check_places(const FileRoles& roles) {
  for (const FileRole& file : roles.written) {
    if (file.kind == FileRole::Kind::picture && file.path == "-" && ::isatty(STDOUT_FILENO))
      return Error{file.what + " -",
                   "will not write a picture to a terminal; redirect it or name a file"};
    if (file.kind == FileRole::Kind::looked_after || file.path == "-") continue;
    if (const auto place = find_output_path(file.path); !place) return place.error();
  }
  return Done{};
}

}  // namespace mien::command
