#include "render/scene/scene.hpp"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "render/scene/picking.hpp"
#include "render/scene/scene_state.hpp"

namespace talus {
namespace {

void check_sizes(const BlockSystem& system, const Frame& frame) {
  std::size_t nodes = 0, tetrahedra = 0;
  for (const Block& block : system.blocks) {
    nodes += block.mesh.nodes.size();
    tetrahedra += block.mesh.tetrahedra.size();
  }
  if (frame.displacement.size() != nodes || frame.velocity.size() != nodes || frame.stress.size() != tetrahedra)
    throw std::invalid_argument("the frame is not of these blocks: its numbers of nodes or tetrahedra differ");
}

/// A point of the ray through a pixel, at `depth` 0 (near) … 1 (far), m from the scene's origin.
Vec3 unproject(vtkRenderer& renderer, double x, double y, double depth) {
  renderer.SetDisplayPoint(x, y, depth);
  renderer.DisplayToWorld();
  double world[4];
  renderer.GetWorldPoint(world);
  return Vec3(world[0], world[1], world[2]) / world[3];
}

/// Where points [m from the scene's origin] are in the picture, pixels from its upper left corner. The camera is asked
/// once: VTK would work it out for each point.
class PixelProjection {
 public:
  PixelProjection(vtkRenderer& renderer, std::array<double, 2> size) : size_(size) {
    const vtkMatrix4x4& matrix =
        *renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) matrix_(i, k) = matrix.GetElement(i, k);
  }
  std::array<double, 2> operator()(const Vec3& point) const {
    const Eigen::Vector4d seen = matrix_ * point.homogeneous();
    return {(1 + seen.x() / seen.w()) / 2 * size_[0], (1 - seen.y() / seen.w()) / 2 * size_[1]};
  }

 private:
  Eigen::Matrix4d matrix_;
  std::array<double, 2> size_;
};

/// By the number of sides that a ray to the right crosses.
bool encloses(std::span<const std::array<double, 2>> outline, const std::array<double, 2>& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a[1] > point[1]) == (b[1] > point[1])) continue;
    inside ^= point[0] < a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1]);
  }
  return inside;
}

}  // namespace

void Scene::State::cut_open() {
  if (is_cut()) {
    const Vec3 point = settings.section->point - origin, inwards = -settings.section->towards;
    section_plane->SetOrigin(point.data());
    section_plane->SetNormal(inwards.data());
  }
  vtkPlane* const plane = is_cut() ? section_plane.Get() : nullptr;
  for (BlockActors* part : {&fixed, &movable}) part->cut_by(plane);
  for (Highlight* marked : {&concern, &selection, &hover, &face}) marked->cut_by(plane);
  walls.cut_by(plane);
  section_is_stale = true;
}

/// The inside of a block has its colour, or that of the field at each place.
void Scene::State::fill_section() {
  section_is_stale = false;
  if (!is_cut()) return section.hide();
  std::vector<Vec3> places;
  for (const Block& block : system.blocks)
    places.insert(places.end(), block.mesh.nodes.begin(), block.mesh.nodes.end());
  if (frame)
    for (std::size_t i = 0; i < places.size(); ++i) places[i] += settings.deformation_scale * frame->displacement[i];
  std::vector<bool> shown = flags(hidden);
  shown.flip();
  const auto colour = [&](const BlockSection::Triangle& triangle, const BlockSection::Corner& corner) {
    const bool fixed_rock = system.blocks[static_cast<std::size_t>(triangle.block)].body == BodyKind::fixed;
    if (field_values.empty() || shows_walls() || shows_blocks() || fixed_rock || triangle.tetrahedron < 0)
      return colour_of(triangle.block);
    const bool at_nodes = settings.field->place() == FieldPlace::node;
    const auto value = [&](int i) { return field_values[static_cast<std::size_t>(i)]; };
    const double seen = at_nodes ? value(corner.one) + corner.share * (value(corner.other) - value(corner.one))
                                 : value(triangle.tetrahedron);
    return of_field(seen);
  };
  section.show(section_of(system, places, shown, *settings.section), origin, colour);
}

Scene::Scene(const BlockSystem& system, SceneSettings settings)
    : state_(std::make_unique<State>(system, std::move(settings))) {}

Scene::~Scene() = default;

const SceneSettings& Scene::settings() const { return state_->settings; }

void Scene::set_settings(SceneSettings settings) { state_->apply(std::move(settings)); }

void Scene::set_frame(std::shared_ptr<const Frame> frame) {
  check_sizes(state_->system, *frame);
  state_->take(std::move(frame));
}

