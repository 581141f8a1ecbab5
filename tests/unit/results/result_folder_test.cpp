#include "results/result_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "base/error.hpp"
#include "base/resident_memory.hpp"
#include "example_results.hpp"
#include "results/result_file.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// The problem that making a writer in the folder ends with; empty when there is none.
std::string problem_with(const fs::path& folder) {
  try {
    const ResultWriter writer(folder, example_project(), example_system(), "{}");
  } catch (const InputError& error) {
    EXPECT_NE(error.place().find(folder.string()), std::string::npos);
    return error.problem();
  }
  return "";
}

StepReport example_step(int i) {
  StepReport step;
  step.step = i;
  step.stage = i % 2;
  step.time = number(i, 1);
  step.time_step = number(i, 2) * 1e-300;
  step.iterations = i + 3;
  step.cuts = i + 4;
  step.contacts = i + 5;
  step.open = i + 6;
  step.stick = i + 7;
  step.slip = i + 8;
  step.asleep = i + 9;
  step.max_penetration = number(i, 3);
  step.max_relative_penetration = number(i, 4);
  step.max_displacement = number(i, 5);
  step.unbalanced_force = number(i, 6) * 1e300;
  step.phases = {number(i, 7), number(i, 8), number(i, 9), number(i, 10), number(i, 11), number(i, 12)};
  step.energy = {number(i, 13), number(i, 14), number(i, 15), number(i, 16),
                 number(i, 17), number(i, 18), number(i, 19), number(i, 20)};
  return step;
}

void expect_same(const StepReport& a, const StepReport& b) {
  EXPECT_EQ(std::tie(a.step, a.stage, a.time, a.time_step, a.iterations, a.cuts, a.contacts, a.open, a.stick, a.slip),
            std::tie(b.step, b.stage, b.time, b.time_step, b.iterations, b.cuts, b.contacts, b.open, b.stick, b.slip));
  EXPECT_EQ(a.asleep, b.asleep);
  EXPECT_EQ(std::tie(a.max_penetration, a.max_relative_penetration, a.max_displacement, a.unbalanced_force),
            std::tie(b.max_penetration, b.max_relative_penetration, b.max_displacement, b.unbalanced_force));
  const Phases &p = a.phases, &q = b.phases;
  EXPECT_EQ(std::tie(p.detect, p.assemble, p.factor, p.solve, p.update, p.write),
            std::tie(q.detect, q.assemble, q.factor, q.solve, q.update, q.write));
  const EnergyLedger &e = a.energy, &f = b.energy;
  EXPECT_EQ(std::tie(e.kinetic, e.elastic, e.potential, e.contact),
            std::tie(f.kinetic, f.elastic, f.potential, f.contact));
  EXPECT_EQ(std::tie(e.friction_dissipated, e.damping_dissipated, e.constraint_work, e.integration_loss),
            std::tie(f.friction_dissipated, f.damping_dissipated, f.constraint_work, f.integration_loss));
}

TEST(ResultFolder, BlocksComeBackExactly) {
  const TemporaryFolder temporary;
  const BlockSystem system = example_system();
  { const ResultWriter writer(temporary.path / "r", example_project(), system, "{}"); }
  const ResultReader reader(temporary.path / "r");
  EXPECT_EQ(reader.project_name(), "Two <blocks> & a slide");
  EXPECT_THAT(reader.stage_names(), testing::ElementsAre("gravity", "slide"));
  EXPECT_THAT(reader.monitor_names(), testing::ElementsAre("P1", "P, 2"));
  EXPECT_TRUE(reader.frame_times().empty());
  EXPECT_EQ(reader.system().joint_names, system.joint_names);
  EXPECT_EQ(reader.system().solids_volume, 5.25);
  ASSERT_EQ(reader.system().blocks.size(), 2u);
  for (int b = 0; b < 2; ++b) {
    const Block &read = reader.system().blocks[b], &written = system.blocks[b];
    EXPECT_EQ(std::tie(read.name, read.solid, read.material, read.body, read.volume),
              std::tie(written.name, written.solid, written.material, written.body, written.volume));
    EXPECT_EQ(read.mesh.nodes, written.mesh.nodes);
    EXPECT_EQ(read.mesh.tetrahedra, written.mesh.tetrahedra);
    ASSERT_EQ(read.surface.size(), written.surface.size());
    for (std::size_t i = 0; i < read.surface.size(); ++i) {
      EXPECT_EQ(read.surface[i].nodes, written.surface[i].nodes);
      EXPECT_EQ(read.surface[i].joint, written.surface[i].joint);
    }
  }
}

