#include "widgets/forms/field.hpp"

#include <QComboBox>
#include <QLineEdit>
#include <QStyle>
#include <QVBoxLayout>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "document/document.hpp"
#include "document/edits.hpp"
#include "document/item_at.hpp"
#include "document/names.hpp"
#include "session/messages.hpp"
#include "widgets/forms/list_field.hpp"
#include "widgets/forms/object_field.hpp"
#include "widgets/forms/row_fields.hpp"
#include "widgets/forms/scalar_fields.hpp"
#include "widgets/forms/table_field.hpp"
#include "widgets/kit/display_units.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

using schema::Json;
using schema::Kind;

const Json* FieldSite::value() const {
  const Json& project = context.document.json();
  return project.contains(place) ? &project.at(place) : nullptr;
}

QString FieldSite::word(const char* key) const { return schema::words(rule, key); }

QString FieldSite::title() const { return word("title"); }

QString FieldSite::meaning() const { return word("description"); }

QString FieldSite::tip() const {
  const QString shown = units::shown(word("unit"), word("shown"));
  const QString unit =
      shown.isEmpty() ? QString() : QObject::tr("Shown in %1; any unit of its kind can be typed.").arg(shown);
  return QStringList{sentenceCase(meaning()), unit}.join(u'\n').trimmed();
}

QString FieldSite::absent() const {
  if (!optional) return {};
  if (rule.contains("absent")) return word("absent");
  if (!rule.contains("default")) return QObject::tr("none");
  const Json& usual = rule.at("default");
  if (usual.is_boolean()) return usual.get<bool>() ? QObject::tr("yes") : QObject::tr("no");
  if (usual.is_string()) return schema::choiceWords(usual.get<std::string>());
  const QString kept = word("unit"), shown = units::shown(kept, word("shown"));
  QStringList figures;
  for (const auto& number : usual.is_array() ? usual : Json::array({usual}))
    figures << numbers::inField(converted(number.get<double>(), kept.toStdString(), shown.toStdString()));
  return (figures.join(QStringLiteral(", ")) + u' ' + shown).trimmed();
}

FieldSite FieldSite::member(const std::string& key) const {
  Json own = schema::memberRule(rule, key);
  if (value() && !own.is_null()) schema::setDefault(own, key, rule, *value());
  return {context, place / key, std::move(own), schema::isOptional(rule, key)};
}

FieldSite FieldSite::element(std::size_t index) const {
  return {context, place / index, schema::memberRule(rule, {}), false};
}

FormField::FormField(FieldSite site, QWidget* parent)
    : QWidget(parent), site_(std::move(site)), column_(new QVBoxLayout(this)), problem_(makeWrappedLabel({}, "error")) {
  setMargins(column_, 0, 2);
  problem_->hide();
  column_->addWidget(problem_);
  setToolTip(site_.tip());  // of all that has none of its own in it
}

void FormField::add(QWidget* editor) {
  editor_ = editor;
  column_->insertWidget(column_->count() - 1, editor);
}

void FormField::say(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  problem_->setObjectName(text(site_.place.to_string()) + QStringLiteral("#problem"));
  if (!qobject_cast<QLineEdit*>(editor_) && !qobject_cast<QComboBox*>(editor_)) return;
  editor_->setProperty("state", problem.isEmpty() ? QVariant() : QVariant("error"));
  editor_->style()->unpolish(editor_);
  editor_->style()->polish(editor_);
}

bool FormField::change(const QString& what, const std::function<void(Json&)>& edit) {
  Json project = site_.context.document.json();
  try {
    edit(project);
    site_.context.document.change(project, what);
    say({});
    return true;
  } catch (const InputError& error) {
    const bool here = error.place().find(site_.place.to_string()) != std::string::npos;
    const Problem problem = problemOf(error);
    const QString where =
        here ? QString() : placeWords(site_.context.document.project(), problem.place) + QStringLiteral(": ");
    say(where + tr("%1; %2").arg(problem.problem, problem.remedy));
    return false;
  }
}

bool FormField::put(const Json& value) {
  const auto& project = site_.context.document.json();
  return change(
      tr("change %1 of %2")
          .arg(schema::withinSentence(site_.title()), names::described(site_.place.parent_pointer(), project)),
      [&](Json& changed) { edits::set(changed, site_.place, value); });
}

bool FormField::leaveOut() {
  const auto& project = site_.context.document.json();
  return change(
      tr("leave out %1 of %2")
          .arg(schema::withinSentence(site_.title()), names::described(site_.place.parent_pointer(), project)),
      [&](Json& changed) { edits::clear(changed, site_.place); });
}

bool isWide(const Json& rule) {
  switch (schema::kindOf(rule)) {
    case Kind::constant:
    case Kind::choice:
    case Kind::boolean:
    case Kind::number:
    case Kind::namedNumber:
      return false;
    case Kind::text:  // of a quantity it is a path, longer than what stands beside a title
      return rule.value("quantity", false);
    case Kind::numbers:
    case Kind::texts:
    case Kind::table:
    case Kind::list:
    case Kind::named:
    case Kind::object:
      break;
  }
  return true;
}

FormField* makeField(const FieldSite& site, QWidget* parent) {
  switch (schema::kindOf(site.rule)) {
    case Kind::choice:
    case Kind::boolean:
      return new ChoiceField(site, parent);
    case Kind::number:
      return new NumberEntry(site, parent);
    case Kind::namedNumber:
      return new NamedNumberField(site, parent);
    case Kind::text:
      if (site.rule.contains("names")) return new NameField(site, parent);
      return new TextField(site, parent);
    case Kind::numbers:
      return new VectorField(site, parent);
    case Kind::texts:
      return new NamesField(site, parent);
    case Kind::table:
      return new TableField(site, parent);
    case Kind::list:
    case Kind::named:
      return new ListField(site, parent);
    case Kind::object:
      return new ObjectField(site, parent);
    case Kind::constant:
      break;
  }
  return new FormField(site, parent);
}

}  // namespace talus
