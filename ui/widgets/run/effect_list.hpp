#pragma once

#include <QWidget>
#include <tuple>

class QLabel;
class QVBoxLayout;

namespace talus {

class CurrentRun;
class ShareBar;

/// All effects, on and off, and why: before a run what each is to be paid for and about how much, then the seconds that
/// it took.
class EffectList : public QWidget {
  Q_OBJECT
 public:
  explicit EffectList(CurrentRun& run);

 private:
  struct Row {
    QString name, reason, items, cost;
    bool active = false;
    double share = 0;  ///< of the dearest
    auto words() const { return std::tie(name, reason, items, active); }
  };
  struct Cost {
    QLabel* words;
    ShareBar* bar;  ///< none of an effect that is off
  };
  std::vector<Row> expected() const;
  std::vector<Row> spent() const;
  void refresh();
  void addHeading(const QString& unit);
  void addRow(const Row& row);
  /// What grows while a run goes on; the rows stay, so that the panel is not laid out anew.
  void showCosts();

  CurrentRun& run_;
  std::vector<Row> rows_;    ///< as they are shown
  std::vector<Cost> costs_;  ///< one a row
  bool showsSpent_ = false;  ///< what a run has told; else what is estimated
  QVBoxLayout* column_;
};

/// A bar for a share, 0…1.
class ShareBar : public QWidget {
  Q_OBJECT
 public:
  ShareBar();
  void setShare(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double share_ = 0;
};

}  // namespace talus
