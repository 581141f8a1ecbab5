#include "widgets/study/study_start.hpp"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "session/project_study.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

StudyStart::StudyStart(ProjectStudy& study)
    : study_(study), words_(makeWrappedLabel({}, "small")), button_(makeButton({})), bar_(makeProgressBar()) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 8);
  column->addWidget(words_);
  bar_->setAccessibleName(tr("Share of the study that is done"));
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 8);
  row->addWidget(button_);
  row->addWidget(bar_, 1);
  row->addStretch();
  column->addLayout(row);
  button_->setAutoDefault(false);
  connect(button_, &QPushButton::clicked, this, [this] { study_.isBusy() ? study_.cancel() : study_.begin(); });
  connect(&study_, &ProjectStudy::changed, this, &StudyStart::tell);
  tell();
}

void StudyStart::tell() {
  bar_->setVisible(study_.isBusy());
  if (study_.isBusy()) return tellHowItGoes();
  const bool outdated = study_.isOutdated();
  words_->setText(outdated ? tr("The study is of this project before it was changed.")
                           : tr("What accuracy costs is not known yet. A study solves the project under some twenty "
                                "settings, from the cheapest to the finest, and tells error and seconds of each."));
  button_->setText(outdated ? tr("Study again") : tr("Study accuracy"));
  const QString whyNot = study_.whyNot();
  button_->setEnabled(whyNot.isEmpty());
  button_->setToolTip(whyNot.isEmpty() ? tr("In the background; it takes many times as long as one run. What it has is "
                                            "kept when it is stopped")
                                       : whyNot);
}

void StudyStart::tellHowItGoes() {
  const auto left = study_.timeLeft().seconds();
  showShare(*bar_, study_.fraction());
  words_->setText(left ? tr("%1; %2 left").arg(study_.activity(), numbers::duration(*left)) : study_.activity());
  button_->setText(tr("Stop"));
  button_->setToolTip(tr("Runs that have ended are kept; the study can go on later"));
  button_->setEnabled(!study_.isStopping());
}

}  // namespace talus
