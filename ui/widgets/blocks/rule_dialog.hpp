#pragma once

#include <QDialog>
#include <vector>

#include "widgets/blocks/rule_form.hpp"

class QComboBox;
class QLabel;
class QPushButton;

namespace talus {

/// Selects blocks by what is known of them; it stays open, so that one rule can follow another. How many blocks a rule
/// means is said at once.
class RuleDialog : public QDialog {
  Q_OBJECT
 public:
  RuleDialog(Session& session, QWidget* parent);
  void present();

 private:
  void refresh();
  void select();
  /// What the selection would be; none while that cannot be told.
  std::optional<std::vector<int>> wouldBe() const;

  Session& session_;
  RuleForm* form_;
  QComboBox* how_;
  QLabel* count_;
  QPushButton* select_;
};

}  // namespace talus
