#pragma once

#include <QComboBox>

#include "widgets/workspace.hpp"

namespace talus {

/// What the blocks are coloured by, in two boxes: the quantity ("Block" is a colour a block) and its component.
/// Every pair shows the workspace's choice, so step bar and display panel agree.
class FieldChooser : public QObject {
  Q_OBJECT
 public:
  explicit FieldChooser(Workspace& workspace, QObject* parent);
  QComboBox* quantityBox() { return quantity_; }
  QComboBox* componentBox() { return component_; }

 private:
  void show();
  void choose();
  Workspace& workspace_;
  QComboBox *quantity_, *component_;
};

/// A box that does not ask for the width of its longest item.
QComboBox* makeCombo(const QStringList& items, const QString& name);

}  // namespace talus
