#pragma once

#include <QObject>
#include <functional>

class QWidget;

namespace talus {

struct Session;

/// Asks before something is lost: the one place of such questions. Each says whether to go on.
class Guards : public QObject {
  Q_OBJECT
 public:
  /// `saveAs` asks for a file and saves the project there; false where it was not saved.
  Guards(Session& session, QWidget& window, std::function<bool()> saveAs);

  /// Before the window closes or another project takes this one's place: saves unsaved changes, or lets them go.
  bool mayLeaveProject();
  /// Before a run: its results take the place of those that lie beside the project. May give the old ones another name.
  bool mayReplaceResults();
  enum class OfRun { stay, stop, leave };
  /// Before the window closes while a run goes on: what is to become of it. `stop` also where it has ended meanwhile.
  OfRun askOfRun();

 private:
  bool keepResultsAs(const QString& name);

  Session& session_;
  QWidget& window_;
  std::function<bool()> saveAs_;
};

}  // namespace talus
