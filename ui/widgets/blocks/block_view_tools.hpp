#pragma once

#include <QWidget>

class QComboBox;
class QSlider;

namespace talus {

class BlockColouring;
class Display;

/// How blocks are looked at while the project is set up: what they are coloured by, and how far they are drawn apart.
class BlockViewTools : public QWidget {
  Q_OBJECT
 public:
  BlockViewTools(BlockColouring& colouring, Display& display);

 private:
  void refresh();

  BlockColouring& colouring_;
  Display& display_;
  QComboBox* colours_;
  QSlider* apart_;
};

}  // namespace talus
