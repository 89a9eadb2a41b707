#pragma once

#include <filesystem>
#include <vector>

#include "common/assemblies/annotation_reader.h"

namespace cell::cli {

/// @throws std::runtime_error naming the file
assemblies::AnnotationFile LoadAnnotations(const std::filesystem::path& path);

/// All files *.csv of a folder, in the order of their names.
/// @throws std::runtime_error naming the folder if there are none
std::vector<assemblies::AnnotationFile> LoadAnnotationFolder(
    const std::filesystem::path& folder);

/// Prints how many problems of each kind there are; of each the first
/// `num_shown`, with file and line, in full. Nothing if there are none.
void PrintProblems(const std::vector<assemblies::AnnotationFile>& files,
                   int num_shown);

}  // namespace cell::cli
