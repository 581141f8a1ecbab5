// What looking at blocks costs: how fast they turn, how much a run is slowed down by being looked at, and what it takes
// to open a thousand frames. Without a display, so all is drawn in software (OSMesa) by the processors that also solve.
//
//     bench_view turn | run | open FOLDER
#include <sys/resource.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>

#include "base/progress.hpp"
#include "geometry/block_builder.hpp"
#include "gui/example_projects.hpp"
#include "images/test_scenes.hpp"
#include "io/project_file.hpp"
#include "jobs/solver_job.hpp"
#include "render/scene/offscreen.hpp"
#include "results/field.hpp"
#include "results/result_folder.hpp"
#include "run/run.hpp"
#include "support/silent_observer.hpp"
#include "widgets/kit/language.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/window/main_window.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

double wall() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// s of all threads.
double processor() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// s of the thread that asks.
double processor_of_thread() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// MB that the process holds in memory now, without what is only a file's pages.
double held() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("RssAnon:")) return std::atof(line.c_str() + 8) / 1024;
  return 0;
}

/// A crowd of cubes of 1 m, 1.2 m apart, each of n³ cells.
BlockSystem cubes(int blocks, int n) {
  BlockSystem system;
  const int side = static_cast<int>(std::ceil(std::cbrt(blocks)));
  for (int i = 0; i < blocks; ++i) {
    const Vec3 low = 1.2 * Vec3(i % side, i / side % side, i / side / side);
    system.blocks.push_back(box("B" + std::to_string(i + 1), low, low + Vec3::Ones(), n, BodyKind::tetrahedra));
  }
  return system;
}

std::shared_ptr<Frame> moved(const BlockSystem& system, double share) {
  auto frame = std::make_shared<Frame>();
  frame->time = share;
  for (const Block& block : system.blocks) {
    for (const Vec3& node : block.mesh.nodes) frame->displacement.push_back(share * Vec3(0.01 * node.z(), 0, 0));
    frame->stress.resize(frame->stress.size() + block.mesh.tetrahedra.size(), Voigt::Constant(-1e5 * share));
  }
  frame->velocity.resize(frame->displacement.size(), Vec3::UnitX());
  return frame;
}

/// By 3° about the upright axis through what is looked at.
CameraPose turned(CameraPose pose) {
  const Eigen::AngleAxisd by(3 * M_PI / 180, Vec3::UnitZ());
  pose.position = pose.focal_point + by * (pose.position - pose.focal_point);
  pose.view_up = by * pose.view_up;
  return pose;
}

void turn(int blocks, int n) {
  const BlockSystem system = cubes(blocks, n);
  std::size_t triangles = 0;
  for (const Block& block : system.blocks) triangles += block.surface.size();
  for (const bool fine : {false, true}) {
    SceneSettings settings;
    settings.field = field_named("displacement");
    settings.fine = fine;
    Scene scene(system, settings);
    scene.set_frame(moved(system, 1));
    OffscreenView view(scene, 1280, 800, Sampling::fast);
    view.draw();
    const int pictures = fine ? 6 : 20;
    const double begin = wall(), used = processor();
    for (int i = 0; i < pictures; ++i) {
      scene.set_pose(turned(scene.pose()));
      view.draw();
    }
    std::printf("| %d | %zu | %s | %.1f | %.0f |\n", blocks, triangles, fine ? "at rest" : "while it turns",
                pictures / (wall() - begin), 1e3 * (processor() - used) / pictures);
    std::fflush(stdout);
  }
}

void turn_crowds() {
  std::puts(
      "| blocks | triangles | drawn | pictures a second | ms of the processor a picture |\n|--:|--:|---|--:|--:|");
  turn(20, 29);
  turn(5000, 1);
  turn(4167, 2);
}

/// The quarry's slab, long enough to be looked at.
std::string longer_slide() {
  std::string text = example::slope;
  const std::string once = "\"duration\": 1";
  return text.replace(text.find(once), once.size(), "\"duration\": 1.5");
}

/// Where the processor went, s.
struct Spent {
  double wall = 0, solver = 0, window = 0, drawing = 0;
};

/// s of the processor that each thread which there is has had, and what it does.
std::map<long, std::pair<std::string, double>> threads() {
  std::map<long, std::pair<std::string, double>> all;
  for (const auto& entry : fs::directory_iterator("/proc/self/task")) {
    std::ifstream name(entry.path() / "comm"), counts(entry.path() / "schedstat");
    double nanoseconds = 0;
    std::string does;
    if (std::getline(name, does) && counts >> nanoseconds)
      all[std::atol(entry.path().filename().c_str())] = {does, 1e-9 * nanoseconds};
  }
  return all;
}

