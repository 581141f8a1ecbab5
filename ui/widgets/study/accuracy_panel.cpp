#include "widgets/study/accuracy_panel.hpp"

#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "base/error.hpp"
#include "jobs/solver_job.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "study/accuracy/choice.hpp"
#include "widgets/kit/fitted_columns.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/study/study_start.hpp"

namespace talus {

namespace {

const QSize accuracy_size(1240, 800);
constexpr int orders_width = 450;  // the orders of convergence whole

QString errorOf(const AccuracyRow& row) {
  if (!row.error) return text(ending_text(row));
  const QString error = text(error_text(*row.error));
  const QString whole =
      row.error_estimate > 0 ? QObject::tr("%1 ± %2").arg(error, text(error_text(row.error_estimate))) : error;
  return row.spread ? QObject::tr("%1, spread %2").arg(whole, text(error_text(*row.spread))) : whole;
}

QString secondsOf(const AccuracyRow& row) {
  return row.run ? numbers::significant(row.run->cpu_seconds) : QStringLiteral("–");
}

QString nameOf(StudyAxis axis) {
  if (axis == StudyAxis::mesh_size) return QObject::tr("mesh size");
  if (axis == StudyAxis::contact_stiffness) return QObject::tr("softness of contacts");
  return axis == StudyAxis::time_step ? QObject::tr("time step") : QObject::tr("static step");
}

QString heldTo(const AccuracyStudy& study) {
  return study.known_answer ? QObject::tr("the known answer") : QObject::tr("run %1, the finest").arg(study.reference);
}

/// Nothing of a study of what studies usually are of.
QString measuredOf(const AccuracyStudy& study) {
  if (study.known_answer || study.measure == StudyMeasure::displacement) return {};
  return QObject::tr("; measured: %1").arg(text(to_string(study.measure)));
}

/// Nothing of a study that made each run once.
QString repeatsOf(const AccuracyStudy& study) {
  if (study.repeats == 1) return {};
  const QString mean = QObject::tr("; mean of %1 runs ± spread").arg(study.repeats);
  return study.told_apart.value_or(true) ? mean : mean + QObject::tr("; no better setting can be told apart");
}

}  // namespace

AccuracyPanel::AccuracyPanel(CurrentProject& project, CurrentRun& run, ProjectStudy& study, QWidget* parent)
    : QDialog(parent), project_(project), run_(run) {
  setWindowTitle(tr("Accuracy"));
  resizeWithin(*this, accuracy_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  column->addWidget(makeHeading());
  column->addWidget(empty_ = makeEmpty(study), 1);
  content_ = new QWidget;
  auto* row = new QHBoxLayout(content_);
  setMargins(row, 0, 0);
  row->addWidget(makeRuns(), 1);
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeSide(study));
  column->addWidget(content_, 1);
  connect(&project_, &CurrentProject::studyChanged, this, &AccuracyPanel::showProjectsStudy);
  connect(&project_.document(), &Document::projectChanged, this, &AccuracyPanel::refreshUse);
  connect(&run_.job(), &SolverJob::stateChanged, this, &AccuracyPanel::refreshUse);
  showProjectsStudy();
}

QWidget* AccuracyPanel::makeHeading() {
  auto* heading = makePlane("header");
  auto* row = new QHBoxLayout(heading);
  row->setContentsMargins(12, 8, 12, 8);
  auto* words = new QVBoxLayout;
  setMargins(words, 0, 2);
  title_ = makeLabel({}, "title");
  note_ = makeLabel({}, "small");
  words->addWidget(title_);
  words->addWidget(note_);
  row->addLayout(words, 1);
  auto* openFile = makeButton(tr("Open…"));
  openFile->setAutoDefault(false);  // or Return in the target would ask for a file
  openFile->setToolTip(tr("Another study's accuracy.json"));
  connect(openFile, &QPushButton::clicked, this, &AccuracyPanel::askForFile);
  row->addWidget(openFile);
  return heading;
}

/// What is there instead of a study: what makes one.
QWidget* AccuracyPanel::makeEmpty(ProjectStudy& study) {
  auto* whole = new QWidget;
  auto* column = new QVBoxLayout(whole);
  auto* start = new StudyStart(study, true);
  start->setFixedWidth(orders_width);
  column->addWidget(start, 0, Qt::AlignCenter);
  return whole;
}

QWidget* AccuracyPanel::makeRuns() {
  auto* whole = new QWidget;
  auto* column = new QVBoxLayout(whole);
  setMargins(column, 0, 0);
  chart_ = new AccuracyChart;
  runs_ = new PlainTable;
  runs_->setObjectName(QStringLiteral("runs"));
  runs_->setAccessibleName(tr("Runs of the study"));
  new FittedColumns(*runs_);
  column->addWidget(chart_, 3);
  column->addWidget(makeLine(Qt::Horizontal));
  column->addWidget(runs_, 2);
  connect(chart_, &AccuracyChart::chosen, this, &AccuracyPanel::choose);
  connect(runs_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0) choose(row);
  });
  return whole;
}

