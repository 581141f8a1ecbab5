#pragma once

#include <QDialog>
#include <QTabWidget>

#include "study/verify.hpp"
#include "study/verify_stability.hpp"

namespace talus {

/// Help → Known answers, Stability: the lists that the solver is held to, a tab each. Not modal: the window stays
/// usable, and closing the dialog lets the runs go on.
class Verification : public QDialog {
  Q_OBJECT
 public:
  enum class List { knownAnswers, stability };

  Verification(std::vector<KnownCase> cases, std::vector<StabilityScene> scenes, QWidget* parent = nullptr);
  /// Shows the dialog with this list in front.
  void open(List list);

 private:
  QTabWidget* tabs_;
};

}  // namespace talus
