#pragma once

#include <QWidget>

#include "widgets/kit/parts.hpp"

class QProgressBar;

namespace talus {

struct Session;

/// What a run will cost, before it; then how it goes: share done, time left, contacts, penetration, blocks asleep;
/// where it has trouble to converge; what each effect costs and why it is on.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(Session& session);

 private:
  void refresh();

  Session& session_;
  PanelHeader* header_;
  QLabel *percent_, *left_, *spent_;
  QProgressBar* bar_;
};

}  // namespace talus
