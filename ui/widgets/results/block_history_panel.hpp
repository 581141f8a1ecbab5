#pragma once

#include <filesystem>

#include "measures/block_history.hpp"
#include "widgets/kit/plot.hpp"
#include "widgets/results/explained_panel.hpp"

class QComboBox;
class QHBoxLayout;
class QPushButton;

namespace talus {

class BlockHistories;
class Messages;
class Playback;

/// What became of the blocks that are selected: two plots of a quantity each, a curve a block. A click or drag in one
/// goes to that moment; both are saved as one table.
class BlockHistoryPanel : public ExplainedPanel {
  Q_OBJECT
 public:
  BlockHistoryPanel(BlockHistories& histories, Playback& playback, Messages& messages);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  BlockHistoryPanel(BlockHistories& histories, Playback& playback, Messages& messages, QWidget* charts);
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
  QPushButton* save_;
  std::vector<Chart> both_;
};

/// The quantity in the user's language: "Contact force".
QString titleOf(const BlockQuantity& quantity);

}  // namespace talus
