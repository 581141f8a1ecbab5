// Loads, supports, velocities, stress in situ and monitors in the 3-D view: which are shown, and a click on one.
#include <algorithm>

#include "document/selection.hpp"
#include "model/stage_changes.hpp"
#include "session/workflow_page.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

using Kind = ActionGlyph::Kind;

Item::Kind itemKindOf(Kind kind) {
  switch (kind) {
    case Kind::load:
      return Item::Kind::load;
    case Kind::support:
      return Item::Kind::constraint;
    case Kind::velocity:
      return Item::Kind::velocity;
    case Kind::stress:
      return Item::Kind::inSitu;
    case Kind::monitor:
      break;
  }
  return Item::Kind::monitor;
}

/// Those that hold in a stage. What a stage has put in the place of others is no thing of the project's own list.
std::vector<ActionGlyph> actionsInStage(const Project& project, int stage, const BlockSystem& system) {
  auto glyphs = action_glyphs(project_in_stage(project, stage), system);
  const bool ownLoads = place_of_loads(project, stage).pointer() == "/loads";
  const bool ownSupports = place_of_constraints(project, stage).pointer() == "/constraints";
  for (ActionGlyph& glyph : glyphs)
    if ((glyph.kind == Kind::load && !ownLoads) || (glyph.kind == Kind::support && !ownSupports)) glyph.index = -1;
  return glyphs;
}

std::vector<ActionGlyph> shownActions(const Project& project, WorkflowPage page, const Item& current,
                                      const BlockSystem& system) {
  std::vector<ActionGlyph> glyphs;
  if (page == WorkflowPage::stages && current.kind == Item::Kind::stage)
    glyphs = actionsInStage(project, current.index, system);
  else if (page == WorkflowPage::loads || page == WorkflowPage::stages)
    glyphs = action_glyphs(project, system);
  else if (!isSetUp(page))
    std::ranges::copy_if(action_glyphs(project, system), std::back_inserter(glyphs),
                         [](const ActionGlyph& glyph) { return glyph.kind == Kind::monitor; });
  for (ActionGlyph& glyph : glyphs)
    glyph.selected = glyph.index >= 0 && current == Item{itemKindOf(glyph.kind), glyph.index};
  return glyphs;
}

}  // namespace

void Viewport::applyActions() {
  if (!scene_) return;
  auto glyphs = shownActions(project(), page(), selection().current(), *system_);
  if (glyphs == actions_) return;
  actions_ = glyphs;
  scene_->set_actions(std::move(glyphs));
  render();
}

std::optional<ActionGlyph> Viewport::actionAt(QPointF point) const {
  if (!scene_) return {};
  const double ratio = devicePixelRatioF();
  return scene_->action_at(point.x() * ratio, point.y() * ratio);
}

bool Viewport::selectActionAt(QPointF point) {
  const auto glyph = actionAt(point);
  if (!glyph || glyph->index < 0) return false;
  selection().select({itemKindOf(glyph->kind), glyph->index});
  return true;
}

}  // namespace talus
