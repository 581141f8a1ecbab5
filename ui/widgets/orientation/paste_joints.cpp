#include "widgets/orientation/paste_joints.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "document/document.hpp"
#include "io/whole_file.hpp"
#include "model/solid_shape.hpp"
#include "orientation/dxf_joints.hpp"
#include "orientation/project_joints.hpp"
#include "session/solid_surfaces.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

const QSize usual_dialog_size(1060, 620);
constexpr int text_width = 330;
constexpr double usual_friction = 30;  // degrees, of sets in a project without any joint

QString optional(const std::optional<double>& value) { return value ? numbers::figure(*value, 6) : QString(); }

QStringList cellsOf(const MeasuredJoint& joint) {
  QStringList cells{numbers::figure(joint.plane.dip, 5), numbers::figure(joint.plane.dip_direction, 5),
                    text(joint.set)};
  for (int i = 0; i < 3; ++i) cells << (joint.at ? numbers::figure((*joint.at)[i], 9) : QString());
  return cells << optional(joint.spacing) << optional(joint.persistence);
}

QString wordsOf(const CellProblem& problem) {
  const QString where = problem.column.empty() ? QString() : text(problem.column) + QStringLiteral(": ");
  return where + text(problem.problem) + QStringLiteral("; ") + text(problem.remedy);
}

/// Files have the site's coordinates, the project those from its origin.
void shift(MeasuredJoint& joint, const Vec3& by) {
  if (joint.at) *joint.at += by;
  for (Vec3& corner : joint.corners) corner += by;
}

constexpr int set_column = 4;  // of the preview

/// One line a set, as a table of sets has it; a survey has many.
bool areSets(const std::vector<MeasuredJoint>& joints) {
  std::set<std::string> names;
  return std::ranges::all_of(joints, [&](const MeasuredJoint& one) { return names.insert(one.set).second; });
}

/// Where the reader put each column of the preview, as it names them.
const std::array<const char*, 8> columns{"dip", "dip direction", "set", "x", "y", "z", "spacing", "persistence"};

}  // namespace

PasteJoints::PasteJoints(Document& document, const SolidSurfaces& solids, QWidget* parent)
    : QDialog(parent), document_(document), solids_(solids) {
  setWindowTitle(tr("Paste joints"));
  resizeWithin(*this, usual_dialog_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 0);
  row->addWidget(makeText());
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makePreview(), 1);
  column->addLayout(row, 1);
  column->addWidget(makeFoot());
  read();
}

QWidget* PasteJoints::makeText() {
  auto* plane = makePlane("surface");
  auto* column = new QVBoxLayout(plane);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  column->addWidget(makeLabel(tr("Text"), "section"));
  column->addWidget(makeWrappedLabel(tr("A joint a line: dip, dip direction (or strike), set, x, y, z. With a header "
                                        "or without; tabs, semicolons, commas or blanks."),
                                     "small"));
  text_ = new QPlainTextEdit;
  text_->setObjectName(QStringLiteral("text"));
  text_->setAccessibleName(tr("Text of the table"));
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setPlaceholderText(QStringLiteral("dip\tdip direction\tset\n45\t120\tJ1\n80\t300\tJ2"));
  column->addWidget(text_, 1);
  auto* open = makeButton(tr("Open table or drawing…"));
  open->setAutoDefault(false);
  column->addWidget(open, 0, Qt::AlignLeft);
  plane->setFixedWidth(text_width);
  connect(text_, &QPlainTextEdit::textChanged, this, &PasteJoints::read);
  connect(open, &QPushButton::clicked, this, &PasteJoints::openFile);
  return plane;
}

QWidget* PasteJoints::makePreview() {
  auto* plane = makePlane("surface");
  auto* column = new QVBoxLayout(plane);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  column->addWidget(makeLabel(tr("What is read"), "section"));
  notes_ = makeWrappedLabel({}, "small");
  notes_->setObjectName(QStringLiteral("notes"));
  column->addWidget(notes_);
  preview_ = new PlainTable;
  preview_->setObjectName(QStringLiteral("preview"));
  preview_->setAccessibleName(tr("Joints that were read"));
  column->addWidget(preview_, 1);
  return plane;
}

void PasteJoints::showPlace() {
  clearLayout(*placeRow_->layout());
  placeRow_->layout()->addWidget(makeLabel(tr("Joints without a place go through"), "muted"));
  const char* const names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    auto* field = new NumberField(through_[i], {QStringLiteral("m"), QStringLiteral("m")});
    field->setAccessibleName(tr("Place %1").arg(QLatin1String(names[i])));
    field->setFixedWidth(96);
    connect(field, &NumberField::committed, this, [this, i](double value) { through_[i] = value; });
    placeRow_->layout()->addWidget(field);
  }
}