Spent solve_alone(const fs::path& folder) {
  const Project project = parse_project(longer_slide());
  NoProgress nobody;
  const BlockSystem system = build_blocks(project, {}, nobody);
  SilentObserver observer;
  const double begin = wall(), used = processor_of_thread();
  run(project, system, {.out = folder / "alone.results", .project_text = longer_slide()}, observer);
  return {.wall = wall() - begin, .solver = processor_of_thread() - used};
}

/// Asleep between events, so that waiting takes no processor from what is waited for.
template <class Condition>
void wait(Condition condition) {
  QTimer tick;
  tick.start(20);
  while (!condition()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

Spent solve_in_view(const fs::path& folder) {
  const fs::path file = folder / "quarry.talus";
  std::ofstream(file) << longer_slide();
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  Session& session = window.session();
  window.open(file);
  session.run.mesh();
  wait([&] { return !session.run.job().isBusy() && session.project.system(); });
  QElapsedTimer rest;
  rest.start();
  wait([&] { return rest.elapsed() > 1500; });  // drawn finely
  const auto before = threads();
  const double begin = wall();
  session.solve();
  wait([&] { return session.run.job().isBusy(); });
  auto now = before;
  wait([&] {  // a thread that has ended tells nothing: the last look at it counts
    for (const auto& [id, thread] : threads()) now[id] = thread;
    return !session.run.job().isBusy();
  });
  Spent spent{.wall = wall() - begin};
  for (const auto& [id, thread] : now) {
    const double seconds = thread.second - (before.contains(id) ? before.at(id).second : 0);
    if (id == ::getpid())
      spent.window = seconds;
    else if (thread.first.starts_with("llvmpipe"))
      spent.drawing += seconds;
    else
      spent.solver = std::max(spent.solver, seconds);
  }
  return spent;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Pairs, of which every second begins with the window: a machine that becomes slower or faster favours neither.
void slow_down() {
  constexpr int pairs = 6;
  QTemporaryDir folder;
  const fs::path path = folder.path().toStdString();
  std::puts("| turn | alone: s | solver | looked at: s | solver | window | drawing | ratio: s | solver |");
  std::puts("|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  std::vector<double> wall_ratios, solver_ratios;
  for (int i = 1; i <= pairs; ++i) {
    Spent a, b;
    if (i % 2 == 1) a = solve_alone(path);
    b = solve_in_view(path);
    if (i % 2 == 0) a = solve_alone(path);
    wall_ratios.push_back(b.wall / a.wall);
    solver_ratios.push_back(b.solver / a.solver);
    std::printf("| %d | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.3f | %.3f |\n", i, a.wall, a.solver, b.wall,
                b.solver, b.window, b.drawing, wall_ratios.back(), solver_ratios.back());
    std::fflush(stdout);
  }
  std::printf("looked at over alone, medians of %d pairs: wall time %.3f, the solver's processor time %.3f\n", pairs,
              median(wall_ratios), median(solver_ratios));
}

constexpr int many_frames = 1000;

void write_frames(const fs::path& folder) {
  const BlockSystem system = cubes(131, 4);  // of 384 tetrahedra each: 50 304
  ResultWriter writer(folder, parse_project(example::dropped), system, example::dropped);
  for (int i = 0; i < many_frames; ++i) writer.add_frame(*moved(system, 1e-3 * i));
  writer.finish({});
}

void open_frames(const fs::path& folder) {
  if (!fs::exists(folder / "results.h5")) write_frames(folder);
  std::printf("results.h5: %.0f MB\n", static_cast<double>(fs::file_size(folder / "results.h5")) / 1e6);
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  Session& session = window.session();
  wait([&] { return true; });
  const double before = held(), begin = wall(), used = processor();
  window.open(folder);
  wait([&] { return session.playback.frame() != nullptr; });
  const double known = wall() - begin;
  window.grab();
  std::printf("opened in %.2f s (%.2f s of the processor), in view after %.2f s; %zu frames, %zu tetrahedra\n", known,
              processor() - used, wall() - begin, session.playback.times().size(),
              session.playback.frame()->stress.size());
  std::printf("memory: %.0f MB before, %.0f MB opened", before, held());
  double most = 0;
  for (int i = 0; i < 200; ++i) {
    session.playback.showFrame(i * 37 % many_frames);
    wait([&] { return !session.playback.isWaiting(); });
    most = std::max(most, held());
  }
  std::printf(", %.0f MB at most while 200 frames were looked at\n", most);
}

}  // namespace
}  // namespace talus

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  talus::setDefaultSurfaceFormat();
  QApplication app(argc, argv);
  talus::language::keepDecimalPoint();
  QTemporaryDir own;  // nobody's own settings
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, own.path());
  qputenv("XDG_STATE_HOME", own.path().toUtf8());
  talus::theme::install(false);
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "turn") {
    talus::turn_crowds();
  } else if (what == "run") {
    talus::slow_down();
  } else if (what == "open" && argc > 2) {
    talus::open_frames(argv[2]);
  } else {
    std::fputs("bench_view turn | run | open FOLDER\n", stderr);
    return 2;
  }
}
