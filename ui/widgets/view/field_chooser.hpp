#pragma once

#include <QObject>

class QComboBox;

namespace talus {

class Display;

/// What the blocks are coloured by, in two boxes: the quantity ("Block" is a colour a block) and its component.
/// Every pair shows the display's choice, so workflow bar and display panel agree.
class FieldChooser : public QObject {
  Q_OBJECT
 public:
  explicit FieldChooser(Display& display, QObject* parent);
  QComboBox* quantityBox() { return quantity_; }
  QComboBox* componentBox() { return component_; }

 private:
  void show();
  void choose();
  Display& display_;
  QComboBox *quantity_, *component_;
};

}  // namespace talus
