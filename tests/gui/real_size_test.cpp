// A real size: terrain of 200 × 200 points, three sets of ten planes, a thousand blocks. The whole way through the
// window, with the longest event of each phase.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "driven_window.hpp"
#include "geometry/mesh_estimate.hpp"
#include "geometry/waiting_mesher.hpp"
#include "listed_runs.hpp"
#include "mesh/volume_sum.hpp"
#include "widgets/blocks/rule_dialog.hpp"
#include "widgets/run/cost_ahead.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

constexpr int points = 200;           // of the terrain, along each side
constexpr double cell = 0.5;          // m
constexpr double base = -50;          // m, level of the underside
constexpr double most_ms = 100;       // of the window's own work in an event
constexpr int cut_limit_ms = 200000;  // beside whatever else the machine does

/// A slope that falls eastwards with spurs and gullies; waves by chance make it rough.
class Relief {
 public:
  explicit Relief(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
    for (int i = 0; i < 12; ++i) {
      const double length = between(6, 40), way = between(0, 2 * std::numbers::pi), phase = between(0, 6);
      const double number = 2 * std::numbers::pi / length;
      waves_.push_back({number * std::cos(way), number * std::sin(way), phase, 0.03 * length});
    }
  }
  double operator()(double x, double y) const {
    double height = 40 * (1 - x / 100) + 6 * std::sin(x * 0.11) * std::cos(y * 0.07);
    for (const Wave& wave : waves_) height += wave.height * std::sin(wave.x * x + wave.y * y + wave.phase);
    return height;
  }

 private:
  struct Wave {
    double x, y, phase, height;
  };
  std::vector<Wave> waves_;
};

/// Rock below the terrain on a fixed slab, and the three sets.
std::string hillside(const std::string& rock, double spacing, int count) {
  const auto set = [&](const char* joint, int dip, int direction) {
    const double middle = -spacing * (count - 1) / 2;
    const double d = dip * std::numbers::pi / 180, a = direction * std::numbers::pi / 180;
    const double up[] = {std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d)};
    std::string through;
    for (int i = 0; i < 3; ++i) {
      const double centre[] = {49.75, 49.75, -12};
      through += (i > 0 ? ", " : "") + std::to_string(centre[i] + middle * up[i]);
    }
    return R"({"joint": ")" + std::string(joint) + R"(", "dip": )" + std::to_string(dip) + R"(, "dip_direction": )" +
           std::to_string(direction) + R"(, "through": [)" + through + R"(], "spacing": )" + std::to_string(spacing) +
           R"(, "count": )" + std::to_string(count) + R"(, "solids": ["hill"]})";
  };
  return R"({
  "talus": 1, "name": "Hillside",
  "materials": {"gneiss": {"density": 2650, "young": 30e9, "poisson": 0.25}},
  "joints": {"foliation": {"friction_angle": 32}, "J1": {"friction_angle": 36}, "J2": {"friction_angle": 36}},
  "default_joint": "J1",
  "splinters": {"rule": "merge"},
  "solids": [{"name": "hill", "material": "gneiss", )" +
         rock + R"(},
             {"name": "ground", "material": "gneiss", "body": "fixed",
              "box": {"min": [0, 0, -55], "max": [99.5, 99.5, -50]}}],
  "cuts": [)" +
         set("foliation", 28, 95) + ",\n           " + set("J1", 78, 185) + ",\n           " + set("J2", 72, 280) +
         R"(],
  "stages": [{"name": "slide", "type": "dynamic", "time_step": 0.001, "steps": 2}],
  "output": {"every": 0.001}
})";
}

/// The longest event of the window's own work in each phase, and what was done then.
class Phases {
 public:
  template <class Action>
  void watch(const std::string& phase, const std::string& what, const Action& action) {
    watchdog_.restart();
    action();
    const double longest = watchdog_.longestWork();
    if (phases_.empty() || phases_.back().name != phase) phases_.push_back({phase, what, 0, 0});
    Phase& last = phases_.back();
    last.longest_wait = std::max(last.longest_wait, watchdog_.longestWait());
    if (longest > last.longest) last = {phase, what, longest, last.longest_wait};
    if (longest > most_ms) std::printf("  %.0f ms: %s, %s\n", longest, phase.c_str(), what.c_str());
  }
  void print() const {
    std::printf("%-28s %9s %9s  %s\n", "phase", "work ms", "wait ms", "longest event");
    for (const Phase& phase : phases_)
      std::printf("%-28s %9.1f %9.1f  %s\n", phase.name.c_str(), phase.longest, phase.longest_wait, phase.what.c_str());
  }
  void expectCalm() const {
    for (const Phase& phase : phases_) EXPECT_LT(phase.longest, most_ms) << phase.name << ": " << phase.what;
  }

