#pragma once

#include <QWidget>
#include <filesystem>

#include "measures/block_history.hpp"
#include "widgets/kit/plot.hpp"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace talus {

class BlockHistories;
class Messages;
class Playback;

/// What became of the blocks that are selected: two plots of a quantity each, a curve a block. A click or drag in one
/// goes to that moment; both are saved as one table.
class BlockHistoryPanel : public QWidget {
  Q_OBJECT
 public:
  BlockHistoryPanel(BlockHistories& histories, Playback& playback, Messages& messages);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Chart {
    QComboBox* quantity;
    Plot* plot;
    QHBoxLayout* head;  ///< above the plot
  };
  Chart addChart(const QString& name, std::string_view quantity);
  const BlockQuantity& quantityOf(const Chart& chart) const;
  void refresh();
  void fill(const Chart& chart);
  void save();

  BlockHistories& histories_;
  Playback& playback_;
  Messages& messages_;
  QWidget* charts_;
  QLabel* sentence_;
  QPushButton* save_;
  std::vector<Chart> both_;
};

/// The quantity in the user's language: "Contact force".
QString titleOf(const BlockQuantity& quantity);

}  // namespace talus
