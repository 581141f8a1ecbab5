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

/// Keeps the last pictures of a project, for the light and for the dark, in the user's cache.
void keepPictures(const std::filesystem::path& path, const QPixmap& light, const QPixmap& dark);
/// Null where none was kept.
QPixmap pictureOf(const std::filesystem::path& path, bool dark);

}  // namespace talus
