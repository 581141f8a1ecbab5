#include "driven_form.hpp"

#include <QAbstractItemView>
#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>
#include <algorithm>

#include "document/item_place.hpp"
#include "document/schema.hpp"
#include "document/things.hpp"
#include "model/number_text.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/project/project_tree.hpp"

namespace talus {

using schema::Kind;

namespace {

const std::map<std::string, std::pair<const char*, Item::Kind>> groups{
    {"solids", {"geometry", Item::Kind::solid}},
    {"joints", {"joints", Item::Kind::joint}},
    {"cuts", {"joints", Item::Kind::cut}},
    {"interfaces", {"joints", Item::Kind::interface}},
    {"blocks", {"blocks", Item::Kind::blockWish}},
    {"merges", {"blocks", Item::Kind::merge}},
    {"materials", {"materials", Item::Kind::material}},
    {"loads", {"loads", Item::Kind::load}},
    {"constraints", {"loads", Item::Kind::constraint}},
    {"velocities", {"loads", Item::Kind::velocity}},
    {"in_situ", {"loads", Item::Kind::inSitu}},
    {"stages", {"stages", Item::Kind::stage}},
    {"monitors", {"results", Item::Kind::monitor}},
    {"expect", {"results", Item::Kind::expectation}}};

/// A number with the unit that the file has it in: what the field shows must not matter.
QString typed(const schema::Json& number, const std::string& unit) {
  return text(number_text(number.get<double>()) + unit);
}

QString spaced(const std::string& unit) { return unit.empty() ? QString() : u' ' + text(unit); }

bool isScalar(const schema::Json& rule) {
  const Kind kind = schema::kindOf(rule);
  return kind == Kind::number || kind == Kind::namedNumber || kind == Kind::boolean || kind == Kind::choice ||
         kind == Kind::text;
}

}  // namespace

void DrivenForm::click(const std::string& name) {
  if (auto* button = widget<QAbstractButton>(name)) QTest::mouseClick(button, Qt::LeftButton);
  rest(5);
}

void DrivenForm::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  window->activateWindow();  // as a window manager does when a dialog is closed
  rest(20);
  QTest::keyClick(window.get(), key, modifiers);
  rest(20);
}

void DrivenForm::type(const std::string& name, const QString& text) {
  auto* found = widget<QWidget>(name);
  if (!found) return;
  auto* box = qobject_cast<QComboBox*>(found);
  auto* entry = box ? box->lineEdit() : qobject_cast<QLineEdit*>(found);
  ASSERT_NE(entry, nullptr) << name << " cannot be typed into";
  entry->setFocus();
  entry->selectAll();
  QTest::keyClick(entry, Qt::Key_Delete);
  for (const QChar c : text)  // keyClicks knows Latin letters alone
    QTest::sendKeyEvent(QTest::Click, entry, Qt::Key_unknown, QString(c), Qt::NoModifier);
  QTest::keyClick(entry, Qt::Key_Return);
  rest(5);
}

void DrivenForm::choose(const std::string& name, const QString& entry) {
  auto* box = widget<QComboBox>(name);
  if (!box) return;
  const int row = box->findText(schema::choiceWords(entry.toStdString()));
  ASSERT_GE(row, 0) << name << " has no entry " << entry.toStdString();
  box->showPopup();
  box->view()->setCurrentIndex(box->model()->index(row, 0));
  QTest::keyClick(box->view(), Qt::Key_Return);
  rest(5);
}

schema::Place DrivenForm::addThing(const std::string& list) {
  const auto& [page, kind] = groups.at(list);
  auto* button = widget<QToolButton>(std::string("new/") + page);
  if (!button) return Place();
  if (auto* menu = button->menu()) {
    for (auto* action : menu->actions())
      if (action->text() == things::titleOf(kind) ||
          (kind == Item::Kind::solid && action->text() == QStringLiteral("New box")))
        action->trigger();
  } else {
    QTest::mouseClick(button, Qt::LeftButton);
  }
  rest(10);
  EXPECT_EQ(session->project.selection().current().kind, kind) << "no thing was added to " << list;
  return placeOf(session->project.selection().current(), project());
}

void DrivenForm::selectRow(const Item& item) {
  auto* tree = window->findChild<ProjectTree*>();
  auto* row = tree->rowOf(item);
  ASSERT_NE(row, nullptr);
  row->parent()->setExpanded(true);
  tree->scrollToItem(row);
  rest(5);
  QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(row).center());
  rest(10);
}

