#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "jobs/latest_job.hpp"
#include "model/project.hpp"
#include "render/scene/scene.hpp"
#include "session/joint_drawing.hpp"

namespace talus {

class CurrentProject;
struct SolidSurface;

/// A surface as something that a Scene draws: a block that is nothing else. `solid`: its number in the project.
Block surfaceBlock(const SolidSurface& surface, int solid, BodyKind body);
/// What is still odd in a surface, for a Scene to mark where it is.
std::vector<MarkedPlace> oddPlaces(const SolidSurface& surface);

/// The solids of the project as they are before anything is cut, for whoever shows them or asks where rock is. They are
/// made on a thread of their own soon after the solids change, each by itself: one that stays as it was is not made
/// again, and one that cannot be made leaves the others there.
class SolidSurfaces : public QObject {
  Q_OBJECT
 public:
  explicit SolidSurfaces(CurrentProject& project);
  ~SolidSurfaces() override;

  /// In the order of the project, without the solids that others are made of; null until there are some. While
  /// `isBusy()` they are those from before the last change.
  const std::vector<SolidSurface>* current() const;
  /// Around all of them; empty where `current()` is null.
  std::optional<BoxShape> extent() const;
  /// The same as blocks that are nothing but their surface, each with the number of its solid. Null where `current()`
  /// is.
  std::shared_ptr<const BlockSystem> asBlocks() const;
  /// The same for joints to be drawn in; empty where `current()` is null.
  std::shared_ptr<const std::vector<JointedRock>> jointed() const;
  /// Why some are not there; places are those of the project file.
  const std::vector<InputError>& problems() const;
  bool isBusy() const { return job_.isBusy(); }

  /// Shows what a dialog would make of the project, until it is taken back.
  void propose(std::optional<Project> proposal);
  bool isProposal() const { return proposal_.has_value(); }

 signals:
  /// `current()` or `problems()`.
  void changed();

 private:
  struct Piece;
  struct Outcome;
  static Outcome make(const std::vector<Piece>& wanted, const Outcome& earlier, Progress& progress);
  void look();

  CurrentProject& project_;
  std::optional<Project> proposal_;
  std::vector<Piece> asked_;  ///< what was last asked for, in the project's order
  std::shared_ptr<const Outcome> shown_;
  LatestJob job_;  ///< last: its thread ends before the others go
};

}  // namespace talus
