#include "widgets/joints/joint_actions.hpp"

#include <QCursor>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "mesh/block_against.hpp"
#include "orientation/drawn_planes.hpp"
#include "orientation/fitted_plane.hpp"
#include "orientation/new_cut.hpp"
#include "session/session.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

/// The joint of what is selected; empty where that is none.
std::string jointOf(const Item& item, const Project& project) {
  if (item.kind == Item::Kind::joint) return project.joints.at(static_cast<std::size_t>(item.index)).name;
  if (item.kind == Item::Kind::cut) return project.cuts.at(static_cast<std::size_t>(item.index)).joint;
  return {};
}

/// The cut of this joint whose plane is nearest to a point.
std::optional<int> cutAt(const Project& project, const std::string& joint, const Vec3& point) {
  std::optional<int> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < project.cuts.size(); ++i) {
    if (project.cuts[i].joint != joint) continue;
    for (const Cut& plane : single_planes(project.cuts[i])) {
      const double away = std::abs(pole_of({plane.dip, plane.dip_direction}).dot(point - plane.through));
      if (away >= least) continue;
      least = away;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

}  // namespace

JointActions::JointActions(Session& session, QWidget& window) : QObject(&window), session_(session), window_(window) {
  threePoints = add(tr("Joint through three points"), QStringLiteral("three-points"), &JointActions::askForThreePoints);
  alongFace = add(tr("Joint along a face"), QStringLiteral("face"), &JointActions::askForFace);
  assignToFace = add(tr("Assign joint to a face"), QStringLiteral("joints"), &JointActions::askForContact);
  assignBetween = add(tr("Joint between these two blocks"), QStringLiteral("joints"), &JointActions::assignToSelected);
}

QAction* JointActions::add(const QString& words, const QString& icon, void (JointActions::*act)()) {
  auto* action = new QAction(theme::icon(icon), words, this);
  connect(action, &QAction::triggered, this, act);
  return action;
}

QString JointActions::whyNot(const QAction* action) const {
  const Document& document = session_.project.document();
  if (!document.isOpen()) return tr("Open a project first");
  if (action == threePoints || action == alongFace)
    return document.project().solids.empty() ? tr("The project has no solid yet") : QString();
  if (!session_.project.system()) return tr("There are no blocks yet");
  if (document.project().joints.empty()) return tr("The project has no joint yet");
  const bool needsTwo = action == assignBetween && session_.project.selection().blocks().size() != 2;
  return needsTwo ? tr("Select two blocks first") : QString();
}

void JointActions::askForJoint(const std::function<void(const QString&)>& act) {
  auto* menu = new QMenu(&window_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const Joint& joint : session_.project.document().project().joints)
    menu->addAction(text(joint.name), this, [act, name = text(joint.name)] { act(name); });
  menu->popup(QCursor::pos());
}

void JointActions::askForThreePoints() {
  session_.display.goTo(WorkflowPage::joints);
  session_.picking.ask(tr("Click a point of the joint"), 3, [this](const std::vector<PickedPlace>& places) {
    std::vector<Vec3> points;
    for (const PickedPlace& place : places) points.push_back(place.point);
    try {
      const FittedPlane fit = fitted_plane(points, tr("joint through three points").toStdString());
      addCut(fit.plane, fit.through, tr("joint through three points"));
    } catch (const InputError& error) {
      session_.messages.add(problemOf(error));
    }
  });
}

void JointActions::askForFace() {
  session_.display.goTo(WorkflowPage::joints);
  session_.picking.ask(tr("Click a face that the joint lies along"), 1, [this](const std::vector<PickedPlace>& places) {
    addCut(attitude_of_normal(places[0].normal), places[0].point, tr("joint along a face"));
  });
}

void JointActions::addCut(const PlaneAttitude& plane, const Vec3& through, const QString& step) {
  Document& document = session_.project.document();
  const std::string joint = jointOf(session_.project.selection().current(), document.project());
  try {
    document.change(with_cut(document.project(), plane, through, joint), step);
    const Cut& made = document.project().cuts.back();
    session_.messages.log(
        tr("%1 of %2: %3")
            .arg(sentenceCase(step), text(made.joint), numbers::orientation(made.dip, made.dip_direction)));
    session_.project.selection().select({Item::Kind::cut, static_cast<int>(document.project().cuts.size()) - 1});
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void JointActions::say(const QString& place, const QString& problem, const QString& remedy, const QString& field) {
  Problem said{Problem::Severity::info, place, problem, remedy};
  said.field = field;
  session_.messages.add(said);
}

void JointActions::askForContact() {
  askForJoint([this](const QString& joint) {
    session_.display.goTo(WorkflowPage::blocks);
    session_.picking.ask(tr("Click a face between two blocks, for %1 (E draws them apart)").arg(joint), 1,
                         [this, joint](const std::vector<PickedPlace>& places) { assignAt(places[0], joint); });
  });
}

void JointActions::assignAt(const PickedPlace& place, const QString& joint) {
  const QString where = tr("assign %1").arg(joint);
  const auto system = session_.project.system();
  if (!system || place.block < 0) return say(where, tr("nothing is cut yet"), tr("cut and mesh first"));
  if (place.joint >= 0) {
    const std::string& own = system->joint_names.at(static_cast<std::size_t>(place.joint));
    const auto cut = cutAt(session_.project.document().project(), own, place.point);
    if (!cut)
      return say(where, tr("this face has the joint %1").arg(text(own)), tr("cut again, the cuts were changed"));
    return say(where, tr("this face lies on cut %1, which has the joint %2").arg(*cut + 1).arg(text(own)),
               tr("give the cut another joint"), QStringLiteral("/cuts/%1/joint").arg(*cut));
  }
  const int other = block_against(*system, place.block, place.point, place.normal);
  if (other < 0) return say(where, tr("no block lies against this face"), tr("click a face between two blocks"));
  assign(place.block, other, joint);
}

void JointActions::assignToSelected() {
  askForJoint([this](const QString& joint) {
    const auto& blocks = session_.project.selection().blocks();
    if (blocks.size() == 2) assign(blocks[0], blocks[1], joint);
  });
}

void JointActions::assign(int block, int other, const QString& joint) {
  const BlockSystem& system = *session_.project.system();
  const std::string& one = system.blocks.at(static_cast<std::size_t>(block)).name;
  const std::string& two = system.blocks.at(static_cast<std::size_t>(other)).name;
  Document& document = session_.project.document();
  try {
    document.change(with_interface(document.project(), one, two, joint.toStdString()),
                    tr("assign %1 between %2 and %3").arg(joint, text(one), text(two)));
    session_.messages.log(tr("%1 lies between %2 and %3 now").arg(joint, text(one), text(two)));
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

}  // namespace talus