TEST(ResultFolder, FramesComeBackExactlyAfterTheRunAndWhileItGoesOn) {
  const TemporaryFolder temporary;
  const BlockSystem system = example_system();
  constexpr int count = 7;
  {
    ResultWriter writer(temporary.path, example_project(), system, "{}");
    for (int i = 0; i < count; ++i) {
      writer.add_frame(example_frame(system, i));
      const ResultReader during(temporary.path);
      ASSERT_EQ(during.frame_times().size(), i + 1u);
      for (int j = 0; j <= i; ++j) EXPECT_TRUE(same(during.frame(j), example_frame(system, j))) << j << " of " << i;
    }
  }
  const ResultReader after(temporary.path);
  ASSERT_EQ(after.frame_times().size(), static_cast<std::size_t>(count));
  for (int j = count - 1; j >= 0; --j) {
    EXPECT_EQ(after.frame_times()[j], 0.1 * j);
    EXPECT_TRUE(same(after.frame(j), example_frame(system, j))) << j;
  }
  EXPECT_THROW(after.frame(count), std::out_of_range);
  EXPECT_THROW(after.frame(-1), std::out_of_range);
}

TEST(ResultFolder, SeveralMayReadAtATimeInOneProgram) {
  const TemporaryFolder temporary;
  const BlockSystem system = example_system();
  constexpr int count = 40;
  {
    ResultWriter writer(temporary.path, example_project(), system, "{}");
    for (int i = 0; i < count; ++i) writer.add_frame(example_frame(system, i));
  }
  const auto reads = [&](const ResultReader& reader, int i) { return same(reader.frame(i), example_frame(system, i)); };
  const ResultReader view(temporary.path);
  EXPECT_TRUE(reads(view, 7));
  {
    const ResultReader film(temporary.path);
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(reads(film, i)) << i;
      EXPECT_TRUE(reads(view, count - 1 - i)) << i;
    }
  }
  for (int i = 0; i < count; ++i) EXPECT_TRUE(reads(view, i)) << i;
}

TEST(ResultFolder, StressIsKeptAsAFloat) {
  const TemporaryFolder temporary;
  const BlockSystem system = example_system();
  Frame frame = example_frame(system, 0);
  frame.stress[0][0] = 1234567.891;
  {
    ResultWriter writer(temporary.path, example_project(), system, "{}");
    writer.add_frame(frame);
  }
  EXPECT_EQ(ResultReader(temporary.path).frame(0).stress[0][0], static_cast<float>(1234567.891));
}

TEST(ResultFolder, AFrameOfAnotherSystemIsOurMistake) {
  const TemporaryFolder temporary;
  ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
  EXPECT_THROW(writer.add_frame(example_frame(example_system(1, 1), 0)), std::invalid_argument);
  EXPECT_TRUE(ResultReader(temporary.path).frame_times().empty());
}

