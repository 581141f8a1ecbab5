#pragma once

#include <QWidget>

class QVBoxLayout;

namespace talus {

class CurrentRun;

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
    bool operator==(const Row&) const = default;
  };
  std::vector<Row> expected() const;
  std::vector<Row> spent() const;
  void refresh();
  void addHeading(const QString& unit);
  void addRow(const Row& row);

  CurrentRun& run_;
  std::vector<Row> rows_;  ///< as they are shown
  QVBoxLayout* column_;
};

/// A bar for a share, 0…1.
class ShareBar : public QWidget {
  Q_OBJECT
 public:
  explicit ShareBar(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double share_;
};

}  // namespace talus
