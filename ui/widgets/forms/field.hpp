#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "document/schema.hpp"

class QLabel;
class QVBoxLayout;

namespace talus {

class Document;
class Picking;

/// A point of a time table that the user works with: its row and its curve.
struct TablePoint {
  schema::Place table = schema::Place();
  int row = -1, curve = -1;
};

/// Pixels, of the titles beside the fields.
inline constexpr int title_width = 104;

/// Where a form stands in the window: the document it changes, and the blocks that were cut, whose names it offers.
struct FormContext {
  Document& document;
  std::vector<std::string> blocks{};
  Picking* picking = nullptr;       ///< where places can be picked in the view; null: nowhere
  std::function<void()> refresh{};  ///< makes the form anew: what it shows was chosen otherwise
  TablePoint chosen{};              ///< to go on with when the form has been made anew
};

/// One place of the project file, by its rule in the schema. It may be empty: the file leaves it out.
struct FieldSite {
  FormContext& context;
  schema::Place place;
  schema::Json rule;
  bool optional = false;

  /// Null where the file leaves it out.
  const schema::Json* value() const;
  bool isSet() const { return value() != nullptr; }
  QString title() const;
  /// The schema's description, for a tooltip.
  QString meaning() const;
  /// The same with the unit that is shown.
  QString tip() const;
  /// What it means that the file leaves it out: "0 MPa", "automatic"; empty where it may not.
  QString absent() const;
  /// The rule says this word; empty where it does not.
  QString word(const char* key) const;
  FieldSite member(const std::string& key) const;
  FieldSite element(std::size_t index) const;
};

/// A value that can be changed: an editor, and beneath it what is wrong with what was typed. It knows its place and the
/// schema's rule, nothing of what it is about.
class FormField : public QWidget {
  Q_OBJECT
 public:
  using Json = schema::Json;
  FormField(FieldSite site, QWidget* parent);

 protected:
  const FieldSite& site() const { return site_; }
  void add(QWidget* editor);
  /// One step that can be undone; false, and the reason is said, where the project would be impossible.
  bool change(const QString& what, const std::function<void(Json&)>& edit);
  bool put(const Json& value);
  bool leaveOut();

 public slots:
  /// Beneath the editor; an empty sentence takes it away.
  void say(const QString& problem);

 private:
  FieldSite site_;
  QVBoxLayout* column_;
  QWidget* editor_ = nullptr;  ///< the last one that was added
  QLabel* problem_;
};

/// The editor for what the rule of a place says, a child of `parent`: what is put into a window later is styled anew
/// with all that it holds.
FormField* makeField(const FieldSite& site, QWidget* parent);
/// It stands under its title, not beside it.
bool isWide(const schema::Json& rule);

}  // namespace talus
