#include "session/block_edits.hpp"

#include <QObject>
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/error.hpp"
#include "document/edits.hpp"
#include "document/names.hpp"
#include "mesh/inner_point.hpp"
#include "removability/block_rule.hpp"

namespace talus::block_edits {

namespace {

using schema::Json;
using schema::Place;

QString counted(std::size_t count) { return count == 1 ? QObject::tr("1 block") : QObject::tr("%1 blocks").arg(count); }

/// The project of a document, being changed block by block.
class Edit {
 public:
  explicit Edit(CurrentProject& project)
      : project_(project), system_(*project.system()), changed_(project.document().json()) {
    const auto& wishes = project.document().project().blocks;
    for (std::size_t i = 0; i < wishes.size(); ++i) entries_[keyOf(wishes[i].at)] = i;
    for (const BlockOverride& wish : project.builtFrom().blocks) builtPlaces_[wish.name] = wish.at;
    for (const Solid& solid : project.document().project().solids) solids_.insert(solid.name);
  }

  const Block& block(int index) const { return system_.blocks.at(static_cast<std::size_t>(index)); }

  /// The point by which the project speaks of a block: the one that gave it its name, else one inside.
  Vec3 placeOf(int index) const {
    const auto built = builtPlaces_.find(block(index).name);
    return built == builtPlaces_.end() ? edits::keptPlace(inner_point(block(index).mesh)) : built->second;
  }

  /// What the project says of a block, which is made where it says nothing yet: the block keeps its name, unless that
  /// is its solid's.
  Json& entryOf(int index) {
    const Vec3 place = placeOf(index);
    Json& list = changed_["blocks"];
    const auto [entry, isNew] = entries_.try_emplace(keyOf(place), list.size());
    if (isNew) {
      const std::string& name = block(index).name;
      const bool isTaken = solids_.contains(name);
      const std::string own = isTaken ? names::fresh(name, names::listsBeside("blocks"), changed_) : name;
      list.push_back({{"name", own}, {"at", edits::placeJson(place)}});
      if (isTaken) renamed_[name] = own;
    }
    return list.at(entry->second);
  }

  /// What is said of a solid that was left whole stands with the solid itself.
  void set(int index, const char* key, const Json& value) {
    const auto& solids = project_.document().project().solids;
    const auto whole = std::ranges::find(solids, block(index).name, &Solid::name);
    Json& holder = whole == solids.end() ? entryOf(index)
                                         : changed_["solids"].at(static_cast<std::size_t>(whole - solids.begin()));
    holder[key] = value;
  }

  /// What the project says of a block itself; null where that is nothing.
  const BlockOverride* wishFor(int index) const {
    const auto entry = knownEntry(index);
    return entry == entries_.end() ? nullptr : &project_.document().project().blocks[entry->second];
  }

  void leaveOut(int index, const char* key) {
    const auto entry = knownEntry(index);
    if (entry != entries_.end()) changed_["blocks"].at(entry->second).erase(key);
  }

  void rename(int index, const std::string& name) {
    const std::string& before = block(index).name;
    Json& entry = entryOf(index);
    renamed_[entry.at("name").get<std::string>()] = name;
    if (solids_.contains(before)) renamed_[before] = name;
    entry["name"] = name;
  }

  Json& json() { return changed_; }

  void finish(const QString& what) {
    if (!renamed_.empty()) names::follow(changed_, "blocks", renamed_);
    project_.document().change(changed_, what);
  }

 private:
  using Key = std::array<double, 3>;
  static Key keyOf(const Vec3& place) { return {place.x(), place.y(), place.z()}; }

  /// Places of a thousand blocks take a while: they are not looked for where the project says nothing of any.
  std::map<Key, std::size_t>::const_iterator knownEntry(int index) const {
    return entries_.empty() ? entries_.end() : entries_.find(keyOf(placeOf(index)));
  }

