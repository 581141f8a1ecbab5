#pragma once

#include <QString>

#include "document/selection.hpp"

namespace talus {

struct Project;

/// The thing that a place of the project file belongs to: "/materials/rock/density" to the material rock. None for what
/// belongs to the project as a whole, and for things that are not there.
Item itemAt(const Project& project, const QString& place);

/// A place as one says it: "material rock, young", "stage slide, time step", "cut 3, dip".
QString placeWords(const Project& project, const QString& place);

}  // namespace talus
