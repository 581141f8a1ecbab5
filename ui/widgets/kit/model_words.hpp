#pragma once

#include <QString>
#include <QStringList>

#include "model/project.hpp"

/// What the project holds, as panels and tables say it alike.
namespace talus::words {

QString body(BodyKind kind);
/// "box", "polyhedron, 6 faces", "hill.step", "slope less tunnel".
QString shape(const SolidShape& shape);
QString stage(StageKind kind);
/// "1, 2.5, −3", four figures.
QString point(const Vec3& p, int digits = 4);
/// "3 rows, 0 … 2 s"; the table is not empty.
QString span(const TimeTable& table);

/// What a stage changes, thing by thing: "J1 φ 20°, c 0 MPa", "2 loads", "cube held".
QStringList changeList(const Stage& stage);
/// The same in one line; empty: nothing.
QString changes(const Stage& stage);

}  // namespace talus::words
