#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// A place on a face of a block, or of a solid that is not cut yet.
struct PickedPlace {
  int block = -1;               ///< index into the blocks; −1 where there are none yet
  int solid = -1;               ///< index into the project's solids
  int joint = -1;               ///< of the face; −1: on no cut
  Vec3 point = Vec3::Zero();    ///< m, on the shape at rest
  Vec3 normal = Vec3::UnitZ();  ///< outwards, of unit length
  struct Moved {
    Vec3 point, normal;
  };
  std::optional<Moved> now{};  ///< the same in the frame in view; none: the rock is seen at rest

  /// As it is seen.
  Vec3 seen() const { return now ? now->point : point; }
};

/// Asks for places in the view: whoever needs some says how many and for what, and gets them when they are all there.
/// The view takes clicks for it as long as it asks, and says what it asks for; Esc ends it.
class Picking : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  using Done = std::function<void(const std::vector<PickedPlace>&)>;

  /// `prompt`: "Click the point where the load acts". What was asked for before is forgotten.
  void ask(const QString& prompt, int count, Done done);
  void take(const PickedPlace& place);
  void cancel();

  bool isAsking() const { return wanted_ > 0; }
  const QString& prompt() const { return prompt_; }
  /// Those that were taken already.
  const std::vector<PickedPlace>& soFar() const { return places_; }
  int wanted() const { return wanted_; }

 signals:
  void changed();

 private:
  QString prompt_;
  int wanted_ = 0;
  std::vector<PickedPlace> places_;
  Done done_;
};

}  // namespace talus
