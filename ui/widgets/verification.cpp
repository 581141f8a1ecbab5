#include "widgets/verification.hpp"

#include <QTabBar>

#include "widgets/known_answers.hpp"
#include "widgets/stability_list.hpp"

namespace talus {

namespace {
const QSize usual_size(1240, 760);
}  // namespace

Verification::Verification(std::vector<KnownCase> cases, std::vector<StabilityScene> scenes, QWidget* parent)
    : QDialog(parent), tabs_(new QTabWidget) {
  setWindowTitle(tr("Known answers and stability"));
  resize(usual_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setExpanding(false);
  tabs_->addTab(new KnownAnswers(std::move(cases)), tr("Known answers"));
  tabs_->addTab(new StabilityList(std::move(scenes)), tr("Stability"));
  column->addWidget(tabs_);
}

void Verification::open(List list) {
  tabs_->setCurrentIndex(static_cast<int>(list));
  show();
  raise();
  activateWindow();
}

}  // namespace talus