 private:
  struct Phase {
    std::string name, what;
    double longest = 0, longest_wait = 0;
  };
  Watchdog watchdog_;
  std::vector<Phase> phases_;
};

class RealSize : public DrivenWindow {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers make everything several times slower";
#endif
    DrivenWindow::SetUp();
    warmUp();
    std::ofstream grid(folder / "hill.asc");
    grid << "ncols " << points << "\nnrows " << points << "\nxllcenter 0\nyllcenter 0\ncellsize " << cell
         << "\nNODATA_value -9999\n";
    const Relief relief(7);
    for (int row = points - 1; row >= 0; --row)
      for (int column = 0; column < points; ++column)
        grid << relief(column * cell, row * cell) << (column == points - 1 ? "\n" : " ");
  }
  void TearDown() override {
    if (!window) return;
    phases.print();
    phases.expectCalm();
    rusage own{}, mesher{};
    getrusage(RUSAGE_SELF, &own);
    window.reset();
    end_waiting_mesher();  // its count comes when it has ended
    getrusage(RUSAGE_CHILDREN, &mesher);
    std::printf("memory at most: window %.0f MB, mesher %.0f MB\n", own.ru_maxrss / 1e3, mesher.ru_maxrss / 1e3);
    DrivenWindow::TearDown();
  }

  /// Does something, and lets the window do what comes of it, the finely drawn view too.
  template <class Action>
  void watch(const std::string& phase, const std::string& what, const Action& action) {
    phases.watch(phase, what, [&] {
      action();
      rest(600);
    });
  }
  void go(const std::string& phase, WorkflowPage to) {
    watch(phase, std::string("page ") + pageKey(to), [&] { session->display.goTo(to); });
    keepPicture(*window, (std::string("real_size_") + pageKey(to) + ".png").c_str());
  }
  /// Cuts by the key, and waits for blocks; `stop_at`: cancels when so much is done.
  void cut(const std::string& phase, std::optional<double> stop_at = {}) {
    QElapsedTimer clock;
    clock.start();
    double share = 0;
    std::set<QString> said;
    bool goesBack = false;
    const auto told = QObject::connect(&session->run, &CurrentRun::progressed, window.get(), [&] {
      if (session->project.system() != nullptr) return;
      const double now = session->run.fraction();
      goesBack |= now < share;
      share = now;
      said.insert(session->run.activity());
    });
    watch(phase, "begun", [&] {
      QTest::keyClick(window.get(), Qt::Key_F4);
      ASSERT_EQ(session->run.job().state(), JobState::meshing);
    });
    const SolverJob& job = session->run.job();
    phases.watch(phase, "going on", [&] {
      ASSERT_TRUE(wait([&] { return !job.isBusy() || (stop_at && share >= *stop_at); }, cut_limit_ms));
    });
    QObject::disconnect(told);
    EXPECT_FALSE(goesBack);
    EXPECT_GT(said.size(), 3u) << "it says what is done: "
                               << QStringList(said.begin(), said.end()).join(QStringLiteral(", ")).toStdString();
    if (stop_at) {
      ASSERT_TRUE(session->run.job().isBusy());
      watch(phase, "cancelled", [&] {
        click(*window->findChild<QPushButton*>(QStringLiteral("primary")));
        ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }, 2000)) << "cancelling takes no time";
      });
      return;
    }
    watch(phase, "blocks come", [&] { ASSERT_NE(session->project.system(), nullptr); });
    std::printf("%s: %.1f s, %zu blocks\n", phase.c_str(), static_cast<double>(clock.elapsed()) / 1e3,
                session->project.system()->blocks.size());
  }
  QWidget& area() { return *window->viewport().findChild<QWidget*>(QStringLiteral("view area")); }
  void send(QEvent::Type type, QPointF at, Qt::MouseButton button) {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, at, area().mapToGlobal(at), moves ? Qt::NoButton : button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : button, Qt::NoModifier);
    QApplication::sendEvent(&area(), &event);
    rest(1);
  }
  /// Turns the view with the mouse.
  void turn(const std::string& phase) {
    watch(phase, "view turned", [&] {
      const QPointF from(area().width() / 2.0, area().height() / 2.0);
      send(QEvent::MouseButtonPress, from, Qt::LeftButton);
      for (int i = 1; i <= 5; ++i) send(QEvent::MouseMove, from + QPointF(8 * i, 2 * i), Qt::LeftButton);
      send(QEvent::MouseButtonRelease, from + QPointF(40, 10), Qt::LeftButton);
    });
  }
  void hover(const std::string& phase) {
    watch(phase, "pointer over the view", [&] {
      for (int i = 0; i < 5; ++i) {
        const QPointF at(area().width() * (0.3 + 0.1 * i), area().height() * 0.6);
        QMouseEvent event(QEvent::MouseMove, at, area().mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&area(), &event);
        rest(60);
      }
    });
  }
  void press(const std::string& phase, const std::string& what, Qt::Key key, Qt::KeyboardModifiers with = {}) {
    watch(phase, what, [&] { QTest::keyClick(window.get(), key, with); });
  }
  template <class Widget>
  Widget& named(const char* name) {
    auto* found = window->findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  static void choose(QComboBox& box, const char* entry) {
    const int index = box.findText(QString::fromUtf8(entry));
    ASSERT_GE(index, 0) << entry;
    box.setCurrentIndex(index);
    emit box.activated(index);
  }
  void selectBelow(const std::string& phase, const char* level) {
    press(phase, "rule asked for", Qt::Key_F, Qt::ControlModifier);
    auto* dialog = window->findChild<RuleDialog*>();
    ASSERT_NE(dialog, nullptr);
    watch(phase, "selected by rule", [&] {
      choose(*dialog->findChild<QComboBox*>(QStringLiteral("question")), "below a plane");
      auto* number = dialog->findChild<QLineEdit*>(QStringLiteral("number"));
      number->setFocus();
      number->selectAll();
      QTest::keyClicks(number, QLatin1String(level));
      QTest::keyClick(number, Qt::Key_Return);
    });
    dialog->close();
    window->activateWindow();
  }
  const Project& project() { return session->project.document().project(); }
  QUndoStack& steps() { return session->project.document().undoStack(); }

  Phases phases;
};

