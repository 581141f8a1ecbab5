#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "jobs/latest_job.hpp"
#include "model/project.hpp"
#include "session/joint_drawing.hpp"

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

  using Faces = std::vector<JointFace>;
  /// One for every cut, in their order; made anew only where a cut, what it ends at, or the rock is another: as long as
  /// nothing changes they are the same object. Networks are drawn on a thread of their own, and come with `changed()`.
  std::shared_ptr<const Faces> faces();
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
  /// What a cut is drawn from.
  struct Source {
    Cut cut;
    std::vector<Cut> ends;  ///< those that it ends at
    std::shared_ptr<const std::vector<JointedRock>> rock;
    JointFace face() const;
    bool operator==(const Source&) const = default;
  };
  std::vector<Source> sources() const;
  void drawNetworks();
  void follow();

  CurrentProject& project_;
  SolidSurfaces& surfaces_;
  struct Trial {
    int cut;
    Cut as;
  };
  std::optional<Trial> trial_;
  std::vector<Source> made_;  ///< what `faces_` are made from, …
  std::vector<bool> late_;    ///< … but for those that are being made
  std::shared_ptr<const Faces> faces_;
  LatestJob networks_;  ///< last: its thread ends before the others go
};

}  // namespace talus
