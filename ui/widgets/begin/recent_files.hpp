#pragma once

#include <QPixmap>
#include <filesystem>
#include <vector>

namespace talus {

/// A project file or results folder that was opened before.
struct RecentFile {
  std::filesystem::path path;
  bool isThere = true;
};

/// Newest first.
std::vector<RecentFile> recentFiles();
void rememberRecent(const std::filesystem::path& path);
void forgetRecent(const std::filesystem::path& path);

/// Keeps the last picture of a project in the user's cache.
void keepPicture(const std::filesystem::path& path, const QPixmap& picture);
/// Null where none was kept.
QPixmap pictureOf(const std::filesystem::path& path);

}  // namespace talus
