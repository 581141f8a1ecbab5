#pragma once

#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace talus {

class BlockTable;
class PlainTable;
class QualityChart;
struct PickedPlace;
struct Session;

/// The page of the mesh under the view: what meshing anew would come to, a table of blocks with the quality of their
/// tetrahedra, a histogram of it, and the worst ones, which are shown where they are.
class MeshPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MeshPanel(Session& session);
  QString title() const;

 signals:
  void titleChanged(const QString& title);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeChart();
  QWidget* makeWorst();
  void refresh();
  void showChart();
  void showWorst();
  void showAhead();
  void goTo(int row);
  /// Where there is rock to refine the mesh of.
  void offerRefining();
  /// Makes the mesh finer near what was picked, or near the whole flat face there.
  void refineAt(const PickedPlace& place, bool wholeFace);

  Session& session_;
  std::vector<std::pair<QToolButton*, QString>> refining_;  ///< with what each does
  BlockTable* table_;
  QLabel* ahead_;  ///< what meshing anew would come to
  QComboBox* measure_;
  QualityChart* chart_;
  PlainTable* worst_;
};

}  // namespace talus
