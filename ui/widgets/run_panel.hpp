#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>
#include <QWidget>

#include "widgets/parts.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// How the run goes: share done, time left, contacts, penetration; what each effect costs and why it is on.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(Workspace& workspace);

 private:
  void refresh();
  void refreshOutcome();
  void addEffect(QVBoxLayout& column, const EffectOutcome& effect, double share, double largest);
  QLabel* addFact(QGridLayout& grid, const QString& name);

  Workspace& workspace_;
  PanelHeader* header_;
  QLabel *percent_, *left_, *spent_;
  QProgressBar* bar_;
  QLabel *time_, *step_, *contacts_, *penetration_, *iterations_;
  QVBoxLayout* outcome_;
};

/// A bar for a share, 0…1.
class ShareBar : public QWidget {
  Q_OBJECT
 public:
  explicit ShareBar(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double share_;
};

}  // namespace talus
