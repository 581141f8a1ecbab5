#pragma once

#include <QAction>
#include <QObject>
#include <vector>

#include "document/schema.hpp"
#include "mesh/picked_face.hpp"

namespace talus {

struct PickedPlace;
struct Session;

/// Loads, supports, velocities and monitors that are made by pointing at the rock. Each asks for its place in the view,
/// where it needs it for its size, and is one step that can be undone; what was made is selected.
class LoadActions : public QObject {
  Q_OBJECT
 public:
  LoadActions(Session& session, QWidget& window);

  QAction *loadAtPoint, *loadOnFace, *loadOnBlock;
  QAction *holdPoint, *holdFace, *holdBlock;
  QAction *velocity, *monitor, *stressMonitor;
  std::vector<QAction*> all() const;
  /// Why none of them can be used now; empty when they can.
  QString whyNot() const;

 private:
  using Json = schema::Json;
  QAction* add(const QString& text, const QString& icon, const QString& prompt,
               const std::function<void(const PickedPlace&)>& make);
  void makeLoad(const PickedPlace& picked);
  void makeFaceLoad(const PickedPlace& picked);
  void makeBlockLoad(const PickedPlace& picked);
  void askForLoad(int block, const Vec3& at, std::optional<PickedFace> face);
  void makeSupports(int block, const std::vector<Vec3>& points);
  void holdWhole(int block);
  void makeVelocities(const std::vector<int>& blocks);
  void makeMonitor(const PickedPlace& picked, bool stress);
  /// Each of the things becomes one of the list, and the last one is selected.
  void addThings(const char* list, const std::vector<Json>& things, const QString& what);
  void change(const QString& what, const std::function<schema::Place(Json&)>& edit);

  Session& session_;
  QWidget& window_;
};

}  // namespace talus
