#include "widgets/project/joint_rows.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/project.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int word_columns = 4, persistence_column = 2, of_the_cut = 9;
const QString dash = QStringLiteral("–");

QString figures(double value) { return numbers::significant(value); }

/// How far a cut goes: "infinite", "disc 5 m", "polygon, 4 corners"; what it ends at.
QString persistence(const Cut& cut) {
  QString words = QObject::tr("infinite");
  if (cut.disc) words = QObject::tr("disc, radius %1 m").arg(figures(cut.disc->radius));
  if (!cut.polygon.empty()) words = QObject::tr("polygon, %1 corners").arg(cut.polygon.size());
  if (cut.network)
    words = QObject::tr("network, %1 m²/m³ of %2 m").arg(figures(cut.network->density), figures(cut.network->radius));
  QStringList joints, solids;
  for (const std::string& joint : cut.ends_at) joints << text(joint);
  for (const std::string& solid : cut.solids) solids << text(solid);
  if (!joints.isEmpty()) words += QObject::tr("; ends at %1").arg(joints.join(QStringLiteral(", ")));
  if (!solids.isEmpty()) words += QObject::tr("; in %1").arg(solids.join(QStringLiteral(", ")));
  return words;
}

/// What is left to chance: "κ 90, exponential".
QString scatter(const Cut& cut) {
  QStringList words;
  if (cut.fisher_kappa) words << QObject::tr("κ %1").arg(figures(*cut.fisher_kappa));
  if (cut.spacing_law != SpacingLaw::equal) words << text(to_string(cut.spacing_law));
  return words.isEmpty() ? dash : words.join(QStringLiteral(", "));
}

QStringList strength(const Joint& joint) { return {figures(joint.friction_angle), figures(joint.cohesion / 1e6)}; }

QStringList planeOf(const Cut& cut) {
  const QString direction = QStringLiteral("%1").arg(std::lround(cut.dip_direction), 3, 10, QLatin1Char('0'));
  return {persistence(cut),
          scatter(cut),
          figures(cut.dip),
          direction,
          words::point(cut.through),
          cut.spacing ? figures(*cut.spacing) : dash,
          cut.network ? dash : QString::number(cut.count.value_or(1))};
}

using Pointer = nlohmann::ordered_json::json_pointer;

QString in(const Pointer& thing, const char* key) { return text((thing / key).to_string()); }

QStringList strengthPlaces(const Joint& joint) {
  const Pointer place = Pointer("/joints") / joint.name;
  return {in(place, "friction_angle"), in(place, "cohesion")};
}

QStringList planePlaces(const Cut& cut, size_t index) {
  const Pointer place = Pointer("/cuts") / index;
  const char* const extent = cut.disc ? "disc" : !cut.polygon.empty() ? "polygon" : cut.network ? "network" : "through";
  return {in(place, "joint"),        in(place, "joint"),   in(place, extent),
          in(place, "fisher_kappa"), in(place, "dip"),     in(place, "dip_direction"),
          in(place, extent),         in(place, "spacing"), in(place, "count")};
}

}  // namespace

PageRows jointRows(const Project& project) {
  PageRows content{QObject::tr("Joint table"),
                   {QObject::tr("Joint"), QObject::tr("Cut"), QObject::tr("Persistence"), QObject::tr("Scatter"),
                    QObject::tr("Dip °"), QObject::tr("Dir °"), QObject::tr("Through m"), QObject::tr("Spacing m"),
                    QObject::tr("Count"), QObject::tr("φ °"), QObject::tr("c MPa")},
                   word_columns,
                   {},
                   QObject::tr("The project has no joint: its solids touch without being cut."),
                   persistence_column};
  content.sortable = true;
  for (size_t j = 0; j < project.joints.size(); ++j) {
    const Joint& joint = project.joints[j];
    bool cuts = false;
    for (size_t i = 0; i < project.cuts.size(); ++i) {
      const Cut& cut = project.cuts[i];
      if (cut.joint != joint.name) continue;
      cuts = true;
      content.rows.push_back({{Item::Kind::cut, static_cast<int>(i)},
                              QStringList{text(joint.name), QString::number(i + 1)} + planeOf(cut) + strength(joint),
                              planePlaces(cut, i) + strengthPlaces(joint)});
    }
    if (!cuts)
      content.rows.push_back(
          {{Item::Kind::joint, static_cast<int>(j)},
           QStringList{text(joint.name), dash, dash, dash, dash, dash, dash, dash, dash} + strength(joint),
           QStringList(of_the_cut, QString()) + strengthPlaces(joint)});
  }
  return content;
}

}  // namespace talus
