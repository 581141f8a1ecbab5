#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "document/document.hpp"
#include "render/scene.hpp"
#include "run/live_frames.hpp"
#include "run/results_loader.hpp"
#include "run/solver_job.hpp"
#include "study/accuracy/study_record.hpp"
#include "widgets/step.hpp"

namespace talus {

/// Something the user should know: what, where, remedy.
struct Problem {
  enum class Severity { info, warning, error };
  Severity severity = Severity::error;
  QString place, problem, remedy;
  std::optional<Struggle> where{};  ///< to be shown in the view
};

/// What the window works on and shows now: document, run and results, the frame in view and how it is coloured.
/// Widgets ask for changes here and repaint on its signals; they do not know each other.
class Workspace : public QObject {
  Q_OBJECT
 public:
  explicit Workspace(SolverSteps steps, QObject* parent = nullptr);

  Document& document() { return document_; }
  Selection& selection() { return document_.selection(); }
  SolverJob& job() { return job_; }

  /// A project file or a results folder. Reports a problem, and changes nothing, when it cannot be opened.
  bool open(const std::filesystem::path& path);
  void save();
  bool saveAs(const std::filesystem::path& file);

  Step step() const { return step_; }
  void goTo(Step step);

  /// Empty when the project can be meshed, or solved; otherwise why not.
  QString whyNotMesh() const;
  QString whyNotSolve() const;
  void mesh();
  void solve();

  /// Blocks of the project or of the results; empty before meshing.
  std::shared_ptr<const BlockSystem> system() const { return system_; }
  /// They are what the project as it is now would be cut into; if not, the next run cuts and meshes first.
  bool systemIsCurrent() const;
  /// What the effects of the project as it is now will be paid for; empty until its blocks are cut.
  std::vector<EffectCost> effectCosts() const;
  /// Name of a block, empty when there is none.
  QString blockName(int block) const;

  // The frames of the run that goes on, or of the results.
  bool isLive() const { return live_; }
  /// The frames belong to the project as it is now; false after it was edited.
  bool resultsAreCurrent() const { return resultsAreCurrent_; }
  const std::vector<double>& frameTimes() const { return times_; }
  int frameNumber() const { return number_; }
  /// s, of the frame in view; 0 without one.
  double time() const { return frame_ ? frame_->time : 0; }
  std::shared_ptr<const Frame> frame() const { return frame_; }
  /// Shows a frame as soon as it is read; the newest of a live run is followed from then on.
  void showFrame(int number);
  /// The frame nearest to this moment, s.
  void showTime(double seconds);
  /// A results folder is being opened.
  bool isLoadingResults() const { return loading_; }
  /// A frame has been asked for and is not there yet.
  bool isWaitingForFrame() const { return waiting_; }

  const std::vector<StepReport>& steps() const { return steps_; }
  const std::vector<HistoryRow>& history() const { return history_; }
  const std::vector<Event>& events() const { return events_; }
  const std::vector<std::string>& stageNames() const { return stageNames_; }
  const std::vector<std::string>& monitorNames() const { return monitorNames_; }
  const std::optional<RunReport>& report() const { return report_; }
  /// What each effect of the run has cost so far, or did; empty while nothing is known of it.
  const std::vector<EffectOutcome>& effects() const { return effects_; }
  /// Where the run struggles or struggled, the hardest place first.
  const std::vector<Struggle>& struggles() const { return struggles_; }
  /// Selects the blocks of a struggle and lets the view go there.
  void showStruggle(const Struggle& struggle);
  /// Last news of the job: fraction and words.
  double fraction() const { return fraction_; }
  const QString& activity() const { return activity_; }
  /// Where the results lie on disk; empty while there are none.
  const std::filesystem::path& resultsFolder() const { return resultsFolder_; }
  /// Reads frames for a film on another thread: from disk, or those of the live run that are kept.
  std::function<std::shared_ptr<const Frame>(int)> frameSource() const;

  /// The accuracy study of the project's file, as it was when it was last looked for; empty where there is none.
  const std::optional<StudyRecord>& study() const { return study_; }
  /// Looks for it again: one may have been made meanwhile.
  void lookForStudy();
  /// Gives the project the setting of a run, as one change that can be undone; says a problem where it cannot have it.
  void useSetting(const StudyRecord& record, int run);

  /// While a picture or film is written no run may start.
  void setExporting(bool exporting);

  const SceneSettings& display() const { return display_; }
  void setDisplay(const SceneSettings& display);
  /// Whether the legend spans the frames seen so far or the one in view alone.
  bool rangeFollowsRun() const { return rangeFollowsRun_; }
  void setRangeFollowsRun(bool follows);
  bool isDark() const { return display_.theme == Theme::dark; }
  void setDark(bool dark);

  const std::vector<Problem>& problems() const { return problems_; }
  void addProblem(const Problem& problem);
  void log(const QString& line) { emit logged(line); }

 signals:
  void stepChanged();
  void projectOpened();
  void systemChanged();
  void framesChanged();   ///< how many, or which
  void frameChanged();    ///< the one in view
  void historyChanged();  ///< steps or monitors came
  void reportChanged();
  void effectsChanged();  ///< what they will cost, or cost
  void strugglesChanged();
  void struggleWanted(const talus::Struggle& struggle);  ///< the view should go there
  void studyChanged();
  void progressed();
  void displayChanged();
  void themeChanged();
  void problemsChanged();
  void problemAdded(const talus::Problem& problem);
  void logged(const QString& line);

 private:
  bool openProject(const std::filesystem::path& file);
  bool openResults(const std::filesystem::path& folder);
  void forgetResults();
  void start(bool solve);
  void takeNews(const JobNews& news);
  void takeStruggles(const std::vector<Struggle>& struggles);
  void takeEnd(const JobEnd& end);
  void loadResults(const std::filesystem::path& folder);
  void takeIndex(const ResultsIndex& index);
  void takeFrame(std::shared_ptr<const Frame> frame);
  void setSystem(std::shared_ptr<const BlockSystem> system);
  void namesFromProject();

  Document document_;
  SolverJob job_;
  ResultsLoader loader_;
  LiveFrames liveFrames_;

  Step step_ = Step::geometry;
  std::shared_ptr<const BlockSystem> system_;
  std::optional<SceneSize> size_;  ///< of `system_`
  Project builtFrom_;              ///< the project that `system_` was, or is being, built from
  std::shared_ptr<const Frame> frame_;
  std::vector<double> times_;
  int number_ = -1;
  bool live_ = false, following_ = true, waiting_ = false, loading_ = false, resultsAreCurrent_ = false,
       exporting_ = false;
  std::optional<double> wantedTime_;  ///< to go on looking at when results take the place of live frames
  std::filesystem::path resultsFolder_;

  std::vector<StepReport> steps_;
  std::vector<HistoryRow> history_;
  std::vector<Event> events_;
  std::vector<std::string> stageNames_, monitorNames_;
  std::optional<RunReport> report_;
  std::vector<EffectOutcome> effects_;
  std::vector<Struggle> struggles_;
  std::optional<StudyRecord> study_;
  std::filesystem::path studyFolder_;  ///< where it was looked for, …
  std::filesystem::file_time_type studyWritten_ = std::filesystem::file_time_type::min();  ///< … and of when it is
  double fraction_ = 0;
  QString activity_;

  SceneSettings display_;
  bool rangeFollowsRun_ = true;
  ValueRange seen_;
  std::vector<Problem> problems_;
};

}  // namespace talus
