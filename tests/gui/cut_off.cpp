#include "cut_off.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyleOption>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

constexpr int rounding = 1;      // pixels
constexpr int most_digits = 12;  // of a number that its entry must show whole

class Finder {
 public:
  /// A dialog over a window of that size.
  void look(const QWidget& dialog, const QSize& window) {
    if (!QRect({}, window).contains(QRect({}, dialog.size())))
      say(dialog, dialog.windowTitle(), QStringLiteral("is larger than the window"));
    look(dialog);
  }
  void look(const QWidget& widget) {
    if (!widget.isVisible() || widget.visibleRegion().isEmpty()) return;
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) lookAtLabel(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) lookAtButton(*button);
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) lookAtBox(*box);
    if (const auto* entry = qobject_cast<const QLineEdit*>(&widget)) lookAtEntry(*entry);
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) lookAtTabs(*tabs);
    if (const auto* table = qobject_cast<const QTableView*>(&widget)) lookAtTable(*table);
    lookAtLayout(widget);
    for (const QObject* child : widget.children())
      if (const auto* part = qobject_cast<const QWidget*>(child); part && !part->isWindow()) look(*part);
  }
  const std::vector<std::string>& found() const { return found_; }

 private:
  void say(const QWidget& widget, const QString& words, const QString& what) {
    QString where = widget.objectName();
    for (const QWidget* around = &widget; where.isEmpty() && around; around = around->parentWidget())
      where = QString::fromLatin1(around->metaObject()->className());
    found_.push_back(QStringLiteral("\"%1\" %2 (%3)").arg(words, what, where).toStdString());
  }

  /// Names, paths and messages, which have no bound; a tooltip has them whole.
  static bool tellsWhatIsLong(const QWidget& label) {
    for (const QWidget* around = &label; around; around = around->parentWidget())
      for (const char* place :
           {"QStatusBar", "talus::PanelHeader", "talus::RecoveryOffer", "talus::StartPage", "talus::AccuracyPanel"})
        if (around->inherits(place)) return true;
    return false;
  }

  void lookAtLabel(const QLabel& label) {
    if (label.text().isEmpty()) return;
    if (label.inherits("talus::ElidedLabel")) {
      if (label.fontMetrics().horizontalAdvance(label.text()) > label.width() + rounding && !tellsWhatIsLong(label))
        say(label, label.text(), QStringLiteral("elides"));
    } else if (label.wordWrap()) {
      if (label.heightForWidth(label.width()) > label.height() + rounding)
        say(label, label.text(), QStringLiteral("has too few lines"));
    } else if (label.sizeHint().width() > label.width() + rounding) {
      say(label, label.text(), QStringLiteral("is cut off"));
    }
    if (label.fontMetrics().height() > label.height() + rounding)
      say(label, label.text(), QStringLiteral("is squeezed"));
  }

  void lookAtButton(const QAbstractButton& button) {
    if (button.text().isEmpty()) return;
    if (button.sizeHint().width() > button.width() + rounding) say(button, button.text(), QStringLiteral("is cut off"));
    if (button.fontMetrics().height() > button.height() + rounding)
      say(button, button.text(), QStringLiteral("is squeezed"));
  }

  void lookAtBox(const QComboBox& box) {
    if (box.isEditable()) return;  // its entry is looked at
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect field = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    const int icon = box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4;
    const bool isCut = box.fontMetrics().horizontalAdvance(box.currentText()) + icon > field.width() + rounding;
    if (isCut && !box.toolTip().contains(box.currentText())) say(box, box.currentText(), QStringLiteral("is cut off"));
  }

  void lookAtEntry(const QLineEdit& entry) {
    const QString shown = entry.text().isEmpty() ? entry.placeholderText() : entry.text();
    QStyleOptionFrame option;
    option.initFrom(&entry);
    const QRect inside = entry.style()->subElementRect(QStyle::SE_LineEditContents, &option, &entry);
    const QMargins margins = entry.textMargins();
    const int room = inside.width() - margins.left() - margins.right() + rounding;
    const bool isLongNumber = entry.inherits("talus::NumberField") && shown.size() > most_digits;
    if (entry.fontMetrics().horizontalAdvance(shown) > room && !entry.toolTip().contains(shown) && !isLongNumber)
      say(entry, shown, QStringLiteral("is cut off"));
  }

  void lookAtTabs(const QTabBar& tabs) {
    for (int i = 0; i < tabs.count(); ++i)
      if (tabs.isTabVisible(i) && !tabs.rect().contains(tabs.tabRect(i)))
        say(tabs, tabs.tabText(i), QStringLiteral("is out of sight"));
  }

  void lookAtTable(const QTableView& table) {
    const QAbstractItemModel& model = *table.model();
    const QHeaderView& head = *table.horizontalHeader();
    const bool tellsCells = table.itemDelegate()->inherits("talus::ElidedCells");
    if (head.length() > table.viewport()->width() + rounding && !table.horizontalScrollBar()->isVisible())
      say(table, table.accessibleName(), QStringLiteral("is wider than its place"));
    for (int column = 0; column < model.columnCount(); ++column) {
      if (table.isColumnHidden(column)) continue;
      const QString title = model.headerData(column, Qt::Horizontal).toString();
      if (head.isVisible() && !title.isEmpty() && head.sectionSizeHint(column) > head.sectionSize(column) + rounding)
        say(table, title, QStringLiteral("is cut off"));
      for (int row = 0; row < model.rowCount(); ++row) {
        const QModelIndex cell = model.index(row, column);
        double number = 0;  // is never elided: what is left of it would be another one
        if (tellsCells && !numbers::parse(cell.data().toString(), number)) continue;
        const QRect place = table.visualRect(cell);
        if (!table.viewport()->rect().intersects(place) || table.indexWidget(cell)) continue;
        if (table.sizeHintForIndex(cell).width() > place.width() + rounding)
          say(table, cell.data().toString(), QStringLiteral("is cut off"));
      }
    }
  }

  /// Parts of one layout keep to themselves, and within what they lie in.
  void lookAtLayout(const QWidget& widget) {
    if (!widget.layout()) return;
    std::vector<const QWidget*> parts;
    for (const QObject* child : widget.children())
      if (const auto* part = qobject_cast<const QWidget*>(child);
          part && part->isVisible() && !part->isWindow() && widget.layout()->indexOf(const_cast<QWidget*>(part)) >= 0)
        parts.push_back(part);
    for (const QWidget* part : parts) {
      if (!widget.rect().contains(part->geometry())) say(*part, part->accessibleName(), QStringLiteral("sticks out"));
      for (const QWidget* other : parts)
        if (other != part && other->geometry().intersects(part->geometry()) &&
            !widget.layout()->inherits("QStackedLayout"))
          say(*part, part->accessibleName(), QStringLiteral("lies over a neighbour"));
    }
  }

  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> cutOff(const QWidget& window) {
  Finder finder;
  finder.look(window);
  for (const QWidget* over : QApplication::topLevelWidgets())
    if (over != &window && over->isVisible()) finder.look(*over, window.size());
  return finder.found();
}

}  // namespace talus
