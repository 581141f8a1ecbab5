#include "jobs/solver_job.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <atomic>
#include <thread>

#include "base/error.hpp"

namespace talus {
namespace {

using namespace std::chrono_literals;

/// A solver whose steps take a known time, so that what the job adds can be seen.
struct PacedSolver {
  std::chrono::microseconds step_time = 1ms;
  int steps = 100;
  std::atomic<int> made = 0;

  SolverParts parts() {
    return {[](const Project&, const std::filesystem::path&, Progress& progress) {
              for (int i = 0; i < 10; ++i) {
                progress.report(i / 10.0, "meshing");
                if (progress.cancelled()) throw Cancelled();
                std::this_thread::sleep_for(2ms);
              }
              return BlockSystem{};
            },
            [](const Project&, const BlockSystem&) { return SceneSize{.tetrahedra = 7}; },
            [this](const Project&, const BlockSystem&, const RunOptions&, RunObserver& observer) {
              RunReport report;
              while (made < steps) {
                if (!observer.go_on()) {
                  report.status = RunStatus::stopped;
                  break;
                }
                std::this_thread::sleep_for(step_time);
                ++made;
                StepReport step;
                step.step = made;
                observer.on_step(step, {}, static_cast<double>(made) / steps);
                auto frame = std::make_shared<Frame>();
                frame->index = made;
                observer.on_frame(frame);
                observer.on_effects({{.name = "inertia", .active = true, .reason = "always", .evaluations = made}});
              }
              report.steps = made;
              return report;
            }};
  }
};

class SolverJobTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    static int argc = 1;
    static char name[] = "test_jobs";
    static char* argv[] = {name, nullptr};
    if (!QCoreApplication::instance()) new QCoreApplication(argc, argv);
  }

  void listen(SolverJob& job) {
    QObject::connect(&job, &SolverJob::newsArrived, [this](const JobNews& news) {
      ++deliveries;
      steps_seen += static_cast<int>(news.steps.size());
      frames_seen += static_cast<int>(news.frames.size());
      systems_seen += news.system ? 1 : 0;
      if (news.size) tetrahedra_seen += news.size->tetrahedra;
      if (!news.effects.empty()) evaluations_seen = news.effects.front().evaluations;
    });
    QObject::connect(&job, &SolverJob::ended, [this](const JobEnd& with) { end = with; });
  }

  template <class Condition>
  bool wait(Condition condition, std::chrono::milliseconds limit = 10s) {
    const auto until = std::chrono::steady_clock::now() + limit;
    while (!condition() && std::chrono::steady_clock::now() < until) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
      std::this_thread::sleep_for(1ms);
    }
    return condition();
  }

  PacedSolver solver;
  int deliveries = 0, steps_seen = 0, frames_seen = 0, systems_seen = 0;
  long tetrahedra_seen = 0, evaluations_seen = 0;
  std::optional<JobEnd> end;
};

TEST_F(SolverJobTest, MeshesAndSolvesAndTellsEveryStep) {
  SolverJob job(solver.parts());
  listen(job);
  job.start({});
  EXPECT_EQ(job.state(), JobState::meshing);
  ASSERT_TRUE(wait([&] { return end.has_value(); }));
  EXPECT_EQ(end->kind, JobEnd::Kind::completed);
  EXPECT_EQ(steps_seen, 100);
  EXPECT_EQ(frames_seen, 100);
  EXPECT_EQ(systems_seen, 1);
  EXPECT_EQ(tetrahedra_seen, 7) << "sized once";
  EXPECT_EQ(evaluations_seen, 100) << "as of the last frame";
  EXPECT_EQ(end->report->steps, 100);
  EXPECT_FALSE(job.isBusy());
}

TEST_F(SolverJobTest, AFastSolverDoesNotFloodTheWindow) {
  solver.step_time = 10us;
  solver.steps = 5000;
  SolverJob job(solver.parts());
  listen(job);
  JobTask task;
  task.system = std::make_shared<BlockSystem>();
  const auto begin = std::chrono::steady_clock::now();
  job.start(task);
  ASSERT_TRUE(wait([&] { return end.has_value(); }, 60s));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_EQ(steps_seen, 5000);
  EXPECT_LE(deliveries, 10 * seconds + 2);
}

