#pragma once

#include <QWidget>
#include <vector>

#include "widgets/parts.hpp"
#include "widgets/workspace.hpp"

namespace talus {

class StruggleRow;

/// Where the run struggles, place by place: blocks, joint, what it took, what to change, and a button that turns the
/// view there. Takes no room while there is nothing to say.
class StrugglePanel : public QWidget {
  Q_OBJECT
 public:
  explicit StrugglePanel(Workspace& workspace);

 private:
  void refresh();
  Workspace& workspace_;
  QLabel* heading_;
  QVBoxLayout* column_;
  std::vector<StruggleRow*> rows_;  ///< kept: a button must not go from under the hand that clicks it
};

/// One of its places.
class StruggleRow : public QWidget {
  Q_OBJECT
 public:
  StruggleRow();
  void show(const Struggle& struggle);

 signals:
  void wanted(const talus::Struggle& struggle);

 private:
  Struggle struggle_;
  ElidedLabel* contact_;
  QLabel *cost_, *advice_;
};

}  // namespace talus
