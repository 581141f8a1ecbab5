#include "document/recovery.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QUuid>
#include <algorithm>
#include <optional>

#include "base/error.hpp"

namespace talus {

namespace {

QString pathText(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

std::filesystem::path pathOf(const QJsonValue& value) { return value.toString().toStdString(); }

QString lockOf(const QString& file) { return file + QStringLiteral(".lock"); }

/// The lock of a file, held; null where a living process has it.
std::shared_ptr<QLockFile> held(const QString& file) {
  auto lock = std::make_shared<QLockFile>(lockOf(file));
  lock->setStaleLockTime(0);  // age says nothing: only a process that is gone lets go
  return lock->tryLock(0) ? lock : nullptr;
}

std::optional<Leftover> read(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
  if (!json.contains(QStringLiteral("text"))) return std::nullopt;
  Leftover found;
  found.draft.text = json[QStringLiteral("text")].toString().toStdString();
  found.draft.file = pathOf(json[QStringLiteral("file")]);
  found.draft.folder = pathOf(json[QStringLiteral("folder")]);
  found.name = json[QStringLiteral("name")].toString();
  found.when = QDateTime::fromString(json[QStringLiteral("when")].toString(), Qt::ISODate);
  found.path = path;
  return found;
}

}  // namespace

std::filesystem::path recoveryFolder() {
  const QString state = qEnvironmentVariable("XDG_STATE_HOME");
  const QString base = state.isEmpty() ? QDir::homePath() + QStringLiteral("/.local/state") : state;
  return (base + u'/' + QCoreApplication::applicationName() + QStringLiteral("/recovery")).toStdString();
}

RecoverySlot::RecoverySlot(const std::filesystem::path& folder) {
  QDir().mkpath(pathText(folder));
  file_ = pathText(folder) + u'/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + QStringLiteral(".json");
  lock_ = std::make_unique<QLockFile>(lockOf(file_));
  lock_->setStaleLockTime(0);
  lock_->tryLock(0);
}

RecoverySlot::~RecoverySlot() { clear(); }

void RecoverySlot::keep(const Draft& draft, const QString& name) {
  const QJsonObject json{{QStringLiteral("text"), QString::fromStdString(draft.text)},
                         {QStringLiteral("file"), pathText(draft.file)},
                         {QStringLiteral("folder"), pathText(draft.folder)},
                         {QStringLiteral("name"), name},
                         {QStringLiteral("when"), QDateTime::currentDateTime().toString(Qt::ISODate)}};
  QSaveFile file(file_);
  const bool open = file.open(QIODevice::WriteOnly);
  if (open) file.write(QJsonDocument(json).toJson());
  if (!open || !file.commit())
    throw InputError(file_.toStdString(), "unsaved work cannot be kept here: " + file.errorString().toStdString(),
                     "save the project yourself, and see to space and permissions of this folder");
}

void RecoverySlot::clear() { QFile::remove(file_); }

bool RecoverySlot::isEmpty() const { return !QFile::exists(file_); }

void Leftover::discard() const {
  QFile::remove(path);
  lock->unlock();
}

std::vector<Leftover> leftovers(const std::filesystem::path& folder) {
  std::vector<Leftover> found;
  const QDir directory(pathText(folder));
  for (const QString& name : directory.entryList({QStringLiteral("*.json")}, QDir::Files)) {
    const QString path = directory.filePath(name);
    auto lock = held(path);
    if (!lock) continue;
    if (auto leftover = read(path)) {
      leftover->lock = std::move(lock);
      found.push_back(std::move(*leftover));
    }
  }
  std::sort(found.begin(), found.end(), [](const Leftover& a, const Leftover& b) { return a.when > b.when; });
  return found;
}

}  // namespace talus
