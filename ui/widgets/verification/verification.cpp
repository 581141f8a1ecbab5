#include "widgets/verification/verification.hpp"

#include <QTabBar>
#include <QTabWidget>

#include "widgets/verification/hard_case_list.hpp"
#include "widgets/verification/known_answers.hpp"

namespace talus {

namespace {
const QSize verification_size(1240, 760);
}  // namespace

Verification::Verification(const std::vector<KnownCase>& knownCases, const std::vector<HardCase>& hardCases,
                           QWidget* parent)
    : QDialog(parent), tabs_(new QTabWidget) {
  setWindowTitle(tr("Known answers and hard cases"));
  resizeWithin(*this, verification_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setExpanding(false);
  tabs_->addTab(new KnownAnswers(knownCases), tr("Known answers"));
  tabs_->addTab(new HardCaseList(hardCases), tr("Hard cases"));
  column->addWidget(tabs_);
}

void Verification::open(List list) {
  tabs_->setCurrentIndex(static_cast<int>(list));
  show();
  raise();
  activateWindow();
}

}  // namespace talus
