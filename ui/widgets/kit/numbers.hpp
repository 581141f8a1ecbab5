#pragma once

#include <QString>
#include <concepts>
#include <string>

/// Numbers as the window writes them, on top of render/numbers.hpp, so that panels and pictures agree.
namespace talus::numbers {

QString fixed(double value, int decimals);
QString whole(std::integral auto value) { return fixed(static_cast<double>(value), 0); }
/// `noun` for so many, in the user's language: "frame", "frames". Those that can be translated are listed in
/// numbers.cpp.
QString nounFor(int count, const char* noun);
/// "1 frame", "201 frames".
QString counted(std::integral auto count, const char* noun) {
  return whole(count) + u' ' + nounFor(static_cast<int>(count), noun);
}
QString significant(double value, int figures = 3);
/// The same without zeros at its end: 2, not 2.000000.
QString figure(double value, int figures);
constexpr int all_figures = 12;  // of a number in a field
/// As a field shows it, to be typed over: so many figures at most, "2600", "1e-5", "−3".
QString inField(double value, int figures = all_figures);
/// What the core says, with its numbers as the window writes them: "1e6 m, -1.73 off" → "1 000 000 m, −1.73 off".
QString inSentence(const std::string& sentence);
/// With the prefix that suits it: "25 GPa", "0.2 MPa"; `unit` is SI.
QString quantity(double value, const char* unit);
/// What values are divided by, and the unit that they have then.
struct Scale {
  double factor = 1;
  QString unit;
};
/// µJ to TJ, for values up to `largest` J.
Scale energyScale(double largest);
/// The same for `unit`, SI: µm to m, µm/s to m/s, Pa to GPa.
Scale scaleOf(double largest, const char* unit);
/// "34/270", dip and three digits of dip direction, degrees.
QString orientation(double dip, double dipDirection);
/// "12 s", "4 min 10 s" (rounded to 5 s above a minute), "1 h 47 min".
QString duration(double seconds);
/// Parses what a user typed with point or comma, thin spaces and a true minus sign; false when it is no number.
bool parse(const QString& text, double& value);

}  // namespace talus::numbers
