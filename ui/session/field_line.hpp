#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "measures/line_probe.hpp"

namespace talus {

class CurrentProject;
class Display;
class Picking;
class Playback;
enum class Theme;

/// The field that is shown, in the frame in view, along a line between two points that are picked.
class FieldLine : public QObject {
  Q_OBJECT
 public:
  FieldLine(CurrentProject& project, Playback& playback, Display& display, Picking& picking);

  /// Whether there is a frame in which a line can be followed.
  bool isPossible() const;
  /// Asks for both ends in the view.
  void ask(const QString& prompt);
  /// No line any more.
  void remove();
  /// m; none: not chosen yet. The view draws it.
  const std::optional<std::array<Vec3, 2>>& ends() const;
  const Field& field() const;
  /// Empty without a line, and where it meets no rock.
  LineProbe probe() const;
  /// As `probe_csv`.
  std::string table() const;
  Theme theme() const;

 signals:
  /// The line, the field, the frame, or how it is drawn.
  void changed();

 private:
  void draw(const std::optional<std::array<Vec3, 2>>& ends);

  CurrentProject& project_;
  Playback& playback_;
  Display& display_;
  Picking& picking_;
};

}  // namespace talus
