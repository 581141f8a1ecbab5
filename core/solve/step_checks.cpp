#include "solve/step_checks.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "solve/simulation_state.hpp"

namespace talus {

double shortest_part(const SimulationState& s, double length) {
  const StepTolerances& t = s.tolerances.step;
  const double speed = s.dynamic() ? s.bodies.top_speed() : 0;
  const double shortest = t.shortest_step * length, way = t.shortest_way * s.smallest_size;
  return speed * shortest > way ? way / speed : shortest;
}

int inverted_element(const SimulationState& s) {
  const auto is_inverted = [&](const Element& element) {
    Corners corners = s.bodies.corner_increments(element, s.increment);
    for (int i = 0; i < 4; ++i) corners[i] += s.bodies.nodes.position[element.nodes[i]];
    return !(element_shape(corners).volume > 0);
  };
  const auto found = std::find_if(s.bodies.elements.begin(), s.bodies.elements.end(), is_inverted);
  return found == s.bodies.elements.end() ? -1 : static_cast<int>(found - s.bodies.elements.begin());
}

bool may_look_again(const SimulationState& s) {
  const double longest = s.project.stages[s.clock.stage()].time_step;
  return s.dynamic() && s.context.length >= s.tolerances.step.shortest_recheck * shortest_part(s, longest);
}

std::span<const ContactDetector::MissedContact> missed_contacts(SimulationState& s) {
  if (!s.is_on(EffectKind::missed_contacts) || !s.company.any() || !may_look_again(s)) return {};
  const double tolerance = s.penetration();
  const Stopwatch watch(s.detect_seconds);
  const EffectTimer timer(s.work_of(EffectKind::missed_contacts));
  return s.missed_contacts.seek(s.detector, s.links, s.increment, s.reach, tolerance, tolerance * s.smallest_size,
                                s.company.alone());
}

std::optional<DeepPair> passage(SimulationState& s) {
  if (!s.passage || !s.company.any()) return std::nullopt;
  const Stopwatch watch(s.detect_seconds);
  const EffectTimer timer(s.work_of(EffectKind::missed_contacts));
  const auto known = [&](int a, int b) {
    double deepest = 0;
    for (int i = 0; i < s.links.moves().size(); ++i) {
      const ContactPoint& point = s.links.point(i);
      if (std::minmax(point.bodies[0], point.bodies[1]) == std::minmax(a, b))
        deepest = std::max(deepest, point.initial_interference - s.links.gap(i, s.increment));
    }
    return deepest;
  };
  return s.passage->find(s.increment, s.penetration(), known, s.company.alone());
}

}  // namespace talus
