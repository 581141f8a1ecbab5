#include "document/item_at.hpp"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "document/schema.hpp"
#include "model/project.hpp"

namespace talus {

namespace {

/// A key of a JSON pointer as it was before it was escaped.
std::string keyOf(QString part) {
  return part.replace(QStringLiteral("~1"), QStringLiteral("/"))
      .replace(QStringLiteral("~0"), QStringLiteral("~"))
      .toStdString();
}

template <class Named>
Item named(Item::Kind kind, const std::vector<Named>& things, const std::string& name) {
  const auto found = std::find_if(things.begin(), things.end(), [&](const Named& one) { return one.name == name; });
  return found == things.end() ? Item{} : Item{kind, static_cast<int>(std::distance(things.begin(), found))};
}

Item numbered(Item::Kind kind, std::size_t count, const QString& part) {
  bool good = false;
  const int index = part.toInt(&good);
  return good && index >= 0 && index < static_cast<int>(count) ? Item{kind, index} : Item{};
}

template <class Things>
QString nameIn(const Things& things, int index) {
  return QString::fromStdString(things.at(static_cast<std::size_t>(index)).name);
}

bool isNumber(const QString& part) {
  bool good = false;
  part.toInt(&good);
  return good;
}

bool isListOfThings(const schema::Json& rule) {
  if (!rule.contains("type")) return false;
  const schema::Kind kind = schema::kindOf(rule);
  return kind == schema::Kind::list || kind == schema::Kind::named;
}

/// "z" of a vector, "3" of a row.
QString numberIn(const schema::Json& rule, int index) {
  const schema::Json columns = rule.value("columns", schema::Json::array());
  const auto at = static_cast<std::size_t>(index);
  return at < columns.size() ? QString::fromStdString(columns.at(at).get<std::string>()) : QString::number(index + 1);
}

/// Empty for things without one.
QString nameOf(const Project& project, const Item& item) {
  switch (item.kind) {
    case Item::Kind::solid:
      return nameIn(project.solids, item.index);
    case Item::Kind::material:
      return nameIn(project.materials, item.index);
    case Item::Kind::joint:
      return nameIn(project.joints, item.index);
    case Item::Kind::stage:
      return nameIn(project.stages, item.index);
    case Item::Kind::monitor:
      return nameIn(project.monitors, item.index);
    default:
      return {};
  }
}

}  // namespace

QString placeWords(const Project& project, const QString& place) {
  const QStringList parts = place.split(u'/', Qt::SkipEmptyParts);
  if (parts.isEmpty()) return QObject::tr("project");
  if (!place.startsWith(u'/')) return place;
  const QString name = nameOf(project, itemAt(project, place));
  QStringList words;
  schema::Json rule = schema::root();
  for (const QString& part : parts) {
    const std::string key = keyOf(part);
    const schema::Json holder = std::exchange(rule, schema::memberRule(rule, key));
    const QString title = schema::withinSentence(schema::words(rule, "title"));
    if (!isListOfThings(holder) || title.isEmpty()) {
      words << (isNumber(part)    ? numberIn(holder, part.toInt())
                : title.isEmpty() ? QString::fromStdString(key)
                                  : title);
      continue;
    }
    const QString own = words.size() == 1 && !name.isEmpty() ? name
                        : isNumber(part)                     ? QString::number(part.toInt() + 1)
                                                             : QString::fromStdString(key);
    words.last() = title + u' ' + own;  // "material rock", not "materials, rock"
  }
  return words.join(QStringLiteral(", "));
}

Item itemAt(const Project& project, const QString& place) {
  const QStringList parts = place.split(u'/');
  if (parts.size() < 3) return {};
  const QString &list = parts[1], &which = parts[2];
  if (list == QLatin1String("materials")) return named(Item::Kind::material, project.materials, keyOf(which));
  if (list == QLatin1String("joints")) return named(Item::Kind::joint, project.joints, keyOf(which));
  const std::tuple<const char*, Item::Kind, std::size_t> lists[] = {
      {"solids", Item::Kind::solid, project.solids.size()},
      {"cuts", Item::Kind::cut, project.cuts.size()},
      {"loads", Item::Kind::load, project.loads.size()},
      {"constraints", Item::Kind::constraint, project.constraints.size()},
      {"velocities", Item::Kind::velocity, project.velocities.size()},
      {"stages", Item::Kind::stage, project.stages.size()},
      {"monitors", Item::Kind::monitor, project.monitors.size()}};
  for (const auto& [key, kind, count] : lists)
    if (list == QLatin1String(key)) return numbered(kind, count, which);
  return {};
}

}  // namespace talus
