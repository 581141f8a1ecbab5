#pragma once

#include <QDialog>

#include "verification/verify.hpp"
#include "verification/verify_hard_cases.hpp"

class QTabWidget;

namespace talus {

/// Help → Known answers, Hard cases: the lists that the solver is held to, a tab each. Not modal: the window stays
/// usable, and closing the dialog lets the runs go on.
class Verification : public QDialog {
  Q_OBJECT
 public:
  enum class List { knownAnswers, hardCases };

  Verification(const std::vector<KnownCase>& knownCases, const std::vector<HardCase>& hardCases,
               QWidget* parent = nullptr);
  /// Shows the dialog with this list in front.
  void open(List list);

 private:
  QTabWidget* tabs_;
};

}  // namespace talus