TEST_F(SolverJobTest, PausesBeforeTheNextStepAndGoesOn) {
  solver.steps = 400;
  SolverJob job(solver.parts());
  listen(job);
  job.start({});
  ASSERT_TRUE(wait([&] { return steps_seen >= 20; }));
  job.pause();
  EXPECT_EQ(job.state(), JobState::paused);
  std::this_thread::sleep_for(30ms);  // the step that was being made
  const int paused_at = solver.made;
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(solver.made, paused_at);
  job.oneStep();
  ASSERT_TRUE(wait([&] { return solver.made == paused_at + 1; }));
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(solver.made, paused_at + 1);
  job.resume();
  ASSERT_TRUE(wait([&] { return end.has_value(); }));
  EXPECT_EQ(end->kind, JobEnd::Kind::completed);
  EXPECT_EQ(solver.made, 400);
}

TEST_F(SolverJobTest, StopsAfterTheStepAlsoWhenPaused) {
  for (const bool paused : {false, true}) {
    solver.made = 0;
    steps_seen = 0;
    end.reset();
    SolverJob job(solver.parts());
    listen(job);
    job.start({});
    ASSERT_TRUE(wait([&] { return steps_seen >= 5; }));
    if (paused) job.pause();
    job.stop();
    EXPECT_EQ(job.state(), JobState::stopping);
    ASSERT_TRUE(wait([&] { return end.has_value(); }));
    EXPECT_EQ(end->kind, JobEnd::Kind::stopped);
    EXPECT_LT(solver.made, 100);
  }
}

TEST_F(SolverJobTest, CancelsMeshing) {
  SolverJob job(solver.parts());
  listen(job);
  job.start({});
  job.stop();
  ASSERT_TRUE(wait([&] { return end.has_value(); }));
  EXPECT_EQ(end->kind, JobEnd::Kind::cancelled);
  EXPECT_EQ(solver.made, 0);
}

TEST_F(SolverJobTest, SaysWhatIsWrongWithTheInput) {
  SolverParts parts = solver.parts();
  parts.mesh = [](const Project&, const std::filesystem::path&, Progress&) -> BlockSystem {
    throw InputError("cut 3 (J2)", "misses every solid", "move it or delete it");
  };
  SolverJob job(parts);
  listen(job);
  job.start({});
  ASSERT_TRUE(wait([&] { return end.has_value(); }));
  EXPECT_EQ(end->kind, JobEnd::Kind::failed);
  ASSERT_TRUE(end->failure);
  EXPECT_EQ(end->failure->place(), "cut 3 (J2)");
  EXPECT_EQ(end->failure->problem(), "misses every solid");
  EXPECT_EQ(end->failure->remedy(), "move it or delete it");
}

TEST_F(SolverJobTest, OutlivesAFaultOfTheSolver) {
  SolverParts parts = solver.parts();
  parts.solve = [](const Project&, const BlockSystem&, const RunOptions&, RunObserver&) -> RunReport {
    throw std::runtime_error("singular matrix");
  };
  SolverJob job(parts);
  listen(job);
  job.start({});
  ASSERT_TRUE(wait([&] { return end.has_value(); }));
  EXPECT_EQ(end->kind, JobEnd::Kind::failed);
  ASSERT_TRUE(end->failure);
  EXPECT_EQ(end->failure->problem(), "singular matrix");
}

TEST_F(SolverJobTest, MayBeDestroyedWhileItMeshesRunsOrIsPaused) {
  solver.steps = 100000;
  for (const JobState state : {JobState::meshing, JobState::running, JobState::paused}) {
    solver.made = 0;
    int made = 0;
    {
      SolverJob job(solver.parts());
      listen(job);
      job.start({});
      if (state != JobState::meshing) {
        ASSERT_TRUE(wait([&] { return job.state() == JobState::running && solver.made > 3; }));
      }
      if (state == JobState::paused) job.pause();
      ASSERT_EQ(job.state(), state);
      made = solver.made;
    }
    EXPECT_LE(solver.made, made + 50) << "ends after the step that is being made";
    const int left = solver.made;
    std::this_thread::sleep_for(30ms);
    EXPECT_EQ(solver.made, left) << "no thread goes on by itself";
    EXPECT_FALSE(end) << "nobody is told of a job that is gone";
  }
}

}  // namespace
}  // namespace talus
