#pragma once

#include <QToolButton>

namespace talus {

class Display;

/// The units that numbers are shown in, and a menu to choose them.
class UnitsButton : public QToolButton {
  Q_OBJECT
 public:
  explicit UnitsButton(Display& display);

 private:
  void fill(QMenu& menu);
  Display& display_;
};

}  // namespace talus
