#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "jobs/background_job.hpp"
#include "model/project.hpp"

namespace talus {

/// What a project will be cut into, as a picture that follows it: cut, meshed and drawn in the background a moment
/// after the last change. The picture before stays until then.
class ProjectPreview : public QWidget {
  Q_OBJECT
 public:
  ProjectPreview();
  /// Nothing where the project is empty.
  void setProject(std::optional<Project> project);
  /// Drawn is what was last asked for.
  bool isUpToDate() const { return !stale_ && !job_.isBusy(); }
  const QImage& picture() const { return drawn_.picture; }

  /// What came of drawing a project: a picture, or why there is none.
  struct Drawn {
    QImage picture;
    QString problem;
    int blocks = 0;
  };

 signals:
  /// A picture, or a problem, has come.
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void askAgain();
  void draw();

  std::optional<Project> project_;
  Drawn drawn_;
  bool stale_ = false;
  QTimer pause_;  ///< between the last change and drawing
  BackgroundJob job_;
};

}  // namespace talus
