// How what the 3-D view draws of blocks or solids is made, and goes.
#include <vtkRenderer.h>

#include <algorithm>

#include "render/scene/slope_view.hpp"
#include "session/joint_drawing.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr std::size_t made_at_once = 5000;  // triangles: it takes no time that is noticed

/// A tetrahedron that is fixed and one that may move.
BlockSystem smallest_system() {
  Block block;
  block.mesh = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  block.surface = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
  Block ground = block;
  ground.body = BodyKind::fixed;
  return {.blocks = {ground, block}, .joint_names = {}};
}

/// More triangles over each other than are told apart: those in the middle are drawn by programs of their own.
std::shared_ptr<const std::vector<JointFace>> smallest_joints() {
  constexpr int layers = 16;
  std::vector<JointFace> joints;
  for (int i = 0; i < layers; ++i) {
    const Vec3 a = i * Vec3::UnitZ() / layers, b = a + Vec3::UnitX(), c = a + Vec3::UnitY();
    joints.push_back({0, 0, {{a, b, c}}, {{a, b}, {b, c}, {c, a}}});
  }
  return std::make_shared<const std::vector<JointFace>>(std::move(joints));
}

}  // namespace

/// In software the first drawing takes ten times as long as the next: better before there is a run to watch. Rock that
/// is seen through and the joints in it are drawn by other programs of the card, made in events of their own.
void Viewport::warmUp() {
  const auto draw = [this](double opacity, bool fine) {
    if (scene_) return;
    const BlockSystem system = smallest_system();
    SceneSettings settings = screenSettings();
    settings.field.reset();
    settings.rock_opacity = opacity;
    settings.fine = fine;
    Scene scene(system, settings);
    if (opacity < 1) scene.set_joints(smallest_joints(), {});
    surface_->warmUp(*scene.renderer());
  };
  for (const bool fine : {false, true}) draw(1, fine);
  for (const bool fine : {false, true}) QTimer::singleShot(0, this, [draw, fine] { draw(0.5, fine); });
}

void Viewport::setGhost(const Ghost& ghost) {
  ghost_ = ghost;
  applyTrails();
}

void Viewport::toggleSection() {
  if (!scene_) return;
  SceneSettings settings = session_.display.settings();
  if (settings.section) {
    settings.section.reset();
    return session_.display.set(settings);
  }
  Eigen::AlignedBox3d cut;
  const std::vector<int> chosen = selectedInView();
  for (std::size_t b = 0; b < system_->blocks.size(); ++b)
    if (chosen.empty() || std::ranges::find(chosen, static_cast<int>(b)) != chosen.end())
      for (const Vec3& node : system_->blocks[b].mesh.nodes) cut.extend(node);
  const CameraPose camera = scene_->pose();
  Vec3 towards = (camera.position - camera.focal_point).normalized();
  constexpr double from_above = 0.95;  // there an upright plane would be seen from its edge
  if (towards.z() < from_above) towards.z() = 0;
  settings.section = SectionPlane{cut.center(), towards.normalized()};
  session_.display.set(settings);
}

Viewport::~Viewport() {
  keepScenes([](const Drawn&) { return false; });
}

bool Viewport::isMadeAtOnce(const BlockSystem& system) {
  std::size_t triangles = 0;
  for (const Block& block : system.blocks) triangles += block.surface.size();
  return triangles < made_at_once;
}

/// Of solids: joints are drawn in them, as far as these are given.
Viewport::Drawn Viewport::drawn(const std::shared_ptr<const BlockSystem>& system, const SceneSettings& settings,
                                const std::vector<JointedRock>& solids) {
  auto scene = std::make_shared<Scene>(*system, settings);
  std::vector<std::span<const std::array<int, 3>>> thinned;
  for (const JointedRock& solid : solids) thinned.push_back(solid.surface->rock().triangles);
  scene->set_thinned(thinned);
  look_at_slope(*scene, *system, nullptr);
  return {system, std::move(scene), {}};
}

/// Frees the card's memory of those that are not kept.
void Viewport::keepScenes(const std::function<bool(const Drawn&)>& isKept) {
  if (made_.empty()) return;
  surface_->makeContextCurrent();
  std::erase_if(made_, [&](const Drawn& one) {
    if (isKept(one)) return false;
    surface_->window().RemoveRenderer(one.scene->renderer());
    return true;
  });
}

QPixmap Viewport::picture() { return surface_->picture(); }

QPixmap Viewport::picture(Theme theme) {
  if (!scene_ || scene_->settings().theme == theme) return picture();
  const SceneSettings before = scene_->settings();
  SceneSettings settings = before;
  settings.theme = theme;
  scene_->set_settings(settings);
  surface_->requestRender();
  const QPixmap taken = picture();
  scene_->set_settings(before);
  surface_->requestRender();
  return taken;
}

}  // namespace talus
