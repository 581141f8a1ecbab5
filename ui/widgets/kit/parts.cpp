#include "widgets/kit/parts.hpp"

#include <QAbstractItemView>
#include <QAction>
#include <QEvent>
#include <QPainter>
#include <QProgressBar>
#include <QScrollArea>
#include <QStyle>

namespace talus {

QLabel* makeLabel(const QString& text, const char* role) {
  auto* label = new QLabel(text);
  if (role) label->setProperty("role", role);
  return label;
}

QLabel* makeWrappedLabel(const QString& text, const char* role) {
  auto* label = makeLabel(text, role);
  label->setWordWrap(true);
  return label;
}

void setRole(QLabel* label, const char* role) {
  if (label->property("role").toByteArray() == role) return;
  label->setProperty("role", role);
  label->style()->unpolish(label);
  label->style()->polish(label);
}

QFrame* makePlane(const char* kind) {
  auto* frame = new QFrame;
  frame->setProperty("plane", kind);
  return frame;
}

QFrame* makeLine(Qt::Orientation orientation) {
  auto* frame = new QFrame;
  frame->setProperty("line", orientation == Qt::Horizontal ? "h" : "v");
  return frame;
}

QToolButton* makeTool(const QString& icon, const QString& tip, bool checkable) {
  auto* button = new QToolButton;
  button->setIcon(theme::icon(icon));
  button->setIconSize({16, 16});
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setCheckable(checkable);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);  // the first one would take the focus when the window shows
  return button;
}

QToolButton* makeAction(const QString& icon, const QString& text, const QString& tip) {
  auto* button = makeTool(icon, tip.isEmpty() ? text : tip);
  button->setText(QStringLiteral(" ") + text);  // style sheets have no gap between icon and text
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setProperty("kind", "action");
  return button;
}

QPushButton* makeButton(const QString& text, const char* kind) {
  auto* button = new QPushButton(text);
  if (kind) button->setProperty("kind", kind);
  return button;
}

void allow(QAction& action, const QString& whyNot) {
  action.setEnabled(whyNot.isEmpty());
  const QString key = action.shortcut().toString(QKeySequence::NativeText);
  const QString name = key.isEmpty() ? action.text() : QObject::tr("%1 (%2)").arg(action.text(), key);
  action.setToolTip(whyNot.isEmpty() ? name : name + u'\n' + whyNot);
}

QProgressBar* makeProgressBar() {
  auto* bar = new QProgressBar;
  bar->setRange(0, 1000);
  bar->setTextVisible(false);
  return bar;
}

void showShare(QProgressBar& bar, double share) { bar.setValue(static_cast<int>(1000 * share)); }

void clearLayout(QLayout& layout) {
  while (auto* item = layout.takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

void setMargins(QLayout* layout, int margin, int spacing) {
  layout->setContentsMargins(margin, margin, margin, margin);
  layout->setSpacing(spacing);
}

Glyph::Glyph(const QString& icon, theme::Tone tone, int pixels, QWidget* parent)
    : QWidget(parent), icon_(theme::icon(icon, tone)) {
  setFixedSize(pixels, pixels);
}

void Glyph::setIcon(const QString& icon, theme::Tone tone) {
  icon_ = theme::icon(icon, tone);
  update();
}

void Glyph::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  icon_.paint(&painter, rect());
}

ElidedLabel::ElidedLabel(const QString& text, const char* role) : QLabel(text) {
  if (role) setProperty("role", role);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

QSize ElidedLabel::minimumSizeHint() const { return {0, QLabel::minimumSizeHint().height()}; }

void ElidedLabel::paintEvent(QPaintEvent*) {
  const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, width());
  setToolTip(shown == text() ? QString() : text());
  QPainter painter(this);
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(rect(), static_cast<int>(alignment()), shown);
}

PanelHeader::PanelHeader(const QString& title, std::initializer_list<QToolButton*> tools)
    : title_(makeLabel(title, "panel")), note_(new ElidedLabel({}, "small")) {
  setProperty("plane", "header");
  setFixedHeight(theme::now().metrics.header);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 0, 6, 0);
  layout->setSpacing(6);
  layout->addWidget(title_);
  layout->addWidget(note_, 1);
  for (auto* tool : tools) layout->addWidget(tool);
}

void PanelHeader::setTitle(const QString& title, const QString& note) {
  title_->setText(title);
  note_->setText(note);
}

Section::Section(const QString& title, const QString& note) : rows_(new QFormLayout) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  auto* heading = new QHBoxLayout;
  setMargins(heading, 0, 6);
  heading->addWidget(makeLabel(title, "section"));
  heading->addStretch();
  if (!note.isEmpty()) heading->addWidget(makeLabel(note, "faint"));
  column->addLayout(heading);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setHorizontalSpacing(8);
  rows_->setVerticalSpacing(4);
  rows_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  column->addLayout(rows_);
}

void Section::addRow(const QString& name, QWidget* field, const QString& tip) {
  auto* label = makeLabel(name, "muted");
  label->setMinimumHeight(24);
  label->setFixedWidth(104);
  label->setToolTip(tip);
  rows_->addRow(label, field);
}

void Section::addFact(const QString& name, const QString& value, const QString& tip) {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  setMargins(line, 0, 8);
  auto* title = new ElidedLabel(name, "muted");
  title->setMinimumHeight(24);
  title->setToolTip(tip);
  auto* label = new ElidedLabel(value);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  line->addWidget(title);
  line->addWidget(label, 1);
  addWide(row);
}

void Section::addWide(QWidget* widget) { rows_->addRow(widget); }

namespace {

/// Gives its content the height that wrapped words need at the width that there is. Qt itself knows only the least
/// height of each row, and would press rows together, one over the other.
class ScrolledColumn : public QScrollArea {
 public:
  explicit ScrolledColumn(QWidget* content) {
    setWidget(content);
    setWidgetResizable(true);
    content->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) fitContent();
    return QScrollArea::eventFilter(watched, event);
  }
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    fitContent();
  }

 private:
  void fitContent() {
    const QLayout* rows = widget() ? widget()->layout() : nullptr;
    if (rows)
      widget()->setMinimumHeight(rows->hasHeightForWidth() ? rows->totalHeightForWidth(viewport()->width()) : 0);
  }
};

}  // namespace

QScrollArea* makeScrolled(QWidget* content) {
  auto* area = new ScrolledColumn(content);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return area;
}

void resizeWithin(QWidget& dialog, const QSize& usual) {
  constexpr QSize beside(60, 40);  // of the window stays in sight
  const QWidget* window = dialog.parentWidget();
  dialog.resize(window ? usual.boundedTo(window->size() - beside) : usual);
}

namespace {

/// Its list is as wide as its entries, however narrow the box is.
class Combo : public QComboBox {
 public:
  void showPopup() override {
    constexpr int around = 32;  // of an entry, and what scrolls the list
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + around);
    QComboBox::showPopup();
  }
};

}  // namespace

QComboBox* makeCombo(const QStringList& items, const QString& name) {
  auto* box = new Combo;
  box->addItems(items);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(4);
  box->setMinimumWidth(60);
  box->setAccessibleName(name);
  return box;
}

}  // namespace talus
