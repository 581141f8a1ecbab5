// What detection costs a step, and how much of it follows motion: the table of docs/contact.md.
//   build/release/tests/bench/bench_contact_work

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/parallel.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Scene;

/// The same number for the same bits of everything that detection hands out.
class Digest {
 public:
  void add(const ContactSet& contacts) {
    for (const ContactPoint& p : contacts.points) {
      add(&p.key, sizeof p.key);
      for (const Vec3& v : {p.position, p.normal, p.shear_start}) add(v.data(), 3 * sizeof(double));
      const std::array numbers = {
          p.gap, p.initial_interference, p.area, p.normal_stiffness, p.friction, p.cohesion, p.multiplier};
      add(numbers.data(), sizeof numbers);
      add(&p.joint, sizeof p.joint);
    }
    add(contacts.nodes.data(), contacts.nodes.size() * sizeof(int));
    add(contacts.weights.data(), contacts.weights.size() * sizeof(double));
  }
  std::uint64_t value() const { return value_; }

 private:
  void add(const void* data, std::size_t size) {  // FNV-1a
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 1099511628211u;
  }
  std::uint64_t value_ = 14695981039346656037u;
};

/// Moves, detects and accepts. Prints milliseconds of processor time and what was looked at, a step after the first.
void measure(const char* name, Scene scene, double reach, int steps, const std::function<void(Scene&, int)>& move) {
  Digest digest;
  std::clock_t clocks = 0;
  ContactWork first;
  for (int step = 0; step <= steps; ++step) {
    move(scene, step);
    const std::clock_t begin = std::clock();
    digest.add(scene.detect(reach));
    accept_as_stuck(scene);
    if (step == 0) {
      first = scene.detector().work();
    } else {
      clocks += std::clock() - begin;
    }
  }
  const ContactWork& work = scene.detector().work();
  const auto a_step = [&](long all, long before) { return static_cast<double>(all - before) / steps; };
  std::printf("| %s | %.0f | %.3f | %.1f | %.1f | %.0f | %016lx |\n", name, a_step(work.points, first.points),
              1e3 * static_cast<double>(clocks) / CLOCKS_PER_SEC / steps, a_step(work.body_pairs, first.body_pairs),
              a_step(work.searches, first.searches), a_step(work.facet_pairs, first.facet_pairs), digest.value());
}

Scene slope() {
  Scene scene;
  scene.young = 25e9;
  scene.add(box({-100, -400, -100}, {200, 400, 0}, {4, 8, 1}), true);
  scene.add(box({-100, -400, 0}, {0, 0, 80}, {1, 2, 1}), true);
  scene.add(box({0, -350, 0}, {130, -20, 64}, {2, 5, 1}, true));
  scene.add(box({0, -20, 0}, {130, 220, 64}, {1, 1, 1}, true));
  return scene;
}

/// n × n × layers cubes of 48 triangles, `apart` from each other, on a slab.
Scene cubes(int n, int layers, double apart) {
  Scene scene;
  const double side = n * (1 + apart) + 2;
  scene.add(box({-1, -1, -1}, {side, side, 0}, {n, n, 1}), true);
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec3 lower(i * (1 + apart), j * (1 + apart), k * (1 + apart) + (k == 0 ? 0 : 1e-6));
        scene.add(box(lower, lower + Vec3(1, 1, 1), {2, 2, 2}, (i + j + k) % 2));
      }
  return scene;
}

/// All but the slab move a little, each its own way.
void tremble(Scene& scene, int step, double most) {
  std::mt19937 random(step);
  std::uniform_real_distribution<double> way(-most, most);
  for (int b = 1; b < static_cast<int>(scene.bodies().size()); ++b)
    scene.move(b, {way(random), way(random), way(random)});
}

/// One of 1 + n cubes on a slab slides, the others sleep from the second step on.
void measure_beside_sleepers(const char* name, int sleepers) {
  Scene scene;
  scene.settings.motion_told = true;
  scene.add(box({-2, -2, -1}, {102, 102, 0}, {2, 2, 1}), true);
  for (int i = 0; i <= sleepers; ++i) {
    const Vec3 lower(3 * (i % 32), i == sleepers ? 97 : 3.0 * (i / 32), -1e-5);
    scene.add(box(lower, lower + Vec3(1, 1, 1), {2, 2, 2}));
  }
  measure(name, std::move(scene), 1e-3, 2000, [](Scene& s, int step) {
    const int last = static_cast<int>(s.bodies().size()) - 1;
    if (step == 1) {
      std::vector<char> asleep(s.bodies().size(), 1);
      asleep[0] = asleep[last] = 0;
      s.detector().set_asleep(asleep);
    }
    s.move(last, {1e-3, 0, 0});
    if (step > 0) s.detector().moved(last, 1e-3);
  });
}

/// The shortest of many steps on each number of threads, in turns: what else runs on the machine only adds to it.
void measure_threads(const char* name, Scene scene, double reach, int rounds, double most) {
  std::vector<int> threads;
  for (int n = 1; n <= static_cast<int>(std::thread::hardware_concurrency()); n *= 2) threads.push_back(n);
  std::vector<double> least(threads.size(), std::numeric_limits<double>::infinity());
  for (int step = 0; step <= rounds * static_cast<int>(threads.size()); ++step) {
    const std::size_t turn = step % threads.size();
    tremble(scene, step, most);
    const ThreadLimit limit(threads[turn]);
    const auto begin = std::chrono::steady_clock::now();
    scene.detect(reach);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (step > 0) least[turn] = std::min(least[turn], seconds.count());
    accept_as_stuck(scene);
  }
  std::printf("\n%s, ms of wall time, the shortest step:\n", name);
  for (std::size_t i = 0; i < threads.size(); ++i) std::printf("%d threads: %.1f\n", threads[i], 1e3 * least[i]);
}

void run() {
  std::printf(
      "| scene | points | ms | pairs of bodies measured | of them searched | pairs of facets looked at | digest |\n"
      "|---|---|---|---|---|---|---|\n");
  measure("slope of Jiweishan's kind, 0.05 m a step", slope(), 1.0, 400, [](Scene& s, int) {
    s.move(2, {0, 0.05, 0});
    s.move(3, {0, 0.06, 0});
  });
  measure("the same, 0.8 m a step", slope(), 1.0, 400, [](Scene& s, int) {
    s.move(2, {0, 0.8, 0});
    s.move(3, {0, 0.8, 0});
  });
  measure("100 cubes touching", cubes(5, 4, 0), 1e-3, 100, [](Scene& s, int step) { tremble(s, step, 1e-6); });
  measure("100 cubes touching, and one flies", cubes(5, 4, 0), 1e-3, 100, [](Scene& s, int step) {
    tremble(s, step, 1e-6);
    s.move(100, {0, 0, step == 0 ? 2 : 0.05});
  });
  measure("1 000 cubes far apart", cubes(10, 10, 2), 1e-3, 100, [](Scene&, int) {});
  measure("1 000 cubes far apart, all move", cubes(10, 10, 2), 1e-3, 100,
          [](Scene& s, int step) { tremble(s, step, 2e-3); });
  measure("1 000 cubes far apart, one flies", cubes(10, 10, 2), 1e-3, 100, [](Scene& s, int) {
    s.move(1000, {0, 0, 0.05});
  });
  measure_beside_sleepers("a cube slides", 0);
  measure_beside_sleepers("a cube slides beside 1 000 asleep", 1000);
  measure_threads("300 cubes touching", cubes(10, 3, 0), 1e-3, 40, 1e-6);
}

}  // namespace
}  // namespace talus

int main() { talus::run(); }
