#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jobs/outside_run.hpp"
#include "jobs/solver_parts.hpp"
#include "results/checkpoint.hpp"
#include "results/run_report.hpp"

namespace talus {

class CurrentProject;
class Messages;
class Playback;
class SolverJob;
struct JobEnd;
struct JobNews;
struct ResultsIndex;

/// The run that goes on, or whose results are open: its job, what its steps and monitors came to, its report.
class CurrentRun : public QObject {
  Q_OBJECT
 public:
  CurrentRun(CurrentProject& project, Playback& playback, Messages& messages, SolverParts parts);
  ~CurrentRun() override;

  SolverJob& job() { return *job_; }
  /// Blocks are being cut, or a run goes on.
  bool isBusy() const;
  /// Empty when the project can be meshed, or solved; otherwise why not.
  QString whyNotMesh() const;
  QString whyNotSolve() const;
  void mesh();
  /// Of a project that has a file: its results lie beside it.
  void solve();
  /// Where a run of the project as it is now, or of one with less to come, was stopped or killed and can go on: the
  /// moment of its checkpoint [s]. None: there is no such run.
  const std::optional<double>& checkpoint() const { return checkpoint_; }
  /// From there, where solve() may.
  void goOn();
  /// Stops meshing or the run, also one of another process, after its step.
  void stop();
  /// Empty when there is something that can be stopped; otherwise why not.
  QString whyNotStop() const;
  /// More is to come than blocks that are cut.
  bool canLeave() const;
  /// Of a run that goes on: as soon as its blocks are cut and its step is made, it goes on in a process that outlives
  /// this one; then comes left().
  void leave();
  /// A run that another process makes of this project, or into the results that are open.
  const OutsideRun& outside() const { return *outside_; }
  /// Nothing is known of a run; one of the project as it is now may begin.
  void clear();

  /// Last news of the job, or of the other process: fraction and words.
  double fraction() const;
  const QString& activity() const { return activity_; }

  /// Of the step that is being made: open–close iterations so far, 0 where none is, and the force out of balance, N.
  int iterations() const { return iterations_; }
  double unbalanced() const { return unbalanced_; }

  const std::vector<StepReport>& steps() const { return steps_; }
  const std::vector<HistoryRow>& history() const { return history_; }
  const std::vector<Event>& events() const { return events_; }
  const std::vector<std::string>& stageNames() const { return stageNames_; }
  const std::vector<std::string>& monitorNames() const { return monitorNames_; }
  const std::optional<RunReport>& report() const { return report_; }
  /// The project as it is now was run to its end; its results are open.
  bool isDone() const;
  /// In what the run that has ended falls short: "stopped at 0.3 s", "1 of 2 expected values missed"; empty: in
  /// nothing.
  QString shortfall() const;
  /// What the effects of the project as it is now will be paid for; empty until its blocks are cut.
  std::vector<EffectCost> effectCosts() const;
  /// What each effect of the run has cost so far, or did; empty while nothing is known of it.
  const std::vector<EffectOutcome>& effects() const { return effects_; }
  /// Where the run has trouble to converge, or had, the hardest place first.
  const std::vector<ConvergenceTrouble>& troubles() const { return troubles_; }

 signals:
  void progressed();
  void historyChanged();  ///< steps or monitors came
  void reportChanged();
  void effectsChanged();  ///< what they will cost, or cost
  void troublesChanged();
  void checkpointChanged();
  void outsideChanged();  ///< a run of another process has begun, come further, or ended
  void left();            ///< the run goes on without this process, or has ended by itself

 private:
  enum class Start { meshing, run, runFromCheckpoint };
  void start(Start what);
  /// The run whose results lie beside the project; one that was killed is as one that was stopped.
  struct KeptRun {
    CheckpointLabel label;
    RunStatus status;
  };
  static bool mayGoOn(const KeptRun& run, const std::string& text);
  void watchOutside();
  void takeOutside();
  bool handOver(const JobEnd& end);
  void readCheckpoint();
  void findCheckpoint();
  void keepStepsBefore(const JobNews& news);
  void takeNews(const JobNews& news);
  void takeEnd(const JobEnd& end);
  void takeReport(const RunReport& report);
  void takeTroubles(const std::vector<ConvergenceTrouble>& troubles);
  void takeResults(const ResultsIndex& index, bool afterRun);

  CurrentProject& project_;
  Playback& playback_;
  Messages& messages_;
  std::unique_ptr<SolverJob> job_;
  std::unique_ptr<OutsideRun> outside_;
  OutsideTask task_;      ///< what another process could go on with; empty: blocks are cut alone
  bool leaving_ = false;  ///< it is to do so
  int looks_ = 0;         ///< at the run of another process
  double fraction_ = 0, unbalanced_ = 0;
  int iterations_ = 0;
  QString activity_;
  std::optional<SceneSize> size_;     ///< of the project's blocks
  std::optional<KeptRun> kept_;       ///< none without a checkpoint
  std::optional<double> checkpoint_;  ///< s
  std::vector<StepReport> steps_;
  std::vector<HistoryRow> history_;
  std::vector<Event> events_;
  std::vector<std::string> stageNames_, monitorNames_;
  std::optional<RunReport> report_;
  std::vector<EffectOutcome> effects_;
  std::vector<ConvergenceTrouble> troubles_;
};

}  // namespace talus
