#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "removability/block_rule.hpp"
#include "session/session.hpp"

class QComboBox;
class QFormLayout;

namespace talus {

/// Which blocks are meant: what is asked of them, and the numbers or names that belong to the question.
class RuleForm : public QWidget {
  Q_OBJECT
 public:
  explicit RuleForm(Session& session);
  /// None while a number is missing, or the project has no such thing.
  std::optional<BlockRule> rule() const { return rule_ ? rule_() : std::nullopt; }
  /// Offers joints, materials and solids of the blocks as they were built.
  void refresh();

 signals:
  void changed();

 private:
  void showQuestion();
  void askNumber(const QString& title, const QString& unit, std::function<BlockRule(double)> make);
  void askPlane(Side side);
  void askWay();
  void askBody();
  void askName();
  template <class Named>
  void askWhich(const QString& title, const std::vector<Named>& things, std::function<BlockRule(int)> make);
  void addRow(const QString& title, QWidget* field);
  void pickPlane();

  Session& session_;
  QComboBox* question_;
  QWidget* answers_ = nullptr;
  QFormLayout* rows_ = nullptr;
  std::function<std::optional<BlockRule>()> rule_;
  std::optional<ByPlane> picked_;  ///< the plane through points that were picked in the view
};

}  // namespace talus
