#include "widgets/kit/model_words.hpp"

#include <QObject>

#include "widgets/kit/numbers.hpp"

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

QString stage(StageKind kind) { return kind == StageKind::static_ ? QObject::tr("static") : QObject::tr("dynamic"); }

QString point(const Vec3& p) {
  return QStringLiteral("%1, %2, %3")
      .arg(numbers::significant(p.x(), 4), numbers::significant(p.y(), 4), numbers::significant(p.z(), 4));
}

QString span(const TimeTable& table) {
  return QObject::tr("%1, %2 … %3 s")
      .arg(numbers::counted(table.size(), "row"), numbers::significant(table.front().time, 4),
           numbers::significant(table.back().time, 4));
}

}  // namespace talus::words
