#pragma once

#include <QWidget>

#include "widgets/kit/number_field.hpp"
#include "widgets/kit/painting_view.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/plot.hpp"

class QLabel;

namespace talus {

class Display;
class MeasuredSlide;
class Playback;

/// What the slide has come to at its end: run-out, travel angle and deposit in numbers, a map of the deposit, and the
/// velocity of the front, in which a click goes to that moment.
class SlidePanel : public QWidget {
  Q_OBJECT
 public:
  SlidePanel(MeasuredSlide& slide, Playback& playback, Display& display);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refresh();
  void showFront();
  std::vector<QStringList> facts() const;

  MeasuredSlide& slide_;
  Playback& playback_;
  Display& display_;
  NumberField* moved_;
  QLabel* sentence_;
  PlainTable* facts_;
  PaintingView* map_;
  Plot* front_;
};

}  // namespace talus
