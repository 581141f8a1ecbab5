#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "document/document.hpp"
#include "mesh/block.hpp"
#include "session/project_problems.hpp"

namespace talus {

class Messages;
struct StudyRecord;

/// The project that is open: its document, the blocks that were cut out of it, and its accuracy study.
class CurrentProject : public QObject {
  Q_OBJECT
 public:
  explicit CurrentProject(Messages& messages);
  ~CurrentProject() override;

  Document& document() { return document_; }
  const Document& document() const { return document_; }
  Selection& selection() { return document_.selection(); }
  /// What is wrong with the project as it is.
  const ProjectProblems& problems() const { return problems_; }
  /// Both say a problem where the file cannot be written.
  void save();
  bool saveAs(const std::filesystem::path& file);
  /// Adds a solid whose shape is read from a file of geometry, as one change that can be undone. The file is copied
  /// beside the project where it lies elsewhere; a project that has no place yet takes the first one's. `origin`: the
  /// project's from then on, m. Throws InputError.
  void addSolid(const Solid& solid, const std::filesystem::path& file, const std::optional<Vec3>& origin = {});

  /// Blocks of the project or of the results; empty before meshing.
  std::shared_ptr<const BlockSystem> system() const { return system_; }
  /// They are what the project as it is now would be cut into; if not, the next run cuts and meshes first.
  bool systemIsCurrent() const;
  /// The project that the blocks were built from.
  const Project& builtFrom() const { return builtFrom_; }
  /// Name of a block, empty when there is none.
  QString blockName(int block) const;
  void setSystem(std::shared_ptr<const BlockSystem> system);
  /// Blocks that are set from now on are those of the project as it is now; `anew`: those that are there go.
  void beginBuilding(bool anew = false);
  /// Nothing came of it: the blocks that were there before are there again.
  void abandonBuilding();

  /// The accuracy study of the project's file, as it was when it was last looked for; null where there is none.
  const StudyRecord* study() const { return study_.get(); }
  /// Looks for it again: one may have been made meanwhile.
  void lookForStudy();
  /// Gives the project the setting of a run, as one change that can be undone; says a problem where it cannot have it.
  void useSetting(const StudyRecord& record, int run);

 signals:
  /// Another project, from a file or from results. All that belonged to the one before is gone by then.
  void opened();
  void systemChanged();
  void studyChanged();

 private:
  Messages& messages_;
  Document document_;
  ProjectProblems problems_{document_};
  std::shared_ptr<const BlockSystem> system_;
  Project builtFrom_;                           ///< the project that `system_` was, or is being, built from
  std::shared_ptr<const BlockSystem> earlier_;  ///< the blocks before those that are being built …
  Project earlierFrom_;                         ///< … and what they were built from
  std::unique_ptr<StudyRecord> study_;
  std::filesystem::path studyFolder_;  ///< where it was looked for, …
  std::filesystem::file_time_type studyWritten_ = std::filesystem::file_time_type::min();  ///< … and of when it is
};

}  // namespace talus
