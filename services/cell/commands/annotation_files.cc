#include "services/cell/commands/annotation_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <stdexcept>

#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/rules_files.h"

namespace cell::cli {

namespace fs = std::filesystem;
using assemblies::AnnotationFile;
using assemblies::AnnotationProblem;

AnnotationFile LoadAnnotations(const fs::path& path) {
  return assemblies::ReadAnnotations(TextOfFile(path), path.string());
}

std::vector<AnnotationFile> LoadAnnotationFolder(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw std::runtime_error(folder.string() + ": is no folder");
  }
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".csv") {
      paths.push_back(entry.path());
    }
  }
  if (paths.empty()) {
    throw std::runtime_error(folder.string() +
                             ": holds no annotations (files *.csv)");
  }
  std::ranges::sort(paths);
  std::vector<AnnotationFile> files;
  for (const fs::path& path : paths) files.push_back(LoadAnnotations(path));
  return files;
}

void PrintProblems(const std::vector<AnnotationFile>& files, int num_shown) {
  std::map<AnnotationProblem::Kind, std::vector<const AnnotationProblem*>> all;
  int num_rows = 0;
  int num_skipped = 0;
  for (const AnnotationFile& file : files) {
    num_rows += file.num_rows;
    num_skipped += file.num_skipped;
    for (const auto& problem : file.problems) {
      all[problem.kind].push_back(&problem);
    }
  }
  if (all.empty()) return;
  std::cout << fmt::format("input: {} in {}, {} skipped\n",
                           Counted(num_rows, "row"),
                           Counted(std::ssize(files), "file"), num_skipped);
  for (const auto& [kind, problems] : all) {
    std::cout << fmt::format("  {:>4} {}\n", problems.size(), NameOf(kind));
    for (size_t i = 0; i < problems.size(); ++i) {
      if (static_cast<int>(i) == num_shown) {
        std::cout << fmt::format("         and {} more\n", problems.size() - i);
        break;
      }
      std::cout << "         " << Printable(Show(*problems[i])) << "\n";
    }
  }
}

}  // namespace cell::cli
