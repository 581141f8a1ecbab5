#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace talus {

class BlockSurvey;
class BlockTable;
class CurrentProject;
class Display;
class PlainTable;
class QualityChart;

/// The page of the mesh under the view: a table of blocks with the quality of their tetrahedra, a histogram of it, and
/// the worst ones, which are shown where they are.
class MeshPanel : public QWidget {
  Q_OBJECT
 public:
  MeshPanel(CurrentProject& project, BlockSurvey& survey, Display& display);
  QString title() const;

 signals:
  void titleChanged(const QString& title);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeChart();
  QWidget* makeWorst();
  void refresh();
  void showChart();
  void showWorst();
  void goTo(int row);

  CurrentProject& project_;
  BlockSurvey& survey_;
  Display& display_;
  BlockTable* table_;
  QComboBox* measure_;
  QualityChart* chart_;
  PlainTable* worst_;
};

}  // namespace talus
