#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QFormLayout>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

#include "widgets/kit/theme.hpp"

class QAction;
class QProgressBar;

/// Small building blocks of the window. Their looks come from properties that the style sheet knows.
namespace talus {

/// `role`: muted, faint, small, title, large, display, section, warn, error, chip…
QLabel* makeLabel(const QString& text, const char* role = nullptr);
/// The same, broken into lines where it becomes narrow.
QLabel* makeWrappedLabel(const QString& text, const char* role = nullptr);
void setRole(QLabel* label, const char* role);
/// `kind`: window, surface, card, overlay, notice, top, bottom, header, rail.
QFrame* makePlane(const char* kind);
QFrame* makeLine(Qt::Orientation orientation);
/// A button with an icon alone: its words are tooltip and accessible name.
QToolButton* makeTool(const QString& icon, const QString& tip, bool checkable = false);
/// A button with icon and word, as the workflow bar has them.
QToolButton* makeAction(const QString& icon, const QString& text, const QString& tip = {});
QPushButton* makeButton(const QString& text, const char* kind = nullptr);
/// It can be used, or cannot for a reason that its tooltip says; where it can the reason is empty.
void allow(QAction& action, const QString& whyNot);
/// A bar without words, filled by showShare.
QProgressBar* makeProgressBar();
/// 0…1 of the bar.
void showShare(QProgressBar& bar, double share);
void setMargins(QLayout* layout, int margin, int spacing);
/// Takes out all that is in it, and deletes it.
void clearLayout(QLayout& layout);

/// An icon as a still picture.
class Glyph : public QWidget {
  Q_OBJECT
 public:
  Glyph(const QString& icon, theme::Tone tone, int pixels = 16, QWidget* parent = nullptr);
  void setIcon(const QString& icon, theme::Tone tone);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QIcon icon_;
};

/// A label that cuts its text with an ellipsis rather than ask for width; the whole text is its tooltip then.
class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit ElidedLabel(const QString& text = {}, const char* role = nullptr);
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// The strip at a panel's top: its name, a note, tools at the right.
class PanelHeader : public QFrame {
  Q_OBJECT
 public:
  explicit PanelHeader(const QString& title, std::initializer_list<QToolButton*> tools = {});
  void setTitle(const QString& title, const QString& note = {});

 private:
  QLabel* title_;
  ElidedLabel* note_;
};

/// Named rows under a heading.
class Section : public QWidget {
  Q_OBJECT
 public:
  explicit Section(const QString& title, const QString& note = {});
  void addRow(const QString& name, QWidget* field, const QString& tip = {});
  /// A row that is read only.
  void addFact(const QString& name, const QString& value, const QString& tip = {});
  void setRowVisible(QWidget* field, bool shown) { rows_->setRowVisible(field, shown); }
  void addWide(QWidget* widget);

 private:
  QFormLayout* rows_;
};

/// A box that does not ask for the width of its longest item.
/// Gives a dialog its usual size, or less where the window that it stands over is small.
void resizeWithin(QWidget& dialog, const QSize& usual);

QComboBox* makeCombo(const QStringList& items, const QString& name);
/// `content` scrolls up and down, never sideways.
QScrollArea* makeScrolled(QWidget* content);

}  // namespace talus
