#pragma once

#include <QString>

#include "document/selection.hpp"

namespace talus {

struct Project;

/// The thing that a place of the project file belongs to: "/materials/rock/density" to the material rock. None for what
/// belongs to the project as a whole, and for things that are not there.
Item itemAt(const Project& project, const QString& place);

/// A place in the words of the window's forms: "material rock, Young E", "stage slide, time step", "support 2, at, z".
/// What is no place of a project file is said as it is.
QString placeWords(const Project& project, const QString& place);

}  // namespace talus