TEST_F(RealSize, AThousandBlocksAreCutCancelledCutLookedAtAndSolved) {
  const auto file = write(
      "hillside.talus",
      hillside(R"("body": "rigid", "terrain": {"file": "hill.asc", "base": )" + std::to_string(base) + "}", 9, 10));
  watch("open", "terrain read and shown", [&] {
    window->open(file);
    ASSERT_TRUE(wait([&] { return window->viewport().shown() != nullptr; }));
  });
  keepPicture(*window, "real_size_geometry.png");
  turn("Geometry");
  hover("Geometry");
  go("Joints", WorkflowPage::joints);
  turn("Joints");
  watch("Joints", "set selected", [&] { session->project.selection().select({Item::Kind::cut, 1}); });
  watch("Joints", "network of hundreds of discs", [&] {
    Project changed = project();
    Cut network = changed.cuts[0];
    network.spacing.reset();
    network.count.reset();
    network.network = JointNetwork{{{5, 5, -45}, {95, 95, 30}}, 0.08, 5};
    network.fisher_kappa = 12;
    changed.cuts = {network};
    session->project.document().change(changed, QStringLiteral("network"));
    ASSERT_TRUE(wait([&] { return session->joints.faces()->front().triangles.size() > 2000; }));
  });
  turn("Joints, a network");
  keepPicture(*window, "real_size_network.png");
  watch("Joints, a network", "taken back", [&] { steps().undo(); });

  go("Blocks before they are cut", WorkflowPage::blocks);
  cut("cut and cancelled", 0.1);
  EXPECT_EQ(session->project.system(), nullptr);
  cut("cut");
  EXPECT_GT(session->project.system()->blocks.size(), 900u);
  EXPECT_TRUE(volume_sum(*session->project.system()).adds_up());
  ASSERT_TRUE(wait([&] { return session->survey.facts() != nullptr; }));
  rest(600);
  keepPicture(*window, "real_size_blocks.png");

  turn("Blocks");
  hover("Blocks");
  watch("Blocks", "click on a block", [&] { QTest::mouseClick(&area(), Qt::LeftButton, {}, {400, 200}); });
  press("Blocks", "all selected", Qt::Key_A, Qt::ControlModifier);
  selectBelow("Blocks", "-20 m");
  EXPECT_GT(session->project.selection().blocks().size(), 100u);
  keepPicture(*window, "real_size_selected.png");
  press("Blocks", "hidden", Qt::Key_H);
  press("Blocks", "shown again", Qt::Key_A);
  watch("Blocks", "coloured", [&] { choose(named<QComboBox>("colour by"), "Removability"); });
  keepPicture(*window, "real_size_removability.png");
  watch("Blocks", "drawn apart", [&] { named<QSlider>("apart").setValue(10); });
  keepPicture(*window, "real_size_apart.png");
  turn("Blocks, drawn apart");
  watch("Blocks, drawn apart", "together", [&] { named<QSlider>("apart").setValue(0); });
  watch("Blocks", "coloured by block", [&] { choose(named<QComboBox>("colour by"), "Block"); });
  selectBelow("Blocks", "-20 m");
  watch("Blocks", "mesh size of many", [&] {
    auto& size = named<QLineEdit>("mesh_size");
    size.setFocus();
    QTest::keyClicks(&size, QStringLiteral("12 m"));
    QTest::keyClick(&size, Qt::Key_Return);
  });
  EXPECT_GT(project().blocks.size(), 100u);
  watch("Blocks", "taken back", [&] { steps().undo(); });
  EXPECT_TRUE(project().blocks.empty());
  EXPECT_TRUE(session->project.systemIsCurrent());

  for (const WorkflowPage page : {WorkflowPage::mesh, WorkflowPage::materials, WorkflowPage::loads,
                                  WorkflowPage::stages, WorkflowPage::geometry, WorkflowPage::joints})
    go("other pages", page);
  watch("dip changed", "document", [&] {
    Project changed = project();
    changed.cuts[2].dip -= 2;
    session->project.document().change(changed, QStringLiteral("turn cut 3"));
  });
  EXPECT_FALSE(session->project.systemIsCurrent());
  go("dip changed", WorkflowPage::blocks);
  cut("cut anew");
  const auto turned = session->project.system()->blocks.size();
  watch("dip changed back", "undo", [&] { QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier); });
  EXPECT_FALSE(session->project.systemIsCurrent());
  cut("cut after undo");
  EXPECT_GT(session->project.system()->blocks.size(), 900u);
  EXPECT_NE(session->project.system()->blocks.size(), turned);

  go("Solve", WorkflowPage::solve);
  phases.watch("Solve", "two steps", [&] {
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(session->run.job().isBusy());
    ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }, cut_limit_ms));
  });
  ASSERT_TRUE(session->run.report());
  EXPECT_EQ(session->run.report()->steps, 2);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  go("Results", WorkflowPage::results);
  watch("Results", "coloured by displacement", [&] {
    SceneSettings settings = session->display.settings();
    settings.field = field_named("displacement");
    session->display.set(settings);
  });
  keepPicture(*window, "real_size_displacement.png");
  for (const int frame : {0, 1, 2}) watch("Results", "frame", [&] { session->playback.showFrame(frame); });
  turn("Results");
}

