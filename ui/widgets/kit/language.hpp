#pragma once

#include <QString>
#include <vector>

/// The language of the window: English, in which it is written, or one of resources/translations.
namespace talus::language {

struct Language {
  QString code, name;  ///< "de", "Deutsch"
};
const std::vector<Language>& all();

/// Code of the one that the user chose; empty: as the system has it.
QString chosen();
void choose(const QString& code);

/// What is said from now on: that of the code, or, where it is empty, the chosen one or the system's. Widgets that are
/// there already keep their words. False where there is no such language; English is spoken then.
bool install(const QString& code = {});
/// The one that is spoken.
QString now();

/// Lets the functions of C and C++ read and write numbers with a point, as files have them, whatever the system's
/// language: a QApplication has taken that over for them. To be called once there is one.
void keepDecimalPoint();

}  // namespace talus::language