TEST(ResultFolder, StepsAndHistoryComeBackExactlyAndATornLastLineIsLeftOut) {
  const TemporaryFolder temporary;
  ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
  std::vector<HistoryRow> history;
  for (int i = 0; i < 5; ++i) {
    writer.add_step(example_step(i));
    const auto sample = [&](int k) {
      return MonitorSample{Vec3(number(i, k), -0.0, 1e-320), Vec3(1e22, number(i, k, 1), 0.1)};
    };
    history.push_back({.time = 0.1 * i, .stage = i / 3, .monitors = {sample(1), sample(2)}});
    writer.add_history(history.back());
  }
  std::ofstream(temporary.path / "steps.csv", std::ios::app) << "6,0,0.1";
  std::ofstream(temporary.path / "history.csv", std::ios::app) << "0.5,1,1,2,3,4,5,6,7,8,9,10,11,12";  // no line break

  const ResultReader reader(temporary.path);
  const auto steps = reader.steps();
  ASSERT_EQ(steps.size(), 5u);
  for (int i = 0; i < 5; ++i) expect_same(steps[i], example_step(i));
  const auto rows = reader.history();
  ASSERT_EQ(rows.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(std::tie(rows[i].time, rows[i].stage), std::tie(history[i].time, history[i].stage));
    for (int m = 0; m < 2; ++m) {
      EXPECT_EQ(rows[i].monitors.at(m).displacement, history[i].monitors[m].displacement);
      EXPECT_EQ(rows[i].monitors.at(m).velocity, history[i].monitors[m].velocity);
    }
  }
}

TEST(ResultFolder, StressOfTheMonitorsThatRecordItComesBack) {
  const TemporaryFolder temporary;
  Project project = example_project();
  project.monitors[1].stress = true;
  project.monitors.push_back({"P3", "B1", Vec3::Zero()});
  Voigt stress;
  stress << 1e6, -2e6, 3.25e6, 1e-320, 5, -0.0;
  {
    ResultWriter writer(temporary.path, project, example_system(), "{}");
    writer.add_history({.time = 0.5,
                        .stage = 1,
                        .monitors = {{Vec3(1, 2, 3), Vec3(4, 5, 6)},
                                     {Vec3(7, 8, 9), Vec3(10, 11, 12), stress},
                                     {Vec3(13, 14, 15), Vec3(16, 17, 18)}}});
  }
  EXPECT_THAT(text_of(temporary.path / "history.csv"),
              testing::AllOf(testing::HasSubstr("\"P, 2.velocity.z [m/s]\",\"P, 2.stress.xx [Pa]\","),
                             testing::HasSubstr("\"P, 2.stress.zx [Pa]\",P3.displacement.x [m],"),
                             testing::Not(testing::HasSubstr("P1.stress"))));
  const ResultReader reader(temporary.path);
  ASSERT_EQ(reader.history_monitors().size(), 3u);
  for (int m = 0; m < 3; ++m) {
    EXPECT_EQ(reader.history_monitors()[m].name, reader.monitor_names()[m]);
    EXPECT_EQ(reader.history_monitors()[m].stress, m == 1);
  }
  const auto rows = reader.history();
  ASSERT_EQ(rows.size(), 1u);
  const auto& samples = rows[0].monitors;
  EXPECT_EQ(samples.at(1).stress.value(), stress);
  EXPECT_EQ(samples.at(2).velocity, Vec3(16, 17, 18));
  EXPECT_FALSE(samples.at(0).stress);
  EXPECT_FALSE(samples.at(2).stress);
}

TEST(ResultFolder, WhyABodyWasChosenComesBack) {
  const TemporaryFolder temporary;
  BlockSystem system = example_system();
  system.blocks[0].body = BodyKind::rigid;
  system.blocks[0].body_reason = "hard rock, ä";
  system.blocks[1].stands_on_corners = true;
  { const ResultWriter writer(temporary.path, example_project(), system, "{}"); }
  const ResultReader reader(temporary.path);
  EXPECT_EQ(reader.system().blocks[0].body, BodyKind::rigid);
  EXPECT_EQ(reader.system().blocks[0].body_reason, "hard rock, ä");
  EXPECT_EQ(reader.system().blocks[1].body_reason, "");
  EXPECT_FALSE(reader.system().blocks[0].stands_on_corners);
  EXPECT_TRUE(reader.system().blocks[1].stands_on_corners);
}

