#pragma once

#include <QFont>
#include <QIcon>
#include <QString>

#include "widgets/kit/tokens.hpp"

/// Turns the tokens into application font, palette, style sheet and icons. May be switched while the program runs.
namespace talus::theme {

/// Once after QApplication, and again to switch between light and dark.
void install(bool dark);

const Tokens& now();
inline const Colours& colours() { return now().colours; }
/// The colour of the `number`-th curve, joint or monitor; repeats after six.
const QColor& seriesColour(int number);

/// Talus Sans, or DejaVu Sans where it could not be made.
QFont font(int pixels, int weight = QFont::Normal);

/// Which token an icon takes its colour from. It is resolved when the icon is painted: a switch needs no new icons.
enum class Tone { text, muted, accent, onAccent, ok, warn, error };
QColor toneColour(Tone tone);
QIcon icon(const QString& name, Tone tone = Tone::muted);
/// A rounded square of the colour, for trees and keys.
QIcon swatch(const QColor& colour);

}  // namespace talus::theme
