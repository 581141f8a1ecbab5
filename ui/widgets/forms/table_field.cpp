#include "widgets/forms/table_field.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QTableWidget>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "document/document.hpp"
#include "document/edits.hpp"
#include "widgets/forms/curve_editor.hpp"
#include "widgets/forms/scalar_fields.hpp"
#include "widgets/kit/display_units.hpp"
#include "widgets/kit/elided_cells.hpp"
#include "widgets/kit/fitted_columns.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plot.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

using schema::Json;

namespace {

constexpr int most_visible = 8, plot_height = 150;
constexpr std::size_t most_rows = 2000;  // longer ones, a surface of triangles, are for files, not for cells

}  // namespace

TableField::TableField(const FieldSite& place, QWidget* parent)
    : FormField(place, parent), rows_(site().isSet() ? *site().value() : Json::array()) {
  makeColumns();
  if (rows_.size() > most_rows) {
    add(makeLabel(tr("%1 rows: too many for a table").arg(rows_.size()), "muted"));
    return;
  }
  makeTable();
  add(table_);
  add(makeTools());
  if (columns_.front().kept == QLatin1String("s") && !rows_.empty()) add(makePlot());
}

void TableField::makeColumns() {
  const Json row = site().element(0).rule;
  oneCell_ = !row.contains("columns");
  if (oneCell_) {
    columns_.push_back({site().title(), {}, {}});
    return;
  }
  const Json units = row.value("units", Json::array()), shown = row.value("shownUnits", Json::array());
  for (std::size_t i = 0; i < row.at("columns").size(); ++i) {
    const QString kept = text(i < units.size() ? units.at(i).get<std::string>() : row.value("unit", std::string()));
    const QString usual = i < shown.size() ? text(shown.at(i).get<std::string>()) : QString();
    columns_.push_back(
        {schema::choiceWords(row.at("columns").at(i).get<std::string>()), kept, units::shown(kept, usual)});
  }
}

QString TableField::cellText(const Json& number, const Column& column) const {
  if (!number.is_number()) return site().element(0).element(0).word("absent");
  const double shown = converted(number.get<double>(), column.kept.toStdString(), column.shown.toStdString());
  return numbers::inField(shown);
}

