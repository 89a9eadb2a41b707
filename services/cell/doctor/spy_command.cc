#include "services/cell/doctor/spy_command.h"

#include <filesystem>

#include "common/node/cell_files.h"

namespace cell::cli {
namespace {

constexpr char kInstall[] = "apt-get install -y --no-install-recommends ";

// The first Java with a complete toolkit: the headless one has no windows.
std::string FindJava(const Machine& machine, const std::string& root,
                     bool* is_headless) {
  const std::string folder = root + "/usr/lib/jvm";
  for (const std::string& name : machine.List(folder)) {
    const std::string home = folder + "/" + name;
    const std::string java = home + "/bin/java";
    if (!machine.Exists(java)) continue;
    if (machine.Exists(home + "/lib/libawt_xawt.so")) return java;
    *is_headless = true;
  }
  return "";
}

std::string FindTypesJar(const Machine& machine, const std::string& folder) {
  for (std::filesystem::path at = folder; at.has_relative_path();
       at = at.parent_path()) {
    const std::string jar = (at / "deploy/spy/cell_types.jar").string();
    if (machine.Exists(jar)) return jar;
  }
  const std::string installed = InstalledDataDir().string() + "/cell_types.jar";
  return machine.Exists(installed) ? installed : "";
}

}  // namespace

SpyParts FindSpyParts(const Machine& machine, const std::string& root,
                      const std::string& program_dir) {
  SpyParts parts;
  bool is_headless = false;
  parts.java = FindJava(machine, root, &is_headless);
  if (parts.java.empty()) {
    parts.missing.push_back(
        {is_headless ? "the Java here is headless: it has no windows"
                     : "Java is not installed",
         std::string(kInstall) + "openjdk-17-jre"});
  }
  const auto require = [&](const std::string& jar, const std::string& package) {
    const std::string path = root + "/usr/share/java/" + jar;
    if (!machine.Exists(path)) {
      parts.missing.push_back({path + " is missing", kInstall + package});
    }
    return path;
  };
  parts.lcm_jar = require("lcm.jar", "liblcm-java");
  parts.chart_jar = require("jchart2d.jar", "libjchart2d-java");
  parts.types_jar = FindTypesJar(machine, program_dir);
  if (parts.types_jar.empty()) {
    parts.missing.push_back(
        {"the jar of the cell's message types (deploy/spy/cell_types.jar "
         "beside or above " +
             program_dir +
             ") is missing: there was no Java when this was built",
         std::string(kInstall) +
             "openjdk-17-jdk-headless liblcm-java && scripts/build"});
  }
  return parts;
}

std::vector<std::string> SpyCommand(const SpyParts& parts,
                                    const std::string& lcm_url) {
  return {parts.java,
          "-Djava.net.preferIPv4Stack=true",
          "-cp",
          parts.lcm_jar + ":" + parts.chart_jar + ":" + parts.types_jar,
          "lcm.spy.Spy",
          "--lcm-url=" + lcm_url};
}

}  // namespace cell::cli
