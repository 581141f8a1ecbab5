#pragma once

#include <QDialog>
#include <vector>

#include "document/recovery.hpp"

class QVBoxLayout;

namespace talus {

/// Asks what is to become of work that was not saved when the program ended: one row a project, with when it was kept.
/// What is neither recovered nor discarded is offered again at the next start.
class RecoveryOffer : public QDialog {
  Q_OBJECT
 public:
  RecoveryOffer(std::vector<Leftover> leftovers, QWidget* parent);

 signals:
  /// The offer closes with it: a window holds one project.
  void recovered(talus::Leftover leftover);

 private:
  void addRow(const Leftover& leftover);

  QVBoxLayout* rows_;
  int left_;
};

}  // namespace talus