QWidget* PasteJoints::makeFoot() {
  auto* foot = makePlane("header");
  auto* column = new QVBoxLayout(foot);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(6);
  auto* choices = new QHBoxLayout;
  choices->addWidget(makeLabel(tr("New sets have the strength of"), "muted"));
  strength_ = makeCombo({}, tr("Strength of new sets"));
  strength_->setMinimumWidth(150);
  choices->addWidget(strength_);
  choices->addSpacing(16);
  placeRow_ = new QWidget;
  setMargins(new QHBoxLayout(placeRow_), 0, 6);
  choices->addWidget(placeRow_);
  choices->addStretch();
  column->addLayout(choices);
  spacedRow_ = new QWidget;
  auto* spaced = new QHBoxLayout(spacedRow_);
  setMargins(spaced, 0, 6);
  spaced->addWidget(makeLabel(tr("A line with a spacing becomes"), "muted"));
  spaced_ = makeCombo({tr("parallel planes through all of the rock"), tr("one plane")}, tr("What a spacing makes"));
  spaced_->setObjectName(QStringLiteral("spaced"));
  spaced->addWidget(spaced_);
  spaced->addStretch();
  connect(spaced_, &QComboBox::activated, this, &PasteJoints::showNotes);
  column->addWidget(spacedRow_);
  auto* buttons = new QHBoxLayout;
  refusal_ = makeWrappedLabel({}, "error");
  buttons->addWidget(refusal_, 1);
  auto* cancel = makeButton(tr("Cancel"));
  add_ = makeButton({}, "primary");
  add_->setObjectName(QStringLiteral("add"));
  for (auto* button : {cancel, add_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  column->addLayout(buttons);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(add_, &QPushButton::clicked, this, &PasteJoints::add);
  return foot;
}

void PasteJoints::present() {
  prepare();
  setText(QApplication::clipboard()->text());
  bring();
}

void PasteJoints::presentFile(const std::filesystem::path& file) {
  prepare();
  load(file);
  bring();
}

void PasteJoints::prepare() {
  listStrengths();
  const auto read = solids_.extent();  // files need a moment
  rock_ = read ? read : extent_of(document_.project().solids);
  through_ = rock_ ? Vec3((rock_->min + rock_->max) / 2) : Vec3::Zero();
  showPlace();
}

void PasteJoints::bring() {
  show();
  raise();
  activateWindow();
}

void PasteJoints::setText(const QString& text) { text_->setPlainText(text); }

void PasteJoints::listStrengths() {
  strength_->clear();
  for (const Joint& joint : document_.project().joints) strength_->addItem(text(joint.name));
  strength_->addItem(tr("φ %1°, no cohesion").arg(usual_friction));
}

void PasteJoints::openFile() {
  const QString name = QFileDialog::getOpenFileName(this, tr("Open a table of joints"), {},
                                                    tr("Tables and drawings (*.csv *.tsv *.txt *.dxf);;All files (*)"));
  if (!name.isEmpty()) load(name.toStdString());
}

void PasteJoints::load(const std::filesystem::path& file) {
  try {
    const std::string content = read_whole_file(file);
    if (QString::fromStdString(file.extension().string()).toLower() != QStringLiteral(".dxf")) {
      setText(text(content));
      return;
    }
    JointTable drawing = read_dxf_joints(content);
    for (JointLine& line : drawing.lines)
      if (line.joint) shift(*line.joint, -document_.project().origin);
    text_->setPlainText(tr("# faces of %1").arg(text(file.filename().string())));
    take(std::move(drawing));
  } catch (const InputError& error) {
    refusal_->setText(QString::fromUtf8(error.what()));
  }
}

void PasteJoints::read() { take(read_joint_table(text_->toPlainText().toStdString())); }

void PasteJoints::take(JointTable table) {
  table_ = std::move(table);
  refusal_->clear();
  const std::vector<MeasuredJoint> joints = table_.joints();
  const bool areSpaced = std::ranges::any_of(joints, [](const MeasuredJoint& one) { return one.spacing.has_value(); });
  spacedRow_->setVisible(areSpaced && rock_);
  spaced_->setCurrentIndex(rock_ && areSets(joints) ? 0 : 1);
  showTable();
  showNotes();
  const auto left = table_.lines.size() - joints.size();
  add_->setText(
      left == 0 || joints.empty()
          ? tr("Add %1").arg(numbers::counted(joints.size(), "joint"))
          : tr("Add %1, leave %2 out").arg(numbers::counted(joints.size(), "joint"), numbers::counted(left, "line")));
  add_->setEnabled(!joints.empty());
  placeRow_->setVisible(std::ranges::any_of(joints, [](const MeasuredJoint& joint) { return !joint.at; }));
}

std::optional<BoxShape> PasteJoints::repeatedIn() const { return spaced_->currentIndex() == 0 ? rock_ : std::nullopt; }

void PasteJoints::showTable() {
  std::vector<bool> shown{true, true};
  for (const char* name : columns) shown.push_back(std::ranges::count(table_.columns, name) > 0);
  shown[2] = shown[3] = true;
  QStringList heads{tr("Line"), QString(),  tr("Dip, °"), tr("Direction, °"), tr("Set"),
                    tr("x, m"), tr("y, m"), tr("z, m"),   tr("Spacing, m"),   tr("Persistence, m")};
  std::vector<QStringList> rows;
  for (const JointLine& line : table_.lines) {
    QStringList cells{numbers::whole(line.number)};
    if (line.joint) {
      cells << QString() << cellsOf(*line.joint);
    } else {
      QStringList words;
      for (const CellProblem& problem : line.problems) words << wordsOf(problem);
      cells << (words.isEmpty() ? tr("not read") : words.join(QStringLiteral(" · ")));
    }
    rows.push_back(cells);
  }
  preview_->clearSpans();
  preview_->setContent(heads, rows, {false, true, false, false, true, false, false, false, false, false});
  for (int column = 0; column < preview_->columnCount(); ++column)
    preview_->setColumnHidden(column, column > 3 && !shown[static_cast<std::size_t>(column)]);
  preview_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  preview_->horizontalHeader()->setSectionResizeMode(set_column, QHeaderView::Stretch);
  preview_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Fixed);
  preview_->setColumnWidth(1, 30);
  for (std::size_t row = 0; row < table_.lines.size(); ++row) {
    auto* mark = preview_->item(static_cast<int>(row), 1);
    const bool sound = table_.lines[row].joint.has_value();
    mark->setIcon(theme::icon(sound ? QStringLiteral("check") : QStringLiteral("warning"),
                              sound ? theme::Tone::ok : theme::Tone::error));
    if (sound) continue;
    mark->setForeground(theme::colours().error);
    mark->setToolTip(mark->text());
    preview_->setSpan(static_cast<int>(row), 1, 1, preview_->columnCount() - 1);  // the words need the whole line
  }
}

void PasteJoints::showNotes() {
  QStringList words;
  for (const CellProblem& problem : table_.problems) words << wordsOf(problem);
  const bool faulty = !words.isEmpty();
  for (const std::string& note : table_.notes) words << text(note);
  const std::vector<MeasuredJoint> joints = table_.joints();
  if (std::ranges::any_of(joints, [](const MeasuredJoint& one) { return one.spacing.has_value(); })) {
    int planes = 0;
    for (const Cut& cut : with_joints({}, joints, {}, through_, repeatedIn()).cuts) planes += cut.count.value_or(1);
    words << (repeatedIn() ? tr("with their spacings %1 in the rock")
                                 .arg(numbers::counted(static_cast<std::size_t>(planes), "plane"))
              : rock_ ? tr("spacing is not used: every line becomes one plane")
                      : tr("spacing is not used while there is no rock: every line becomes one plane"));
  }
  if (std::ranges::any_of(joints, [](const MeasuredJoint& one) { return one.persistence.has_value(); }))
    words << tr("persistence is shown but not used: planes have no end");
  if (std::ranges::any_of(joints, [](const MeasuredJoint& one) { return !one.corners.empty(); }))
    words << tr("each joint ends at the corners of its face");
  if (text_->toPlainText().trimmed().isEmpty()) {
    setRole(notes_, "small");
    notes_->setText(
        tr("Copy a table in a spreadsheet and paste it on the left, or open a table or a drawing with "
           "faces (DXF)."));
    return;
  }
  setRole(notes_, faulty ? "error" : "small");
  notes_->setText(words.join(QStringLiteral("\n")));
  notes_->setVisible(!words.isEmpty());
}

void PasteJoints::add() {
  const Project& project = document_.project();
  const std::vector<MeasuredJoint> joints = table_.joints();
  Joint strength;
  const auto chosen = static_cast<std::size_t>(std::max(0, strength_->currentIndex()));
  if (chosen < project.joints.size()) {
    strength = project.joints[chosen];
  } else {
    strength.name = "joint";
    strength.friction_angle = usual_friction;
  }
  try {
    document_.change(with_joints(project, joints, strength, through_, repeatedIn()),
                     tr("paste %1").arg(numbers::counted(joints.size(), "joint")));
    accept();
  } catch (const InputError& error) {
    refusal_->setText(QString::fromUtf8(error.what()));
  }
}

}  // namespace talus