QWidget* AccuracyPanel::makeSide(ProjectStudy& study) {
  auto* whole = new QWidget;
  auto* column = new QVBoxLayout(whole);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  column->addWidget(makeLabel(tr("What is good enough"), "section"));
  auto* asked = new QHBoxLayout;
  asked->addWidget(makeLabel(tr("Error of at most"), "muted"));
  target_ = new QLineEdit;
  target_->setObjectName(QStringLiteral("target"));
  target_->setPlaceholderText(tr("1 %"));
  target_->setFixedWidth(90);
  asked->addWidget(target_);
  asked->addStretch();
  column->addLayout(asked);
  recommended_ = makeWrappedLabel({}, "muted");
  recommended_->setObjectName(QStringLiteral("recommended"));
  column->addWidget(recommended_);
  column->addSpacing(8);
  auto* ofProject = new QVBoxLayout(further_ = new QWidget);
  setMargins(ofProject, 0, 6);
  ofProject->addWidget(makeLabel(tr("The study"), "section"));
  ofProject->addWidget(new StudyStart(study, true));
  column->addWidget(further_);
  column->addSpacing(8);
  column->addWidget(makeLabel(tr("Chosen run"), "section"));
  chosen_ = makeWrappedLabel({}, "muted");
  column->addWidget(chosen_);
  use_ = makeButton(tr("Use this setting"), "primary");
  use_->setAutoDefault(false);
  column->addWidget(use_, 0, Qt::AlignLeft);
  profile_ = new RunProfile;
  column->addWidget(profile_);
  column->addSpacing(8);
  ordersTitle_ = makeLabel(tr("Orders of convergence"), "section");
  column->addWidget(ordersTitle_);
  orders_ = new PlainTable;
  orders_->setObjectName(QStringLiteral("orders"));
  orders_->setSelectionMode(QAbstractItemView::NoSelection);
  new FittedColumns(*orders_);
  column->addWidget(orders_);
  column->addStretch();
  connect(target_, &QLineEdit::editingFinished, this, &AccuracyPanel::setTarget);
  connect(use_, &QPushButton::clicked, this, [this] { project_.useSetting(*record_, *chosenRun_); });
  auto* scrolled = makeScrolled(whole);
  scrolled->setFixedWidth(orders_width);
  return scrolled;
}

void AccuracyPanel::present() {
  project_.lookForStudy();
  if (!record_) showProjectsStudy();
  QDialog::show();
  raise();
  activateWindow();
}

void AccuracyPanel::askForFile() {
  const QString name = QFileDialog::getOpenFileName(this, tr("Open an accuracy study"), {}, tr("Studies (*.json)"));
  if (!name.isEmpty()) load(name.toStdString());
}

void AccuracyPanel::load(const std::filesystem::path& file) {
  try {
    show(read_accuracy_file(file));
  } catch (const InputError& error) {
    show(std::nullopt);
    note_->setText(text(error.what()));
  }
}

void AccuracyPanel::showProjectsStudy() { show(project_.study() ? std::optional(*project_.study()) : std::nullopt); }

void AccuracyPanel::show(std::optional<StudyRecord> record) {
  record_ = std::move(record);
  chosenRun_.reset();
  content_->setVisible(record_.has_value());
  empty_->setVisible(!record_);
  further_->setVisible(record_ && project_.study() && record_->place == project_.study()->place);
  if (!record_) {
    title_->setText(tr("There is no study of this project"));
    note_->setText(tr("Open… shows another one; talus-cli study accuracy PROJECT makes one, too"));
    return;
  }
  title_->setText(tr("%1: what accuracy costs").arg(text(record_->study.project_name)));
  note_->setText(tr("%1, errors from %2").arg(text(record_->place.string()), heldTo(record_->study)) +
                 measuredOf(record_->study) + repeatsOf(record_->study));
  chart_->show(record_->study);
  showRuns();
  showOrders();
  tellRecommended();
  choose(run_of(*record_, project_.document().project()).value_or(0));
}

