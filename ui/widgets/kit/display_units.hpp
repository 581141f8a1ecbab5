#pragma once

#include <QString>
#include <QStringList>
#include <vector>

/// In which units the window shows what the project keeps in SI and degrees: a setting of the user.
namespace talus::units {

/// A quantity whose unit can be chosen; the first of the units means what each field usually shows.
struct Choice {
  QString quantity;  ///< "stress"
  QString title;
  QStringList units;
};
const std::vector<Choice>& choices();

QString chosen(const QString& quantity);  ///< empty: as usual
void choose(const QString& quantity, const QString& unit);

/// The unit to show for one that the project keeps, "Pa", "Pa/m" or "°"; `usual` is what the field shows where nothing
/// was chosen, empty: the same.
QString shown(const QString& kept, const QString& usual = {});
/// For the status bar: "m · kN · MPa · °".
QString summary();

}  // namespace talus::units
