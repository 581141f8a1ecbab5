#include "solve/stress_recovery.hpp"

namespace talus {

std::vector<Voigt> StressRecovery::all() const {
  count_ += static_cast<long>(bodies_.moving.size());
  std::vector<Voigt> stress(bodies_.elements.size(), Voigt::Zero());
  for (const auto& effect : composition_.effects) effect->add_stress(stress);
  return stress;
}

std::vector<Voigt> StressRecovery::of_body(int index, const std::vector<Voigt>& all) const {
  const Body& body = bodies_.bodies[index];
  if (body.fixed) return bodies_.stress_of_held(index);
  const auto first = all.begin() + body.first_element;
  return {first, first + body.element_count};
}

Voigt StressRecovery::at(const MaterialPoint& point, const std::vector<Voigt>& all) const {
  const std::vector<Voigt> own = of_body(point.body, all);
  return own.size() == 1 ? own.front() : own.at(static_cast<std::size_t>(point.tetrahedron));
}

}  // namespace talus
