#include "results/steps.hpp"

namespace talus {

namespace {

/// Calls `column(title, field)` for every column: the one list that header, writing and reading go by.
void for_each_column(auto& step, auto column) {
  column("step", step.step);
  column("stage", step.stage);
  column("time [s]", step.time);
  column("time step [s]", step.time_step);
  column("iterations", step.iterations);
  column("cuts", step.cuts);
  column("contacts", step.contacts);
  column("open", step.open);
  column("stick", step.stick);
  column("slip", step.slip);
  column("asleep", step.asleep);
  column("max penetration [m]", step.max_penetration);
  column("max relative penetration", step.max_relative_penetration);
  column("max displacement [m]", step.max_displacement);
  column("unbalanced force [N]", step.unbalanced_force);
  column("detect [s]", step.phases.detect);
  column("assemble [s]", step.phases.assemble);
  column("factor [s]", step.phases.factor);
  column("solve [s]", step.phases.solve);
  column("update [s]", step.phases.update);
  column("write [s]", step.phases.write);
  column("kinetic [J]", step.energy.kinetic);
  column("elastic [J]", step.energy.elastic);
  column("potential [J]", step.energy.potential);
  column("contact [J]", step.energy.contact);
  column("friction dissipated [J]", step.energy.friction_dissipated);
  column("damping dissipated [J]", step.energy.damping_dissipated);
  column("constraint work [J]", step.energy.constraint_work);
  column("integration loss [J]", step.energy.integration_loss);
  column("remainder [J]", step.energy.remainder);
  column("time error [m]", step.time_error);
}

}  // namespace

std::vector<std::string> steps_header() {
  std::vector<std::string> header;
  const StepReport step;
  for_each_column(step, [&](const char* title, const auto&) { header.emplace_back(title); });
  return header;
}

std::vector<double> to_columns(const StepReport& step) {
  std::vector<double> columns;
  for_each_column(step, [&](const char*, const auto& field) { columns.push_back(static_cast<double>(field)); });
  return columns;
}

StepReport step_report(const std::vector<double>& columns) {
  StepReport step;
  auto value = columns.begin();
  for_each_column(step, [&]<class Number>(const char*, Number& field) { field = static_cast<Number>(*value++); });
  return step;
}

}  // namespace talus
