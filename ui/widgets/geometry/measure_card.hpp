#pragma once

#include <QFrame>

#include "widgets/geometry/measurement.hpp"

class QComboBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace talus {

class Document;

/// A card over the view that measures: what to, what to click next, and what came of it, which can be copied. It asks
/// for places as long as it is there.
class MeasureCard : public QFrame {
  Q_OBJECT
 public:
  MeasureCard(Document& document, Picking& picking, QWidget* view);
  void begin();
  void end();
  const std::vector<MeasuredRow>& rows() const { return rows_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Measured chosen() const;
  void ask();
  void follow();
  void take(const std::vector<PickedPlace>& places);
  void showRows();
  void copy();
  void place();

  Document& document_;
  Picking& picking_;
  std::vector<MeasuredRow> rows_;
  QComboBox* what_;
  QLabel* prompt_;
  QFormLayout* facts_;
  QToolButton* copy_;
};

}  // namespace talus