void AccuracyPanel::showRuns() {
  std::vector<QStringList> rows;
  for (std::size_t i = 0; i < record_->study.rows.size(); ++i) {
    const AccuracyRow& row = record_->study.rows[i];
    const StudyRun run = row.run.value_or(StudyRun{});
    rows.push_back({QString::number(i), text(row.label), row.pareto ? tr("best") : QString(), errorOf(row),
                    secondsOf(row), numbers::whole(run.dofs), numbers::whole(run.steps),
                    numbers::whole(run.iterations)});
  }
  const QSignalBlocker silent(runs_);
  runs_->setContent({tr("Run"), tr("Setting"), tr("For its cost"), tr("Error"), tr("CPU s"), tr("Unknowns"),
                     tr("Steps"), tr("Iterations")},
                    rows, {true, true, true, false, false, false, false, false});
}

void AccuracyPanel::showOrders() {
  std::vector<QStringList> rows;
  for (const AxisOrder& order : record_->study.orders) {
    const bool has = order.fit.convergence == Convergence::converging;
    rows.push_back({nameOf(order.axis), text(to_string(order.fit.convergence)),
                    has ? numbers::significant(order.fit.order) : QStringLiteral("–"),
                    order.theory ? numbers::figure(*order.theory, 2) : QStringLiteral("–"),
                    text(error_text(order.fit.finest_error))});
  }
  orders_->setContent({tr("Along"), tr("Runs are"), tr("Order"), tr("Theory"), tr("Finest off by")}, rows,
                      {true, true, false, false, false});
  orders_->fitHeight(orders_->rowCount());
  orders_->setVisible(!rows.empty());
  ordersTitle_->setVisible(!rows.empty());
}

void AccuracyPanel::setTarget() {
  if (!record_) return;
  try {
    const auto target = target_->text().trimmed().isEmpty()
                            ? std::nullopt
                            : std::optional<double>(parse_target(target_->text().trimmed().toStdString()));
    set_target(record_->study, target);
    chart_->show(record_->study);
    tellRecommended();
    if (record_->study.recommended >= 0) choose(record_->study.recommended);
  } catch (const InputError& error) {
    recommended_->setText(text(error.what()));
  }
}

void AccuracyPanel::tellRecommended() {
  const AccuracyStudy& study = record_->study;
  if (!study.target)
    recommended_->setText(tr("Type an error to meet, and the cheapest run that does is chosen."));
  else if (study.recommended < 0)
    recommended_->setText(tr("No run of this study is within %1.").arg(text(error_text(*study.target))));
  else
    recommended_->setText(
        tr("Run %1 is the cheapest within %2.").arg(study.recommended).arg(text(error_text(*study.target))));
}

void AccuracyPanel::choose(int run) {
  chosenRun_ = run;
  const AccuracyRow& row = record_->study.rows[static_cast<std::size_t>(run)];
  chart_->setChosen(run);
  const QSignalBlocker silent(runs_);
  runs_->setCurrentCell(run, 0);
  const QString note = row.note.empty() ? QString() : u'\n' + text(row.note);
  chosen_->setText(tr("Run %1: %2\n%3 s, error %4").arg(run).arg(text(row.label), secondsOf(row), errorOf(row)) + note);
  profile_->setVisible(row.run.has_value());
  if (row.run) profile_->show(*row.run);
  refreshUse();
}

void AccuracyPanel::refreshUse() {
  if (!record_ || !chosenRun_) return;
  const auto has = run_of(*record_, project_.document().project());
  const QString whyNot = run_.job().isBusy() ? tr("A run goes on")
                         : !record_->project ? tr("The study came without its project")
                         : !has ? tr("The study is of another project, or of this one before it was changed")
                         : *has == *chosenRun_ ? tr("The project has this setting")
                                               : QString();
  use_->setEnabled(whyNot.isEmpty());
  use_->setToolTip(whyNot);
}

}  // namespace talus