  CurrentProject& project_;
  const BlockSystem& system_;
  Json changed_;
  std::map<Key, std::size_t> entries_;  ///< places in the project's list by the point that they speak of
  std::map<std::string, Vec3> builtPlaces_;
  std::set<std::string> solids_;
  std::map<std::string, std::string> renamed_;
};

void setMember(CurrentProject& project, const Blocks& blocks, const char* key, const Json& value, const QString& what) {
  Edit edit(project);
  for (const int block : blocks) {
    if (value.is_null())
      edit.leaveOut(block, key);
    else
      edit.set(block, key, value);
  }
  edit.finish(what);
}

}  // namespace

std::vector<BlockOverride> said(CurrentProject& project, const Blocks& blocks) {
  const Edit edit(project);
  const auto& solids = project.document().project().solids;
  std::vector<BlockOverride> all;
  for (const int index : blocks) {
    const auto& built = project.builtFrom().solids.at(static_cast<std::size_t>(edit.block(index).solid));
    const auto now = std::ranges::find(solids, built.name, &Solid::name);
    const Solid& solid = now == solids.end() ? built : *now;
    const BlockOverride* wish = edit.wishFor(index);
    BlockOverride& one = all.emplace_back(wish ? *wish : BlockOverride{});
    if (!one.body) one.body = solid.body;
    if (!one.material) one.material = solid.material;
  }
  return all;
}

void rename(CurrentProject& project, const Blocks& blocks, const QString& pattern) {
  const QString number = QStringLiteral("{n}"), trimmed = pattern.trimmed();
  const bool isNumbered = trimmed.contains(number);
  if (trimmed.isEmpty() || (blocks.size() > 1 && !isNumbered))
    throw InputError(QObject::tr("name of %1").arg(counted(blocks.size())).toStdString(),
                     QObject::tr("blocks must have different names").toStdString(),
                     QObject::tr("put {n} where their number shall stand: roof {n}").toStdString());
  Edit edit(project);
  int next = 1;
  for (const int block : blocks)
    edit.rename(block, QString(trimmed).replace(number, QString::number(next++)).toStdString());
  edit.finish(QObject::tr("name %1").arg(counted(blocks.size())));
}

void setBody(CurrentProject& project, const Blocks& blocks, std::optional<BodyKind> body) {
  const QString count = counted(blocks.size());
  if (body)
    setMember(project, blocks, "body", std::string(to_string(*body)),
              QObject::tr("make %1 %2").arg(count, QLatin1String(to_string(*body).data())));
  else
    setMember(project, blocks, "body", {}, QObject::tr("give %1 the body of their solids").arg(count));
}

void setMaterial(CurrentProject& project, const Blocks& blocks, const std::optional<std::string>& material) {
  setMember(project, blocks, "material", material ? Json(*material) : Json(),
            QObject::tr("change the material of %1").arg(counted(blocks.size())));
}

void setMeshSize(CurrentProject& project, const Blocks& blocks, std::optional<double> metres) {
  setMember(project, blocks, "mesh_size", metres ? Json(*metres) : Json(),
            QObject::tr("change the mesh size of %1").arg(counted(blocks.size())));
}

void excavate(CurrentProject& project, const Blocks& blocks) {
  Edit edit(project);
  for (const int block : blocks) edit.entryOf(block)["removed"] = true;
  edit.finish(QObject::tr("excavate %1").arg(counted(blocks.size())));
}

std::vector<std::string> excavated(const CurrentProject& project) {
  std::vector<std::string> names;
  for (const BlockOverride& wish : project.document().project().blocks)
    if (wish.removed) names.push_back(wish.name);
  return names;
}

void bringBack(CurrentProject& project, const std::vector<std::string>& names) {
  Json changed = project.document().json();
  for (Json& entry : changed["blocks"])
    if (std::ranges::count(names, entry.at("name").get<std::string>()) > 0) entry.erase("removed");
  project.document().change(changed, QObject::tr("bring back %1").arg(counted(names.size())));
}

void merge(CurrentProject& project, const Blocks& blocks, const std::vector<BlockFacts>& facts) {
  const auto pairs = joining_pairs(blocks, facts);
  if (pairs.empty())
    throw InputError(counted(blocks.size()).toStdString(),
                     QObject::tr("blocks that share no face cannot be one").toStdString(),
                     QObject::tr("select blocks that lie against each other").toStdString());
  Edit edit(project);
  for (const auto& [one, other] : pairs)
    if (edit.block(one).solid != edit.block(other).solid)
      throw InputError(
          edit.block(one).name + " and " + edit.block(other).name,
          QObject::tr("blocks of different solids cannot be one").toStdString(),
          QObject::tr("unite the two solids on the Geometry page, and cut what comes of it").toStdString());
  for (const auto& [one, other] : pairs)
    edit.json()["merges"].push_back(
        {{"at", edits::placeJson(edit.placeOf(one))}, {"with", edits::placeJson(inner_point(edit.block(other).mesh))}});
  edit.finish(QObject::tr("merge %1").arg(counted(blocks.size())));
}

}  // namespace talus::block_edits
