// What the property panel says of how the project is run: what acts on the blocks, the stages, the solver.
#include "session/current_project.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/setup/property_panel.hpp"

namespace talus {

namespace {

QString degrees(double angle) { return QObject::tr("φ %1°").arg(numbers::significant(angle)); }

QString megapascals(double stress) { return QObject::tr("%1 MPa").arg(numbers::significant(stress / 1e6)); }

QString perSecond(double rate) { return QObject::tr("%1 1/s").arg(numbers::significant(rate)); }

/// Of the six components those along the axes, in MPa: the panel is narrow.
QString normalStresses(const Voigt& stress) { return words::point(stress.head<3>() / 1e6); }

QString changeWords(const JointChange& change) {
  QStringList parts;
  if (change.friction_angle) parts << degrees(*change.friction_angle);
  if (change.residual_friction_angle) parts << QObject::tr("residual %1").arg(degrees(*change.residual_friction_angle));
  if (change.cohesion) parts << QObject::tr("c %1").arg(megapascals(*change.cohesion));
  if (change.tensile_strength) parts << QObject::tr("tension %1").arg(megapascals(*change.tensile_strength));
  return parts.join(QStringLiteral(", "));
}

/// For a list that a stage puts in the place of the one before.
QString countOf(const auto& list) { return list.empty() ? QObject::tr("none") : numbers::whole(list.size()); }

bool changesAnything(const Stage& stage) {
  return !stage.joints.empty() || stage.loads || stage.constraints || !stage.blocks.empty();
}

}  // namespace

void PropertyPanel::showProject() {
  const Project& project = project_.document().project();
  header_->setTitle(tr("Project"), tr("nothing is selected"));
  auto* general = addSection(tr("General"));
  general->addFact(tr("Gravity, m/s²"), words::point(project.gravity));
  general->addFact(tr("Default joint"), text(project.default_joint));
  general->addFact(tr("A frame every"), tr("%1 s").arg(numbers::significant(project.output.every)));
  showSolver(project.solver);
  if (project.in_situ.empty()) return;
  auto* stresses = addSection(tr("Stress in situ"), tr("xx, yy, zz, MPa"));
  for (const auto& stress : project.in_situ) {
    QStringList names;
    for (const auto& block : stress.blocks) names << text(block);
    const QString where = names.isEmpty() ? tr("every block") : names.join(QStringLiteral(", "));
    stresses->addFact(where, normalStresses(stress.stress), tr("At z = %1 m").arg(numbers::significant(stress.level)));
    if (!stress.gradient.isZero(0)) stresses->addFact(tr("a metre upwards"), normalStresses(stress.gradient));
  }
}

void PropertyPanel::showSolver(const SolverSettings& solver) {
  auto* section = addSection(tr("Solver"));
  section->addFact(tr("Strain"), text(to_string(solver.strain)));
  section->addFact(tr("Integrator"), text(to_string(solver.integrator)));
  if (solver.integrator == Integrator::generalized_alpha)
    section->addFact(tr("Spectral radius"), numbers::significant(solver.spectral_radius),
                     tr("At infinite frequency: 1 damps nothing, 0 damps most"));
  section->addFact(tr("Contact"), text(to_string(solver.contact)));
  section->addFact(tr("Contact stiffness"), numbers::significant(solver.contact_stiffness),
                   tr("Normal penalty in units of the contact modulus over the mesh size"));
  if (solver.penetration_tolerance)
    section->addFact(tr("Penetration"), numbers::significant(*solver.penetration_tolerance),
                     tr("Tolerance over the mesh size, which augmented Lagrangian rounds come down to"));
  section->addFact(tr("Open–close limit"), numbers::whole(solver.open_close_limit),
                   tr("Iterations before a step is cut"));
  section->addFact(tr("Sleep below"),
                   solver.sleep_tolerance > 0 ? numbers::significant(solver.sleep_tolerance) : tr("never"),
                   tr("Mesh sizes a second: slower blocks at rest stand still until something may touch them"));
  section->addFact(tr("Time steps"), text(to_string(solver.time_step_control)));
  if (solver.time_step_control == TimeStepControl::fixed) return;
  const AdaptiveSteps& steps = solver.adaptive;
  section->addFact(tr("Displacement limit"), numbers::significant(steps.displacement_limit),
                   tr("In a step, over half the model's height"));
  section->addFact(tr("Error limit"), numbers::significant(steps.error_limit),
                   tr("Of time integration in a step, over the smallest mesh size"));
  section->addFact(tr("Iterations"), numbers::whole(steps.iterations), tr("Above which the next step is shorter"));
  section->addFact(tr("Shortest step"), numbers::significant(steps.shortest), tr("Over the stage's time step"));
}

void PropertyPanel::showLoad(const PointLoad& load) {
  header_->setTitle(tr("Point load"), text(load.block));
  auto* section = addSection(tr("Load"));
  section->addFact(tr("At, m"), words::point(load.at));
  if (load.table.empty())
    section->addFact(tr("Force, kN"), words::point(load.force / 1e3));
  else
    section->addFact(tr("Force by table"), words::span(load.table));
}

void PropertyPanel::showConstraint(const Constraint& constraint) {
  header_->setTitle(tr("Support"), text(constraint.block));
  auto* section = addSection(tr("Displacement constraint"));
  section->addFact(tr("At, m"), constraint.at ? words::point(*constraint.at) : tr("whole block"));
  if (!constraint.table.empty()) section->addFact(tr("Moved by table"), words::span(constraint.table));
  const char* axes[] = {"East", "North", "Up"};
  for (size_t i = 0; i < 3; ++i) {
    const auto& component = constraint.displacement[i];
    const QString held =
        constraint.table.empty() ? tr("%1 m").arg(numbers::significant(component.value_or(0))) : tr("by table");
    section->addFact(tr(axes[i]), component ? held : tr("free"));
  }
}

void PropertyPanel::showVelocity(const InitialVelocity& velocity) {
  header_->setTitle(tr("Initial velocity"), text(velocity.block));
  auto* section = addSection(tr("Velocity"));
  section->addFact(tr("Linear, m/s"), words::point(velocity.linear));
  section->addFact(tr("Angular, rad/s"), words::point(velocity.angular));
}

void PropertyPanel::showStage(const Stage& stage) {
  header_->setTitle(text(stage.name), tr("stage"));
  auto* section = addSection(tr("Stage"));
  section->addFact(tr("Type"), words::stage(stage.kind));
  section->addFact(tr("Time step"), tr("%1 s").arg(numbers::significant(stage.time_step)));
  if (stage.steps) section->addFact(tr("Steps"), numbers::whole(*stage.steps));
  if (stage.duration) section->addFact(tr("Duration"), tr("%1 s").arg(numbers::significant(*stage.duration, 4)));
  if (stage.until_equilibrium)
    section->addFact(tr("Until equilibrium"), numbers::significant(stage.equilibrium_tolerance),
                     tr("Unbalanced force over the largest force at which the stage ends"));
  if (stage.damping) section->addFact(tr("Damping"), perSecond(*stage.damping));
  if (!changesAnything(stage)) return;
  auto* changes = addSection(tr("Changes"), tr("from this stage on"));
  for (const auto& joint : stage.joints) changes->addFact(text(joint.name), changeWords(joint));
  if (stage.loads) changes->addFact(tr("Point loads"), countOf(*stage.loads));
  if (stage.constraints) changes->addFact(tr("Supports"), countOf(*stage.constraints));
  for (const auto& block : stage.blocks)
    changes->addFact(text(block.name), block.body == BodyKind::fixed ? tr("held") : tr("let go"));
}

}  // namespace talus
