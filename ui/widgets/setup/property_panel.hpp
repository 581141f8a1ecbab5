#pragma once

#include <QPointer>
#include <QWidget>
#include <functional>

#include "document/selection.hpp"
#include "widgets/forms/field.hpp"
#include "widgets/kit/parts.hpp"

class QScrollArea;

namespace talus {

class BlockSurvey;
class CurrentProject;
class Display;
class Messages;
class Picking;
class Playback;
struct Block;

/// What the selected thing is, as a form that the schema of project files describes; of a block, what it was cut and
/// meshed into. Nothing selected: the project itself.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(CurrentProject& project, const BlockSurvey& survey, Playback& playback, Messages& messages,
                Display& display, Picking& picking);

 private:
  void rebuild();
  /// Object name of the field that has the keyboard; empty: none here.
  QString nameOfFieldInUse() const;
  /// Gives the keyboard to the field of that name, if it is there.
  void goOnIn(const QString& name);
  void showThing(const Item& item);
  /// "rock", or "2 of 3" for what has no name.
  QString nameOf(const schema::Place& place) const;
  void showBlock(int index);
  /// The body a block was built as, and why where that was left open.
  void showBody(Section* section, const Block& block);
  /// A button that leads to what the project says of this block alone.
  void offerWish(Section* section, const Block& block);
  /// Puts how the block moves in the frame in view into its label.
  void showMotion();
  Section* addSection(const QString& title, const QString& note = {});
  /// Says a problem where the project would be impossible.
  void tryTo(const std::function<void()>& act);

  CurrentProject& project_;
  const BlockSurvey& survey_;
  Playback& playback_;
  Messages& messages_;
  FormContext context_;
  QToolButton *duplicate_, *up_, *down_, *remove_;
  PanelHeader* header_;
  QVBoxLayout* column_;
  QWidget* content_ = nullptr;
  QScrollArea* scrolled_ = nullptr;
  Item shown_;
  QPointer<QLabel> motion_;  ///< goes with the content
};

}  // namespace talus
