#pragma once

#include <QAction>
#include <QObject>
#include <functional>
#include <vector>

#include "orientation/attitude.hpp"

namespace talus {

struct PickedPlace;
struct Session;

/// Joints that are made, or assigned, by places which are picked in the 3-D view. Each is one step that can be undone,
/// and what was made is selected afterwards.
class JointActions : public QObject {
  Q_OBJECT
 public:
  JointActions(Session& session, QWidget& window);

  /// Asks for three places, and makes a cut through them.
  QAction* threePoints;
  /// Asks for a place on a face, and makes a cut along it.
  QAction* alongFace;
  /// Asks for a place on a face between two blocks, which then have the chosen joint between them.
  QAction* assignToFace;
  /// Two selected blocks have the chosen joint between them.
  QAction* assignBetween;
  std::vector<QAction*> all() const { return {threePoints, alongFace, assignToFace, assignBetween}; }
  /// Why one of them cannot be used now; empty when it can.
  QString whyNot(const QAction* action) const;

 private:
  QAction* add(const QString& words, const QString& icon, void (JointActions::*act)());
  void askForThreePoints();
  void askForFace();
  void askForContact();
  void assignToSelected();
  void addCut(const PlaneAttitude& plane, const Vec3& through, const QString& step);
  void assignAt(const PickedPlace& place, const QString& joint);
  void assign(int block, int other, const QString& joint);
  /// The project's joints as a menu under the pointer, for one to be chosen.
  void askForJoint(const std::function<void(const QString& joint)>& act);
  void say(const QString& place, const QString& problem, const QString& remedy, const QString& field = {});

  Session& session_;
  QWidget& window_;
};

}  // namespace talus
