#include "widgets/kit/model_words.hpp"

#include <QObject>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus::words {

QString body(BodyKind kind) {
  switch (kind) {
    case BodyKind::fixed:
      return QObject::tr("fixed");
    case BodyKind::rigid:
      return QObject::tr("rigid");
    case BodyKind::affine:
      return QObject::tr("affine");
    case BodyKind::tetrahedra:
      return QObject::tr("tetrahedra");
    case BodyKind::automatic:
      return QObject::tr("auto");
  }
  return {};
}

namespace {

QString of(const BoxShape&) { return QObject::tr("box"); }
QString of(const PolyhedronShape& shape) { return QObject::tr("polyhedron, %1 faces").arg(shape.faces.size()); }
QString of(const FileShape& shape) { return text(shape.path); }
QString of(const TerrainShape& shape) { return QObject::tr("terrain, %1").arg(text(shape.path)); }
QString of(const CylinderShape&) { return QObject::tr("cylinder"); }
QString of(const SectionShape& shape) { return QObject::tr("section, %1 corners").arg(shape.points.size()); }
QString of(const CombinedShape& shape) {
  QStringList names;
  for (const std::string& name : shape.solids) names << text(name);
  switch (shape.operation) {
    case CombineOperation::subtract:
      return names.join(QObject::tr(" less "));
    case CombineOperation::intersect:
      return QObject::tr("common to %1").arg(names.join(QObject::tr(" and ")));
    case CombineOperation::unite:
      break;
  }
  return names.join(QObject::tr(" and "));
}

}  // namespace

QString shape(const SolidShape& shape) {
  return std::visit([](const auto& one) { return of(one); }, shape);
}

QString stage(StageKind kind) { return kind == StageKind::static_ ? QObject::tr("static") : QObject::tr("dynamic"); }

QString point(const Vec3& p, int digits) {
  const auto number = [&](double coordinate) { return numbers::significant(coordinate, digits); };
  return QStringLiteral("%1, %2, %3").arg(number(p.x()), number(p.y()), number(p.z()));
}

QString span(const TimeTable& table) {
  return QObject::tr("%1, %2 … %3 s")
      .arg(numbers::counted(table.size(), "row"), numbers::significant(table.front().time, 4),
           numbers::significant(table.back().time, 4));
}

namespace {

QString strength(const JointChange& change) {
  QStringList parts;
  const auto say = [&](const QString& words, const std::optional<double>& value, double scale) {
    if (value) parts << words.arg(numbers::figure(*value / scale, 4));
  };
  say(QObject::tr("φ %1°"), change.friction_angle, 1);
  say(QObject::tr("residual φ %1°"), change.residual_friction_angle, 1);
  say(QObject::tr("c %1 MPa"), change.cohesion, 1e6);
  say(QObject::tr("tension %1 MPa"), change.tensile_strength, 1e6);
  return text(change.name) + u' ' + parts.join(QStringLiteral(", "));
}

/// For a list that a stage puts in the place of the one before.
QString replaced(const auto& list, const char* noun) {
  return list.empty() ? QObject::tr("no %1").arg(numbers::nounFor(0, noun)) : numbers::counted(list.size(), noun);
}

}  // namespace

QStringList changeList(const Stage& stage) {
  QStringList all;
  for (const auto& joint : stage.joints) all << strength(joint);
  if (stage.loads) all << replaced(*stage.loads, "load");
  if (stage.constraints) all << replaced(*stage.constraints, "support");
  for (const auto& block : stage.blocks)
    all << QObject::tr("%1 %2").arg(text(block.name),
                                    block.body == BodyKind::fixed ? QObject::tr("held") : QObject::tr("let go"));
  if (stage.damping) all << QObject::tr("damping %1 1/s").arg(numbers::figure(*stage.damping, 4));
  return all;
}

QString changes(const Stage& stage) { return changeList(stage).join(QStringLiteral("; ")); }

}  // namespace talus::words