TEST(ResultFolder, TheCsvHeadersNameUnits) {
  const TemporaryFolder temporary;
  { const ResultWriter writer(temporary.path, example_project(), example_system(), "{}"); }
  EXPECT_THAT(text_of(temporary.path / "history.csv"),
              testing::StartsWith("time [s],stage,P1.displacement.x [m],P1.displacement.y [m],P1.displacement.z [m],"
                                  "P1.velocity.x [m/s],P1.velocity.y [m/s],P1.velocity.z [m/s],"
                                  "\"P, 2.displacement.x [m]\","));
  EXPECT_THAT(
      text_of(temporary.path / "steps.csv"),
      testing::StartsWith("step,stage,time [s],time step [s],iterations,cuts,contacts,open,stick,slip,asleep,"));
}

TEST(ResultFolder, LogAndProjectAreKept) {
  const TemporaryFolder temporary;
  ResultWriter writer(temporary.path, example_project(), example_system(), "{ \"talus\": 1 }\n");
  writer.log("stage gravity");
  writer.log("step 1");
  EXPECT_EQ(text_of(temporary.path / "log.txt"), "stage gravity\nstep 1\n");
  EXPECT_EQ(text_of(temporary.path / "project.talus"), "{ \"talus\": 1 }\n");
}

TEST(ResultFolder, EarlierResultsAreReplaced) {
  const TemporaryFolder temporary;
  const BlockSystem system = example_system();
  {
    ResultWriter writer(temporary.path, example_project(), system, "{}");
    writer.add_frame(example_frame(system, 0));
    writer.add_step({});
    writer.finish({});
  }
  EXPECT_EQ(problem_with(temporary.path), "");
  const ResultReader reader(temporary.path);
  EXPECT_TRUE(reader.frame_times().empty());
  EXPECT_TRUE(reader.steps().empty());
  EXPECT_FALSE(fs::exists(temporary.path / "summary.json"));
}

TEST(ResultFolder, PicturesBesideEarlierResultsStayWhenTheseAreReplaced) {
  const TemporaryFolder temporary;
  { const ResultWriter writer(temporary.path, example_project(), example_system(), "{}"); }
  std::ofstream(temporary.path / "picture.png") << "dear";
  EXPECT_EQ(problem_with(temporary.path), "");
  EXPECT_TRUE(fs::exists(temporary.path / "picture.png"));
}

TEST(ResultFolder, AFolderWithoutResultsIsRefusedAndLeftAlone) {
  const TemporaryFolder temporary;
  std::ofstream(temporary.path / "thesis.tex") << "dear";
  EXPECT_EQ(problem_with(temporary.path), "holds files that are not results");
  EXPECT_FALSE(fs::exists(temporary.path / "results.h5"));
  EXPECT_TRUE(fs::exists(temporary.path / "thesis.tex"));
}

TEST(ResultFolder, AFolderWithTheUsersOwnProjectIsRefused) {
  const TemporaryFolder temporary;
  std::ofstream(temporary.path / "project.talus") << "{}";
  EXPECT_EQ(problem_with(temporary.path), "holds files that are not results");
  EXPECT_TRUE(fs::exists(temporary.path / "project.talus"));
}

TEST(ResultFolder, AFolderThatIsAFileOrCannotBeMadeIsRefused) {
  const TemporaryFolder temporary;
  std::ofstream(temporary.path / "file") << "x";
  EXPECT_EQ(problem_with(temporary.path / "file"), "is a file, not a folder");
  EXPECT_THAT(problem_with(temporary.path / "file/below"), testing::StartsWith("cannot be made: "));
}

TEST(ResultFolder, ASecondRunDoesNotWriteWhereOneWrites) {
  const TemporaryFolder temporary;
  const ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
  EXPECT_EQ(problem_with(temporary.path), "another run writes its results there");
}

