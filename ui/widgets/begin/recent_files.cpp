#include "widgets/begin/recent_files.hpp"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>

#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int most_recent = 6;
constexpr int picture_width = 320;  // pixels: twice as wide as it is shown
const QString recent_key = QStringLiteral("recent");

QString nameOf(const std::filesystem::path& path) { return text(std::filesystem::absolute(path).string()); }

/// Where a project's picture lies in the cache: by its path, which may hold anything.
QString pictureFile(const std::filesystem::path& path, bool dark) {
  const auto key = QCryptographicHash::hash(nameOf(path).toUtf8(), QCryptographicHash::Sha1).toHex();
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/pictures/") +
         QString::fromLatin1(key) + (dark ? QStringLiteral("-dark.png") : QStringLiteral(".png"));
}

}  // namespace

std::vector<RecentFile> recentFiles() {
  std::vector<RecentFile> files;
  for (const QString& name : QSettings().value(recent_key).toStringList()) {
    const std::filesystem::path path = name.toStdString();
    std::error_code unknown;
    files.push_back({path, std::filesystem::exists(path, unknown)});
  }
  return files;
}

void rememberRecent(const std::filesystem::path& path) {
  QStringList names{nameOf(path)};
  for (const auto& other : recentFiles()) {
    const QString name = nameOf(other.path);
    if (!names.contains(name) && names.size() < most_recent) names << name;
  }
  QSettings().setValue(recent_key, names);
}

void forgetRecent(const std::filesystem::path& path) {
  QStringList names = QSettings().value(recent_key).toStringList();
  names.removeAll(nameOf(path));
  QSettings().setValue(recent_key, names);
  for (const bool dark : {false, true}) QFile::remove(pictureFile(path, dark));
}

void keepPictures(const std::filesystem::path& path, const QPixmap& light, const QPixmap& dark) {
  for (const bool isDark : {false, true}) {
    const QString file = pictureFile(path, isDark);
    QDir().mkpath(QFileInfo(file).path());
    (isDark ? dark : light).scaledToWidth(picture_width, Qt::SmoothTransformation).save(file);
  }
}

QPixmap pictureOf(const std::filesystem::path& path, bool dark) { return QPixmap(pictureFile(path, dark)); }

}  // namespace talus