void DrivenForm::goTo(WorkflowPage page) {
  const QString name = QStringLiteral("rail-%1").arg(QLatin1String(pageKey(page)));
  QTest::mouseClick(window->findChild<QWidget*>(name), Qt::LeftButton);
  rest(30);
  ASSERT_EQ(session->display.page(), page);
}

void DrivenForm::chooseInMenus(const QStringList& entries) {
  QMenu* menu = nullptr;
  for (const QString& words : entries) {
    auto* bar = window->findChild<QMenuBar*>();
    QWidget* from = menu ? static_cast<QWidget*>(menu) : bar;
    const auto actions = from->actions();
    const auto entry = std::ranges::find_if(actions, [&](const QAction* one) { return one->text() == words; });
    ASSERT_NE(entry, actions.end()) << words.toStdString();
    ASSERT_TRUE((*entry)->isEnabled()) << (*entry)->toolTip().toStdString();
    const QRect place = menu ? menu->actionGeometry(*entry) : bar->actionGeometry(*entry);
    QMenu* next = (*entry)->menu();
    QTest::mouseClick(from, Qt::LeftButton, {}, place.center());
    ASSERT_TRUE(!next || wait([&] { return next->isVisible(); }, 2000)) << words.toStdString();
    menu = next;
  }
  rest(30);
}

void DrivenForm::clickOnRock(const Vec3& place) {
  QTest::keyClick(&area(), Qt::Key_0);
  ASSERT_TRUE(wait([&] { return !window->viewport().isFlying(); }));
  const auto at = window->viewport().pointOf(place);
  ASSERT_TRUE(at && area().rect().contains(at->toPoint()));
  QTest::mouseClick(&area(), Qt::LeftButton, {}, at->toPoint());
  rest(30);
}

int DrivenForm::clickWhileItCan(const char* name) {
  QToolButton* button = nullptr;
  for (auto* one : window->findChildren<QToolButton*>())
    if (one->accessibleName() == QLatin1String(name) && one->isVisible()) button = one;
  int presses = 0;
  for (; button && button->isEnabled(); ++presses) {
    QTest::mouseClick(button, Qt::LeftButton);
    rest(1);
  }
  return presses;
}

void DrivenForm::makePresent(const Place& place) {
  if (!project().contains(place)) click(place.to_string() + "#set");
}

void DrivenForm::enterNumber(const Place& place, const Json& rule, const Json& target) {
  type(place.to_string(), target.is_null() ? QString() : typed(target, {}) + spaced(rule.value("unit", std::string())));
}

void DrivenForm::enterTable(const Place& place, const Json& rule, const Json& target) {
  makePresent(place);
  const Json row = schema::memberRule(rule, {});
  const Json units = row.value("units", Json::array());
  QStringList lines;
  for (const auto& numbers : target) {
    QStringList cells;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::string unit = i < units.size() ? units.at(i).get<std::string>() : row.value("unit", std::string());
      cells << (numbers.at(i).is_null() ? text(schema::memberRule(row, {}).at("absent").get<std::string>())
                                        : typed(numbers.at(i), unit));
    }
    lines << cells.join(u'\t');
  }
  QApplication::clipboard()->setText(lines.join(u'\n'));
  click(place.to_string() + "#paste");
}

void DrivenForm::enterElements(const Place& place, const Json& target) {
  makePresent(place);
  for (const auto& [key, value] : target.items()) {
    const Place each = target.is_object() ? place / key : place / std::stoul(key);
    if (!project().contains(each)) click(place.to_string() + "#add");
    enter(each, value);
  }
}

void DrivenForm::enterMembers(const Place& place, const Json& rule, const Json& target) {
  makePresent(place);
  const auto variants = schema::variants(rule);
  for (const auto& key : variants)
    if (target.contains(key) && !project().at(place).contains(key))
      choose(place.to_string() + "#variant", text(schema::memberRule(rule, key).at("title").get<std::string>()));
  // What the rest of the thing does not allow yet is tried again: less friction needs less residual friction first.
  std::vector<std::string> refused;
  for (const auto& [key, value] : target.items()) {
    if (!isScalar(schema::memberRule(rule, key)) || says(place / key, value)) {
      enter(place / key, value);
      continue;
    }
    fillIn(place / key, value);
    if (says(place / key, value))
      entered.insert(fieldAt(place / key));
    else
      refused.push_back(key);
  }
  for (const auto& key : refused) enter(place / key, target.at(key));
  const Json present = project().at(place);
  for (const auto& [key, value] : present.items())
    if (!target.contains(key)) leaveOut(place / key);
}

