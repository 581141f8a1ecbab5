#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "base/error.hpp"
#include "session/messages.hpp"

namespace talus {

class BackgroundJob;
class Document;

/// What is wrong with the project as it is, all of it and all the time: rules that are broken, files that cannot be
/// read, what is odd. Looked for anew after every change, the files on a thread of their own.
class ProjectProblems : public QObject {
  Q_OBJECT
 public:
  explicit ProjectProblems(Document& document);
  ~ProjectProblems() override;

  /// Errors first, each with its place in the project file.
  const std::vector<Problem>& all() const { return all_; }
  int count(Problem::Severity severity) const;
  /// Why the project cannot be solved as it is, in one sentence; empty when nothing is wrong.
  QString whyNotSolve() const;
  /// The files are being read.
  bool isReading() const;

 signals:
  void changed();

 private:
  /// A file that a solid is read from, as it was when it was looked at.
  struct LookedAt {
    std::filesystem::path file;
    SolidShape shape;
    std::filesystem::file_time_type written;
    bool operator==(const LookedAt&) const = default;
  };
  void look();
  void lookAtFiles();
  std::vector<LookedAt> filesNow() const;

  Document& document_;
  std::vector<Problem> all_;
  std::vector<LookedAt> lookedAt_;
  std::vector<InputError> brokenFiles_;
  QTimer soon_;  ///< one look for changes that come together
  std::unique_ptr<BackgroundJob> job_;
};

}  // namespace talus
