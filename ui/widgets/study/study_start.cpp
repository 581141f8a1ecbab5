#include "widgets/study/study_start.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

constexpr int most_repeats = 1000;

QStringList measureWords() {
  return {QObject::tr("What is expected, else displacements"), QObject::tr("Run-out of the farthest block"),
          QObject::tr("Deposit: where the mass lies"),         QObject::tr("Start of the first block"),
          QObject::tr("End: rest of the last block"),          QObject::tr("Stress at monitors")};
}

/// The first of the words is the usual, the others are in the order of StudyMeasure after displacements.
std::optional<StudyMeasure> measureAt(int index) {
  return index > 0 ? std::optional(static_cast<StudyMeasure>(index)) : std::nullopt;
}

int indexOf(std::optional<StudyMeasure> measure) { return measure ? static_cast<int>(*measure) : 0; }

}  // namespace

StudyStart::StudyStart(ProjectStudy& study, bool asks)
    : study_(study),
      words_(makeWrappedLabel({}, "small")),
      questions_(new QWidget),
      measure_(makeCombo(measureWords(), tr("What errors are of"))),
      repeats_(new NumberField(1, {{}, {}})),
      button_(makeButton({})),
      bar_(makeProgressBar()) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 8);
  column->addWidget(words_);
  addQuestions(*column);
  questions_->setVisible(asks);
  bar_->setAccessibleName(tr("Share of the study that is done"));
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 8);
  row->addWidget(button_);
  row->addWidget(bar_, 1);
  row->addStretch();
  column->addLayout(row);
  button_->setAutoDefault(false);
  connect(button_, &QPushButton::clicked, this, [this] { study_.isBusy() ? study_.cancel() : study_.begin(wish_); });
  connect(&study_, &ProjectStudy::changed, this, &StudyStart::tell);
  connect(&study_, &ProjectStudy::madeAnother, this, &StudyStart::takeWish);
  takeWish();
}

void StudyStart::addQuestions(QLayout& column) {
  auto* rows = new QFormLayout(questions_);
  setMargins(rows, 0, 6);
  measure_->setObjectName(QStringLiteral("studyMeasure"));
  measure_->setToolTip(tr("Each from the finest run. No run is made again for another one"));
  repeats_->setObjectName(QStringLiteral("repeats"));
  repeats_->setAccessibleName(tr("Runs of each setting"));
  repeats_->setMeaning(
      tr("Hardly changed from run to run: errors are of the means, and their scatter is told. Where "
         "blocks hit each other one run says little"));
  repeats_->setFixedWidth(60);
  rows->addRow(tr("Errors of"), measure_);
  rows->addRow(tr("Runs of each setting"), repeats_);
  column.addWidget(questions_);
  connect(measure_, &QComboBox::currentIndexChanged, this, [this](int index) {
    wish_.measure = measureAt(index);
    tell();
  });
  connect(repeats_, &NumberField::committed, this, &StudyStart::takeRepeats);
}

void StudyStart::takeWish() {
  wish_ = study_.wish();
  const QSignalBlocker silent(measure_);
  measure_->setCurrentIndex(indexOf(wish_.measure));
  repeats_->setValue(wish_.repeats);
  tell();
}

void StudyStart::takeRepeats(double repeats) {
  const int least = study_.isCurrent() ? study_.wish().repeats : 1;
  if (repeats != std::round(repeats) || repeats < least || repeats > most_repeats)
    return repeats_->setProblem(tr("A whole number from %1 to %2").arg(least).arg(most_repeats));
  wish_.repeats = static_cast<int>(repeats);
  tell();
}

void StudyStart::tell() {
  bar_->setVisible(study_.isBusy());
  questions_->setEnabled(!study_.isBusy());
  if (study_.isBusy()) return tellHowItGoes();
  const bool current = study_.isCurrent(), outdated = study_.isOutdated();
  words_->setText(outdated   ? tr("The study is of this project before it was changed.")
                  : !current ? tr("What accuracy costs is not known yet. A study solves the project under some twenty "
                                  "settings, from the cheapest to the finest, and tells error and seconds of each.")
                  : study_.isComplete() ? tr("More runs of each setting, or errors of something else:")
                                        : tr("The study was stopped before all of its runs had ended."));
  button_->setText(outdated ? tr("Study again") : current ? tr("Study further") : tr("Study accuracy"));
  const QString whyNot = study_.whyNot(wish_);
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