void Scene::clear_frame() {
  if (state_->frame) state_->take(nullptr);
}

void Scene::set_stage_names(std::vector<std::string> names) {
  state_->stage_names = std::move(names);
  state_->make_overlay();
}

void Scene::include_in_view(const Frame& frame) {
  check_sizes(state_->system, frame);
  const BlockSurface& surface = state_->movable.surface();
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    state_->extent.include(surface.rest[i] + state_->settings.deformation_scale * frame.displacement[surface.nodes[i]]);
}

void Scene::look(View view) {
  const auto [azimuth, elevation] = view_angles(view);
  look(azimuth, elevation);
}

void Scene::look(double azimuth, double elevation) { state_->look_from(azimuth, elevation); }

void Scene::fit() {
  const auto [width, height] = state_->size();
  state_->fit_to(width, height);
}

bool Scene::fits_itself() const { return state_->fits_itself; }

void Scene::take_fit(const CameraPose& pose) {
  set_pose(pose);
  state_->fits_itself = true;
  state_->fit_is_stale = false;
  state_->overlay.text_height = state_->text_height();
  const auto [width, height] = state_->size();
  state_->fitted_area = state_->area_for_rock(width, height);
}

CameraPose Scene::pose() const { return state_->pose(); }

void Scene::set_pose(const CameraPose& pose) {
  state_->settings.parallel_projection = pose.parallel;
  state_->set_pose(pose);
}

void Scene::set_thinned(std::span<const std::span<const std::array<int, 3>>> triangles) {
  for (BlockActors* part : {&state_->fixed, &state_->movable}) {
    const BlockSurface& surface = part->surface();
    std::vector<BlockActors::Face> faces;
    int first_node = 0;
    for (std::size_t block = 0; block < triangles.size(); ++block) {
      const std::size_t nodes = state_->system.blocks[block].mesh.nodes.size();
      std::vector<int> vertex_of(nodes, -1);
      for (int v = surface.begins[block].vertex; v < surface.begins[block + 1].vertex; ++v)
        vertex_of[static_cast<std::size_t>(surface.nodes[v] - first_node)] = v;
      for (const auto& [a, b, c] : triangles[block])
        if (vertex_of[a] >= 0) faces.push_back({{vertex_of[a], vertex_of[b], vertex_of[c]}, static_cast<int>(block)});
      first_node += static_cast<int>(nodes);
    }
    part->thin(std::move(faces));
  }
  state_->colour();
  state_->style();
}

void Scene::set_hidden(std::vector<int> blocks) {
  state_->hidden = std::move(blocks);
  state_->show();
}

void Scene::set_selected(std::vector<int> blocks) {
  if (state_->selected == blocks) return;
  state_->selected = std::move(blocks);
  state_->selection.mark(state_->selected);
  if (state_->settings.trails == Trails::selected) state_->draw_trails();
}

void Scene::set_hovered(std::optional<int> block) {
  state_->hovered = block;
  state_->mark_hovered();
}

bool Scene::set_joints(std::shared_ptr<const std::vector<JointFace>> faces, std::vector<int> chosen) {
  return state_->joints.show(std::move(faces), std::move(chosen));
}

void Scene::set_covered(std::vector<PixelRect> places) {
  if (places == state_->covered) return;
  state_->covered = std::move(places);
  state_->fit_is_stale = true;
}

PixelRect Scene::rock_area() const {
  const auto [width, height] = state_->size();
  state_->overlay.text_height = state_->text_height();
  const PixelRect area = state_->area_for_rock(width, height);
  return {area.left / width, area.bottom / height, area.right / width, area.top / height};
}

void Scene::set_rock_area(const std::optional<PixelRect>& part) {
  if (part == state_->rock_part) return;
  state_->rock_part = part;
  state_->fit_is_stale = true;
}

std::optional<int> Scene::joint_at(double x, double y) const {
  const auto sight = sight_at(x, y);
  return sight ? state_->joints.cut_at(sight->from, sight->along) : std::nullopt;
}

void Scene::set_marked_face(const std::optional<Pick>& pick) {
  state_->marked_face = pick;
  state_->mark_face();
}

void Scene::set_troubles(std::vector<ConvergenceTrouble> troubles) {
  state_->troubles = std::move(troubles);
  state_->mark_troubles();
}

CameraPose Scene::pose_at(const ConvergenceTrouble& trouble) const { return state_->pose_at(trouble); }

CameraPose Scene::pose_at(const MarkedPlace& place) const { return state_->pose_at(place.at, place.size); }