void TableField::makeTable() {
  table_ = new QTableWidget(static_cast<int>(rows_.size()), static_cast<int>(columns_.size()));
  table_->setObjectName(text(site().place.to_string()));
  table_->setAccessibleName(site().title());
  table_->setShowGrid(true);
  table_->setItemDelegate(new ElidedCells(table_));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(theme::now().metrics.row);
  QStringList heads;
  for (const auto& column : columns_)
    heads << (column.shown.isEmpty() ? column.title : column.title + u' ' + column.shown);
  table_->setHorizontalHeaderLabels(heads);
  for (int i = 0; i < table_->rowCount(); ++i) {
    const Json& row = rows_.at(static_cast<std::size_t>(i));
    QStringList cells;
    for (std::size_t j = 0; j < row.size(); ++j) cells << cellText(row.at(j), columns_[oneCell_ ? 0 : j]);
    if (oneCell_) cells = {cells.join(u' ')};
    for (int j = 0; j < table_->columnCount(); ++j) {
      auto* cell = new QTableWidgetItem(cells.value(j));
      cell->setTextAlignment((oneCell_ ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      table_->setItem(i, j, cell);
    }
  }
  const int lines = std::clamp(table_->rowCount(), 1, most_visible) + 1;
  const auto* columns = new FittedColumns(*table_);
  connect(columns, &FittedColumns::fitted, this, [this, columns, lines] {
    const int bar = columns->isWiderThanItsPlace() ? table_->horizontalScrollBar()->sizeHint().height() : 0;
    table_->setFixedHeight(lines * theme::now().metrics.row + 4 + bar);
  });
  table_->setFixedHeight(lines * theme::now().metrics.row + 4);
  auto* paste = new QShortcut(QKeySequence::Paste, table_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(paste, &QShortcut::activated, this, &TableField::paste);
  connect(table_, &QTableWidget::cellChanged, this, &TableField::commitCell);
}

QWidget* TableField::makeTools() {
  auto* tools = new QWidget(this);
  auto* layout = new QHBoxLayout(tools);
  setMargins(layout, 0, 4);
  const auto tool = [&](const char* icon, const QString& words, const QString& tip, const char* name, auto method) {
    auto* button = makeAction(QLatin1String(icon), words, tip);
    button->setObjectName(text(site().place.to_string()) + QLatin1String(name));
    connect(button, &QToolButton::clicked, this, method);
    layout->addWidget(button);
  };
  tool("plus", tr("Row"), tr("Add a row behind the one with the cursor"), "#add", &TableField::addRow);
  tool("dash", tr("Row"), tr("Take the row with the cursor away"), "#remove", [this] { removeRow(presentRow()); });
  tool("paste", tr("Paste"), tr("Replace all rows by those of the clipboard, copied from a spreadsheet or text"),
       "#paste", &TableField::paste);
  layout->addStretch();
  return tools;
}

std::vector<Curve> TableField::curves() const {
  std::vector<Curve> curves;
  for (std::size_t j = 1; j < columns_.size(); ++j) {
    Curve curve{columns_[j].title, static_cast<int>(j) - 1, {}, {}};
    for (const auto& row : rows_) {
      if (!row.at(0).is_number() || !row.at(j).is_number()) continue;
      curve.x.push_back(row.at(0).get<double>());
      curve.y.push_back(
          converted(row.at(j).get<double>(), columns_[j].kept.toStdString(), columns_[j].shown.toStdString()));
    }
    if (curve.x.size() == rows_.size()) curves.push_back(std::move(curve));
  }
  return curves;
}

QWidget* TableField::makePlot() {
  plot_ = new CurveEditor(site().title());
  plot_->setObjectName(text(site().place.to_string()) + QStringLiteral("#plot"));
  plot_->setFixedHeight(plot_height);
  plot_->setCurves(curves(), columns_.back().shown);
  connect(plot_, &CurveEditor::chosen, this, &TableField::choosePoint);
  connect(plot_, &CurveEditor::inserted, this, &TableField::insertRow);
  connect(plot_, &CurveEditor::removed, this, &TableField::removeRow);
  connect(plot_, &CurveEditor::pasteWanted, this, &TableField::paste);
  connect(plot_, &CurveEditor::dragged, this, [this](int row, int curve, double time, double value) {
    const QSignalBlocker silent(table_);  // the table follows; the project does when the hand lets go
    const Json moved = movedRow(row, curve, time, value);
    for (int j = 0; j < table_->columnCount(); ++j)
      table_->item(row, j)->setText(
          cellText(moved.at(static_cast<std::size_t>(j)), columns_[static_cast<std::size_t>(j)]));
  });
  connect(plot_, &CurveEditor::moved, this, [this](int row, int curve, double time, double value) {
    Json changed = rows_;
    changed[static_cast<std::size_t>(row)] = movedRow(row, curve, time, value);
    put(changed);
  });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int column) {
    const QSignalBlocker silent(plot_);
    plot_->choose(row, std::max(0, column - 1));
    site().context.chosen = {site().place, row, std::max(0, column - 1)};
  });
  const TablePoint& before = site().context.chosen;
  if (before.table == site().place && before.row >= 0 && before.row < table_->rowCount())
    table_->setCurrentCell(before.row, before.curve + 1);
  return plot_;
}

schema::Json TableField::movedRow(int row, int curve, double time, double value) const {
  const Column& column = columns_[static_cast<std::size_t>(curve) + 1];
  Json moved = rows_.at(static_cast<std::size_t>(row));
  moved[0] = jsonOf(time);
  moved[static_cast<std::size_t>(curve) + 1] =
      jsonOf(converted(value, column.shown.toStdString(), column.kept.toStdString()));
  return moved;
}

void TableField::choosePoint(int row, int curve) { table_->setCurrentCell(row, curve + 1); }

schema::Json TableField::cellValue(const QString& typed, const Column& column) const {
  const FieldSite cell = site().element(0).element(0);
  const bool mayBeNull = cell.rule.at("type").is_array();
  if (mayBeNull && (typed.trimmed().isEmpty() || typed == cell.word("absent"))) return nullptr;
  return jsonOf(read_quantity(typed.toStdString(), column.kept.toStdString(), column.shown.toStdString()));
}

schema::Json TableField::rowValue(const QStringList& cells) const {
  Json row = Json::array();
  static const QRegularExpression gaps(QStringLiteral("[\\s,;]+"));
  const QStringList parts = oneCell_ ? cells.value(0).split(gaps, Qt::SkipEmptyParts) : cells;
  for (int j = 0; j < parts.size(); ++j)
    row.push_back(cellValue(
        parts[j], columns_[oneCell_ ? 0 : std::min<std::size_t>(static_cast<std::size_t>(j), columns_.size() - 1)]));
  return row;
}

void TableField::commitCell(int row, int) {
  QStringList cells;
  for (int j = 0; j < table_->columnCount(); ++j) cells << table_->item(row, j)->text();
  try {
    Json changed = rows_;
    changed[static_cast<std::size_t>(row)] = rowValue(cells);
    put(changed);
  } catch (const InputError& error) {
    say(tr("row %1: %2; %3").arg(row + 1).arg(text(error.problem()), text(error.remedy())));
  }
}

void TableField::paste() {
  static const QRegularExpression lines(QStringLiteral("[\\r\\n]+")), gaps(QStringLiteral("[\\t;]+|\\s+"));
  Json pasted = Json::array();
  int number = 0;
  try {
    for (const QString& line : QApplication::clipboard()->text().split(lines, Qt::SkipEmptyParts)) {
      ++number;
      const QStringList cells = line.trimmed().split(gaps, Qt::SkipEmptyParts);
      const bool head = number == 1 && !cells.isEmpty() && cells[0][0].isLetter();
      if (head || cells.isEmpty()) continue;
      if (!oneCell_ && cells.size() != static_cast<int>(columns_.size()))
        return say(tr("line %1 of what was copied has %2 numbers; %3 are wanted")
                       .arg(number)
                       .arg(cells.size())
                       .arg(columns_.size()));
      pasted.push_back(rowValue(oneCell_ ? QStringList{cells.join(u' ')} : cells));
    }
  } catch (const InputError& error) {
    return say(tr("line %1 of what was copied: %2").arg(number).arg(text(error.problem())));
  }
  if (pasted.empty()) return say(tr("nothing was copied that is a table of numbers"));
  put(pasted);
}

int TableField::presentRow() const { return table_->currentRow() < 0 ? table_->rowCount() - 1 : table_->currentRow(); }

void TableField::addRow() {
  const int present = presentRow();
  // A time table goes on with the next moment: rows must ascend.
  if (plot_) {
    const auto time = [&](int row) { return rows_.at(static_cast<std::size_t>(row)).at(0).get<double>(); };
    const bool last = present + 1 == table_->rowCount();
    return insertRow(last ? time(present) + 1 : (time(present) + time(present + 1)) / 2);
  }
  Json changed = rows_;
  changed.insert(changed.begin() + present + 1,
                 rows_.empty() ? edits::startOf(site().element(0).rule, site().context.document.json())
                               : rows_.at(static_cast<std::size_t>(present)));
  put(changed);
}

void TableField::insertRow(double time) {
  std::size_t after = 0;
  while (after < rows_.size() && rows_.at(after).at(0).get<double>() < time) ++after;
  Json row = rows_.at(after < rows_.size() ? after : rows_.size() - 1);
  row[0] = jsonOf(time);
  for (const Curve& curve : curves()) {
    const auto value = valueAt(curve, time);
    if (!value) continue;
    const Column& column = columns_[static_cast<std::size_t>(curve.colour) + 1];
    row[static_cast<std::size_t>(curve.colour) + 1] =
        jsonOf(converted(*value, column.shown.toStdString(), column.kept.toStdString()));
  }
  Json changed = rows_;
  changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(after), row);
  site().context.chosen = {site().place, static_cast<int>(after), std::max(0, site().context.chosen.curve)};
  put(changed);
}

void TableField::removeRow(int row) {
  if (row < 0 || row >= static_cast<int>(rows_.size())) return;
  Json changed = rows_;
  changed.erase(static_cast<std::size_t>(row));
  put(changed);
}

}  // namespace talus
