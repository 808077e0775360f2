// mien studio: the web package, served to browsers on this machine.

#include "lib/base/one_line.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/http/http_server.h"
#include "tools/mien/studio/web_site.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace mien::command {
namespace {

namespace fs = std::filesystem;

constexpr std::uint16_t kDefaultPort = 6436;  // MIEN on the keys of a telephone

/// Where the package is installed, seen from the program.
fs::path installed_folder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return (program.parent_path() / MIEN_WEB_FROM_PROGRAM).lexically_normal();
}

Expected<fs::path> web_folder(const std::optional<std::string>& given) {
  const fs::path folder = given ? fs::path(*given) : installed_folder();
  const std::string where = (given ? "--folder " + one_line(*given) : one_line(folder.string()));
  std::error_code failed;
  if (fs::is_regular_file(folder / "studio" / "index.html", failed)) return folder;
  const char* const how =
      "tools/portable web makes it, in build/web/bind/web/package, and --folder says where it is";
  if (!fs::exists(folder, failed))
    return Error{
        where, fmt::format("there is no such folder; {}",
                           given ? how : std::string("the web package is not installed: ") + how)};
  if (!fs::is_directory(folder, failed)) return Error{where, "this is no folder"};
  return Error{where,
               fmt::format("there is no studio/index.html in it, as in the web package: {}", how)};
}

Expected<HttpServer> listening(std::optional<std::uint16_t> port) {
  if (port) return HttpServer::on({.port = *port, .said = fmt::format("--port {}", *port)}, {});
  auto server = HttpServer::on({.port = kDefaultPort}, {});
  return server ? std::move(server) : HttpServer::on({.said = "studio"}, {});
}

}  // namespace

int studio_command(const StudioArguments& arguments) {
  std::optional<std::uint16_t> port;
  if (arguments.port) {
    const auto number = read_whole("--port", *arguments.port, 0, 65535);
    if (!number) return complain(number.error(), kUsedWrongly);
    port = std::uint16_t(*number);
  }
  const auto folder = web_folder(arguments.folder);
  if (!folder) return complain(folder.error(), kFailed);
  auto server = listening(port);
  if (!server) return complain(server.error(), kFailed);
  if (const int said = print(server->url() + "studio/\n"); said != 0) return said;
  WebSite site((WebFolder(*folder)));
  server->run(site);
  return 0;
}

}  // namespace mien::command