TEST(ResultFolder, WhatHoldsNoResultsIsAnInputError) {
  const TemporaryFolder temporary;
  EXPECT_THROW(ResultReader(temporary.path / "nowhere"), InputError);
  EXPECT_THROW(ResultReader reader(temporary.path), InputError);
  std::ofstream(temporary.path / "results.h5") << "not HDF5 at all";
  EXPECT_THROW(ResultReader reader(temporary.path), InputError);
}

TEST(ResultFolder, OnlyWhereARunWritesAFileThatCannotBeOpenedIsTriedAgain) {
  const TemporaryFolder temporary;
  std::ofstream(temporary.path / "results.h5") << "not HDF5 at all";
  std::chrono::steady_clock::duration quickest = std::chrono::hours(1);
  for (int attempt = 0; attempt < 20; ++attempt) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_THROW(ResultFileReader reader(temporary.path / "results.h5"), InputError);
    quickest = std::min(quickest, std::chrono::steady_clock::now() - begin);
  }
  EXPECT_LT(quickest, std::chrono::milliseconds(20)) << "the pauses of all attempts are 38 ms";
}

TEST(ResultFolder, WhateverBytesAreLostTheReaderKeepsWithinItsBounds) {
  const TemporaryFolder temporary;
  const BlockSystem system = example_system();
  {
    ResultWriter writer(temporary.path, example_project(), system, "{}");
    for (int i = 0; i < 3; ++i) writer.add_frame(example_frame(system, i));
  }
  const fs::path file = temporary.path / "results.h5";
  const std::string whole = text_of(file);
  int refused = 0;
  constexpr std::size_t damages = 1000;
  for (std::size_t i = 0; i < damages; ++i) {
    std::string bytes = whole;
    bytes.replace(i * whole.size() / damages, 8, i % 2 == 0 ? std::string(8, '\xff') : std::string(8, '\x07'));
    std::ofstream(file, std::ios::binary) << bytes.substr(0, whole.size());
    try {
      const ResultReader reader(temporary.path);
      for (std::size_t frame = 0; frame < reader.frame_times().size(); ++frame) reader.frame(static_cast<int>(frame));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100) << "no other exception, and no crash";
}

TEST(ResultFolder, ADamagedLineOfATableIsAnInputErrorWithItsNumber) {
  const TemporaryFolder temporary;
  {
    ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
    for (int i = 0; i < 3; ++i) writer.add_step(example_step(i));
  }
  std::string text = text_of(temporary.path / "steps.csv");
  text[text.find('\n') + 2] = 'x';
  std::ofstream(temporary.path / "steps.csv") << text;
  try {
    ResultReader(temporary.path).steps();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.place(), testing::HasSubstr("steps.csv: line 2"));
  }
}

TEST(ResultFolder, AFullDiskIsAnErrorWithThePath) {
  // /dev/full fails every write as a full disk does.
  const TemporaryFolder temporary;
  ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
  fs::remove(temporary.path / "summary.json.new");
  fs::create_symlink("/dev/full", temporary.path / "summary.json.new");
  try {
    writer.finish({});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("summary.json"));
  }
  EXPECT_FALSE(fs::exists(temporary.path / "summary.json"));
}

// HDF5 kept the last 521 pieces of each table, one a frame.
TEST(ResultFolder, HoldsNoFramesThatAreWritten) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers hold memory of their own";
#endif
  const TemporaryFolder folder;
  const BlockSystem system = example_system(40, 60);
  ResultWriter writer(folder.path, example_project(), system, "{}");
  const Frame frame = example_frame(system, 1);
  const auto add = [&](int count) {
    for (int i = 0; i < count; ++i) writer.add_frame(frame);
  };
  add(20);
  ASSERT_TRUE(count_resident_memory_anew());
  const double before = resident_memory().now;
  constexpr int more = 400;
  add(more);
  const double written = more * 4 * 100 * 3 * 3 * sizeof(double);
  EXPECT_GT(written, 10e6);
  EXPECT_LT(resident_memory().now - before, written / 10);
}

}  // namespace
}  // namespace talus