void DrivenForm::leaveOut(const Place& place) {
  const Kind kind = schema::kindOf(schema::ruleOf(place));
  if (kind != Kind::choice && kind != Kind::boolean) return click(place.to_string() + "#clear");
  if (const auto* box = widget<QComboBox>(place.to_string())) choose(place.to_string(), box->itemText(0));
}

bool DrivenForm::says(const Place& place, const Json& target) {
  return project().contains(place) && nlohmann::json(project().at(place)) == nlohmann::json(target);
}

void DrivenForm::fillIn(const Place& place, const Json& target) {
  const Json rule = schema::ruleOf(place);
  switch (schema::kindOf(rule)) {
    case Kind::constant:
      break;
    case Kind::number:
      enterNumber(place, rule, target);
      break;
    case Kind::namedNumber:
      type(place.to_string(), target.is_string() ? text(target.get<std::string>()) : typed(target, {}));
      break;
    case Kind::boolean:
      choose(place.to_string(), target.get<bool>() ? "yes" : "no");
      break;
    case Kind::choice:
      choose(place.to_string(), text(target.get<std::string>()));
      break;
    case Kind::text:
      if (rule.contains("names") && !rule.value("pieces", false) && !rule.value("quantity", false))
        choose(place.to_string(), text(target.get<std::string>()));
      else
        type(place.to_string(), text(target.get<std::string>()));
      break;
    case Kind::numbers:
    case Kind::texts:
      makePresent(place);
      for (std::size_t i = 0; i < target.size(); ++i) enter(place / i, target.at(i));
      break;
    case Kind::table:
      enterTable(place, rule, target);
      break;
    case Kind::list:
    case Kind::named:
      enterElements(place, target);
      break;
    case Kind::object:
      enterMembers(place, rule, target);
      break;
  }
}

void DrivenForm::enter(const Place& place, const Json& target) {
  if (says(place, target)) return;
  fillIn(place, target);
  ASSERT_TRUE(project().contains(place)) << place.to_string();
  EXPECT_EQ(nlohmann::json(project().at(place)), nlohmann::json(target)) << place.to_string();
  if (says(place, target)) entered.insert(fieldAt(place));
}

void DrivenForm::enterThings(const std::string& list, const Json& things) {
  for (const auto& [key, thing] : things.items()) {
    Place place = addThing(list);
    if (things.is_object()) {
      type(place.to_string() + "#name", text(key));
      place = Place() / list / key;
    }
    ASSERT_TRUE(project().contains(place)) << place.to_string();
    entered.insert(fieldAt(Place() / list));
    enter(place, thing);
  }
}

std::set<std::string> fieldsOf(const schema::Json& rule, const std::string& path) {
  std::set<std::string> fields;
  for (const auto& [key, part] : rule.items()) {
    const std::string inside = path + '/' + key;
    if (key == "properties")
      for (const auto& [name, property] : part.items()) {
        const Kind kind = schema::kindOf(schema::resolved(property));
        if (kind != Kind::constant) fields.insert(inside + '/' + name);
        fields.merge(fieldsOf(property, inside + '/' + name));
      }
    else if (key == "definitions")
      for (const auto& [name, definition] : part.items()) fields.merge(fieldsOf(definition, inside + '/' + name));
    else if (key == "items" || key == "additionalProperties")
      if (part.is_object()) fields.merge(fieldsOf(part, inside));
  }
  return fields;
}

std::string fieldAt(const schema::Place& place) {
  if (place.empty()) return {};
  std::string path = fieldAt(place.parent_pointer());
  const auto at = [&]() -> const schema::Json& { return schema::root().at(schema::Place(path)); };
  while (at().contains("$ref")) path = at().at("$ref").get<std::string>().substr(1);
  if (at().contains("properties")) return path + "/properties/" + place.back();
  return path + (at().contains("items") ? "/items" : "/additionalProperties");
}

}  // namespace talus
