#include "jobs/outside_run.hpp"

#include <signal.h>
#include <unistd.h>

#include <QProcess>
#include <QTemporaryFile>

#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "jobs/study_job.hpp"
#include "results/steps.hpp"
#include "results/text_table.hpp"

namespace talus {

namespace {

constexpr int look_ms = 1000;

QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

void goOnOutside(const OutsideTask& task) {
  const std::filesystem::path program = command_line_program();
  QTemporaryFile project;  // is open in the other process before it goes here
  const QByteArray bytes = QByteArray::fromStdString(task.project_text);
  if (!project.open() || project.write(bytes) != bytes.size() || !project.flush())
    throw InputError(project.fileName().toStdString(), "cannot be written: " + project.errorString().toStdString(),
                     "make room on the disk; the run can go on from its checkpoint");
  QStringList arguments{QStringLiteral("solve"), QStringLiteral("-"), QStringLiteral("--resume"),
                        QStringLiteral("--out"), text(std::filesystem::absolute(task.results))};
  if (const MemoryLimit limit = memory_limit(); limit.told)
    arguments << QStringLiteral("--max-memory") << QString::number(limit.bytes, 'f', 0);
  QProcess process;
  process.setProgram(text(program));
  process.setArguments(arguments);
  process.setWorkingDirectory(text(task.folder));
  process.setStandardInputFile(project.fileName());
  process.setStandardOutputFile(QProcess::nullDevice());
  process.setStandardErrorFile(text(task.results / "background.txt"));
  if (!process.startDetached())
    throw InputError(program.string(), "does not start: " + process.errorString().toStdString(),
                     "install it beside the window; the run can go on from its checkpoint");
}

OutsideRun::OutsideRun(QObject* parent) : QObject(parent) {
  timer_.setInterval(look_ms);
  connect(&timer_, &QTimer::timeout, this, &OutsideRun::look);
}

void OutsideRun::watch(const std::filesystem::path& folder) {
  if (folder == folder_) return;
  folder_ = folder;
  writer_.reset();
  time_ = 0;
  if (folder_.empty()) return timer_.stop();
  timer_.start();
  look();
}

void OutsideRun::look() {
  const bool was = isOn();
  writer_ = writer_of(folder_);
  if (writer_ && writer_->process == getpid()) writer_.reset();
  if (isOn()) {
    const auto row = last_row(folder_ / "steps.csv", steps_header().size());
    time_ = row ? step_report(*row).time : 0;
    emit changed();
  } else if (was) {
    emit ended();
  }
}

void OutsideRun::stop() {
  if (canStop()) ::kill(writer_->process, SIGTERM);
}

}  // namespace talus