std::optional<std::array<double, 2>> Scene::pixel_of(const Vec3& point) const {
  if (state_->renderer->GetRenderWindow() == nullptr) return {};
  const auto pixel = state_->pixel_of(point - state_->origin);
  if (!pixel) return {};
  return std::array{pixel->x, state_->size()[1] - 1 - pixel->y};
}

std::optional<SightLine> Scene::sight_at(double x, double y) const {
  vtkRenderer& renderer = *state_->renderer;
  if (renderer.GetRenderWindow() == nullptr) return {};
  const double from_below = state_->size()[1] - 1 - y;
  const Vec3 start = unproject(renderer, x, from_below, 0), end = unproject(renderer, x, from_below, 1);
  return SightLine{state_->origin + start, (end - start).normalized()};
}

Vec3 Scene::drawn_place(int block, const Vec3& rest) const {
  return state_->drawn_place(state_->parts(), state_->flags({block}), rest, rest);
}

std::optional<Pick> Scene::pick(double x, double y) const {
  auto sight = sight_at(x, y);
  if (!sight) return {};
  if (state_->is_cut()) {  // begins where it comes to what is left
    const SectionPlane& plane = *state_->settings.section;
    const double height = plane.towards.dot(sight->from - plane.point), falls = -plane.towards.dot(sight->along);
    if (height > 0 && falls <= 0) return {};
    if (height > 0) sight->from += height / falls * sight->along;
  }
  const auto hit = first_hit(state_->parts(), sight->from, sight->along);
  if (!hit) return {};
  const BlockSurface& surface = hit->part->surface();
  const BlockSurface::Triangle& triangle = surface.triangles[hit->triangle];
  Pick pick{.block = triangle.block,
            .position = hit->position,
            .facet = triangle.facet,
            .rest = Vec3::Zero(),
            .tetrahedron = triangle.tetrahedron,
            .value = {}};
  for (int i = 0; i < 3; ++i) pick.rest += hit->weights[i] * surface.rest[triangle.vertices[i]];
  const auto nearest = std::max_element(hit->weights.begin(), hit->weights.end()) - hit->weights.begin();
  pick.node = surface.nodes[triangle.vertices[nearest]];
  const bool coloured = !state_->field_values.empty() && !state_->shows_walls() && hit->part == &state_->movable;
  if (coloured && state_->settings.field->place() == FieldPlace::node) {
    pick.value = 0;
    for (int i = 0; i < 3; ++i)
      *pick.value += hit->weights[i] * state_->field_values[surface.nodes[triangle.vertices[i]]];
  } else if (coloured && state_->shows_blocks()) {
    if (!state_->settings.field->is_class()) pick.value = state_->field_values[static_cast<std::size_t>(pick.block)];
  } else if (coloured && triangle.tetrahedron >= 0) {
    pick.value = state_->field_values[triangle.tetrahedron];
  }
  return pick;
}

std::vector<int> Scene::blocks_in(std::span<const std::array<double, 2>> outline, bool touched) const {
  vtkRenderer& renderer = *state_->renderer;
  if (renderer.GetRenderWindow() == nullptr) return {};
  const PixelProjection projection(renderer, state_->size());
  std::vector<int> inside(state_->system.blocks.size(), 0), all = inside;
  for (const BlockActors* part : state_->parts()) {
    const auto& positions = part->positions();
    std::vector<signed char> known(positions.size(), -1);  // whether a vertex lies in the outline
    for (const int t : part->drawn()) {
      const auto& triangle = part->surface().triangles[t];
      for (const int vertex : triangle.vertices) {
        if (known[vertex] < 0) known[vertex] = encloses(outline, projection(positions[vertex] - state_->origin));
        ++all[triangle.block];
        inside[triangle.block] += known[vertex];
      }
    }
  }
  std::vector<int> blocks;
  for (std::size_t b = 0; b < all.size(); ++b)
    if (all[b] > 0 && (touched ? inside[b] > 0 : inside[b] == all[b])) blocks.push_back(static_cast<int>(b));
  return blocks;
}

std::vector<int> Scene::blocks_in(double left, double top, double right, double bottom, bool touched) const {
  const std::array<double, 2> corners[] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
  return blocks_in(corners, touched);
}

Rgb Scene::block_colour(int block) const {
  if (block < 0 || block >= static_cast<int>(state_->system.blocks.size())) throw std::out_of_range("no such block");
  return state_->colour_of(block);
}

std::optional<ValueRange> Scene::shown_range() const {
  if (state_->field_values.empty() || state_->settings.field->is_class()) return {};
  return state_->colour_range();
}

vtkRenderer* Scene::renderer() const { return state_->renderer; }

}  // namespace talus
