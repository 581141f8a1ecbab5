#include "model/actions.hpp"

namespace talus {
namespace {

void visit_each(const auto& things, const Place& list, const auto& visit) {
  for (std::size_t i = 0; i < things.size(); ++i) visit(list / i, things[i]);
}

}  // namespace

void for_each_constraint(const Project& project, const std::function<void(const Place&, const Constraint&)>& visit) {
  visit_each(project.constraints, Place() / "constraints", visit);
  for (std::size_t i = 0; i < project.stages.size(); ++i) {
    const auto& changed = project.stages[i].constraints;
    if (changed) visit_each(*changed, Place() / "stages" / i / "constraints", visit);
  }
}

void for_each_load(const Project& project, const std::function<void(const Place&, const PointLoad&)>& visit) {
  visit_each(project.loads, Place() / "loads", visit);
  for (std::size_t i = 0; i < project.stages.size(); ++i) {
    const auto& changed = project.stages[i].loads;
    if (changed) visit_each(*changed, Place() / "stages" / i / "loads", visit);
  }
}

}  // namespace talus
