#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "model/project.hpp"
#include "render/scene/joint_face.hpp"

namespace talus {

class CurrentProject;
class SolidSurfaces;

/// The joints as they are drawn in the rock. A cut that a hand is at is shown as it would be, everywhere, before the
/// project becomes that.
class DrawnJoints : public QObject {
  Q_OBJECT
 public:
  DrawnJoints(CurrentProject& project, SolidSurfaces& surfaces);
  ~DrawnJoints() override;

  /// One for every cut, in their order; made anew only where a cut, what it ends at, or the rock is another.
  const std::vector<JointFace>& faces();
  /// The mean place of what is drawn of a cut; empty where nothing of it is in the rock.
  std::optional<Vec3> middleOf(int cut);
  /// The cut that is selected, or those of the joint that is.
  std::vector<int> selectedCuts();
  /// The project's cuts, with the one that is tried as it would be.
  std::vector<Cut> cuts() const;

  void tryOut(int cut, const Cut& as);
  void endTrial();

 signals:
  void changed();

 private:
  struct Made {
    Cut cut;
    std::vector<Cut> ends;  ///< those that it ends at
  };
  void follow();

  CurrentProject& project_;
  SolidSurfaces& surfaces_;
  struct Trial {
    int cut;
    Cut as;
  };
  std::optional<Trial> trial_;
  std::vector<Made> made_;  ///< what `faces_` were made from
  std::vector<JointFace> faces_;
};

}  // namespace talus