TEST_F(RealSize, TheSameRockIsMeshedWithTetrahedraAndItsMemorySaidAhead) {
  const auto file = write("hillside.talus", hillside(R"("body": "rigid", "terrain": {"file": "hill.asc", "base": )" +
                                                         std::to_string(base) + R"(, "tolerance": 0.4})",
                                                     9, 10));
  watch("open", "terrain read and shown", [&] {
    window->open(file);
    ASSERT_TRUE(wait([&] { return window->viewport().shown() != nullptr; }));
  });
  go("Mesh before it is made", WorkflowPage::mesh);
  cut("cut");
  watch("mesh asked for", "body of the solid", [&] {
    Project changed = project();
    changed.solids[0].body = BodyKind::tetrahedra;
    changed.solids[0].mesh_size = 9;
    session->project.document().change(changed, QStringLiteral("let the hill deform"));
  });
  const std::string ahead = named<QLabel>("ahead").text().toStdString();
  std::printf("%s\n", ahead.c_str());
  EXPECT_THAT(ahead, HasSubstr("Meshed anew: about "));
  EXPECT_THAT(ahead, HasSubstr("MB"));
  const MeshEstimate estimate = mesh_estimate(project(), *session->project.system());
  cut("mesh cancelled", 0.5);
  EXPECT_NE(session->project.system(), nullptr) << "the rigid blocks are there again";
  cut("mesh");
  double tetrahedra = 0, nodes = 0;
  for (const Block& block : session->project.system()->blocks) {
    if (block.body == BodyKind::fixed) continue;
    tetrahedra += static_cast<double>(block.mesh.tetrahedra.size());
    nodes += static_cast<double>(block.mesh.nodes.size());
  }
  std::printf("%.0f tetrahedra, %.0f unknowns\n", tetrahedra, 3 * nodes);
  EXPECT_NEAR(estimate.tetrahedra / tetrahedra, 1, 0.2);
  EXPECT_NEAR(estimate.unknowns / (3 * nodes), 1, 0.2);
  keepPicture(*window, "real_size_meshed.png");
  turn("Mesh");
  choose(named<QComboBox>("measure"), "Smallest angle");
  for (const WorkflowPage page : {WorkflowPage::blocks, WorkflowPage::loads, WorkflowPage::solve})
    go("other pages", page);
}

}  // namespace
}  // namespace talus
