#include "widgets/results/event_list.hpp"

#include <QHeaderView>
#include <QSignalBlocker>

#include "session/current_run.hpp"
#include "session/playback.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

EventList::EventList(CurrentRun& run, Playback& playback) : run_(run), playback_(playback) {
  setAccessibleName(tr("Events"));
  connect(&run, &CurrentRun::reportChanged, this, &EventList::refresh);
  connect(&playback, &Playback::framesChanged, this, &EventList::refresh);
  connect(&playback, &Playback::frameChanged, this, &EventList::markMoment);
  const auto lead = [this](int row) {
    if (row >= 0) playback_.showTime(run_.events()[static_cast<std::size_t>(row)].time);
  };
  connect(this, &QTableWidget::currentCellChanged, this, lead);
  connect(this, &QTableWidget::cellClicked, this, lead);  // also of the row that is chosen already
  refresh();
}

void EventList::setWanted(bool wanted) {
  wanted_ = wanted;
  refresh();
}

void EventList::refresh() {
  setVisible(wanted_ && !run_.events().empty() && !playback_.times().empty());
  if (isHidden()) return;
  std::vector<QStringList> rows;
  for (const Event& event : run_.events()) rows.push_back({numbers::fixed(event.time, 2), text(event.what)});
  const QSignalBlocker quiet(this);
  setContent({tr("Time s"), tr("Event")}, rows, {false, true});
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  markMoment();
}

int EventList::frameOf(int row) const {
  return nearestFrame(playback_.times(), run_.events()[static_cast<std::size_t>(row)].time);
}

void EventList::markMoment() {
  if (isHidden() || playback_.times().empty() || rowCount() != static_cast<int>(run_.events().size())) return;
  const int now = playback_.number();
  if (currentRow() >= 0 && frameOf(currentRow()) == now) return;  // of several at one moment the one that was chosen
  int last = -1;
  while (last + 1 < rowCount() && frameOf(last + 1) <= now) ++last;
  const QSignalBlocker quiet(this);  // nobody wants to be led anywhere
  setCurrentCell(last, 1);
}

}  // namespace talus
