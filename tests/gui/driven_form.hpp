#pragma once

#include <QTest>
#include <set>
#include <string>

#include "document/schema.hpp"
#include "driven_window.hpp"

namespace talus {

/// A window whose forms are filled in as a person does it: by typing, choosing, pasting and clicking.
class DrivenForm : public DrivenWindow {
 protected:
  using Json = schema::Json;
  using Place = schema::Place;

  const Json& project() { return session->project.document().json(); }
  /// The widget with this name, which is to be seen; null, and a failure, where there is none.
  template <class Widget>
  Widget* widget(const std::string& name) {
    rest(5);
    auto* found = window->findChild<Widget*>(QString::fromStdString(name));
    EXPECT_NE(found, nullptr) << name << " has no widget of its kind";
    return found;
  }

  void click(const std::string& name);
  /// Keys of the window, which comes to the front.
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  void type(const std::string& name, const QString& text);
  void choose(const std::string& name, const QString& entry);
  /// A thing more in the list of this key, by the button in the project tree.
  Place addThing(const std::string& list);
  /// Selects by a click on the row of the tree.
  void selectRow(const Item& item);
  /// By a click in the rail.
  void goTo(WorkflowPage page);
  /// Clicks menu by menu: {"Model", "New solid", "New box"}.
  void chooseInMenus(const QStringList& entries);
  /// Clicks where a place [m] of the rock's surface is seen from the south-west.
  void clickOnRock(const Vec3& place);
  /// Clicks the tool of this name again and again until it is grey; how often that was.
  int clickWhileItCan(const char* tool);
  /// What the 3-D view is drawn on.
  QWidget& area() { return *window->viewport().findChild<QWidget*>(QStringLiteral("view area")); }

  /// Makes what stands at a place, whose form is open, say this.
  void enter(const Place& place, const Json& target);
  void enterThings(const std::string& list, const Json& things);

  /// Fields of the schema that were set, as pointers into it: "/definitions/joint/properties/cohesion".
  std::set<std::string> entered;

 private:
  bool says(const Place& place, const Json& target);
  void fillIn(const Place& place, const Json& target);
  void enterNumber(const Place& place, const Json& rule, const Json& target);
  void enterTable(const Place& place, const Json& rule, const Json& target);
  void enterMembers(const Place& place, const Json& rule, const Json& target);
  void enterElements(const Place& place, const Json& target);
  void leaveOut(const Place& place);
  void makePresent(const Place& place);
};

/// All fields that the schema has, but those that this version refuses and those that never differ.
std::set<std::string> fieldsOf(const schema::Json& rule, const std::string& path = {});
/// The field of the schema that a place of a project is.
std::string fieldAt(const schema::Place& place);

}  // namespace talus
