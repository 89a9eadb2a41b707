#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace cell {

/// A file that appears whole or not at all: written beside its place under a
/// name that no other process has, then put there. A place that is no regular
/// file (a device, a pipe) is written to directly. Storage adapter.
class Draft {
 public:
  /// Follows symbolic links. @throws std::runtime_error naming the file if it
  /// cannot be created.
  explicit Draft(std::filesystem::path target);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft();  ///< removes it unless it was put in its place

  /// What to write.
  const std::filesystem::path& path() const { return path_; }

  /// Forces what was written to the disk and puts it in its place, instead of
  /// what is there. @throws std::runtime_error naming the file.
  void Replace();
  /// The same, but @throws if a file is there, even one created meanwhile; the
  /// error ends with `advice`.
  void PutNew(std::string_view advice);

 private:
  void Sync() const;

  std::filesystem::path target_;
  std::filesystem::path path_;
  bool is_direct_ = false;
  bool is_placed_ = false;
};

/// Writes a whole file, checked to the close. @throws as Draft does.
void WriteFile(const std::filesystem::path& path, std::string_view text);
/// The same, but never replaces a file, and makes the folder that it is in.
void WriteNewFile(const std::filesystem::path& path, std::string_view text,
                  std::string_view advice);

/// To be called before long work that writes its result there. Makes the folder
/// that the file will be in.
/// @throws std::runtime_error with the advice if a regular file is there, or
/// naming the file if it cannot be created.
void RequireFree(const std::filesystem::path& path, std::string_view advice);

/// To be called with all that one command will write; empty ones count not.
/// @throws std::runtime_error naming a file that is among them twice.
void RequireDistinct(std::initializer_list<std::filesystem::path> paths);

/// Makes the folder and those above it, unless they are there.
/// @throws std::runtime_error naming it
void MakeFolder(const std::filesystem::path& folder);

}  // namespace cell
