#include "render/scene/scene_state.hpp"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "base/units.hpp"
#include "render/fields/field_classes.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"
#include "render/scene/contact_places.hpp"

namespace talus {
namespace {

constexpr double tint_of_selection = 0.5;  // less would turn blue blocks grey, as fixed rock is
// Layers of rock and joints that are told apart from the front and from the back; each is a drawing of all.
constexpr int most_layers = 5, layers_in_motion = 3;
constexpr std::size_t most_lines_in_motion = 50000;

/// A point where there are no blocks.
Eigen::AlignedBox3d bounds_or_point(const BlockSystem& system) {
  const Eigen::AlignedBox3d box = bounds(system);
  return box.isEmpty() ? Eigen::AlignedBox3d(Vec3::Zero().eval()) : box;
}

std::vector<bool> with_body(const BlockSystem& system, bool fixed) {
  std::vector<bool> wanted;
  for (const Block& block : system.blocks) wanted.push_back((block.body == BodyKind::fixed) == fixed);
  return wanted;
}

/// A light that goes with the camera. `azimuth` to the right of the viewer, `elevation` above, degrees.
void add_light(vtkRenderer& renderer, double azimuth, double elevation, double intensity, Rgb colour) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  const double a = radians(azimuth), e = radians(elevation);
  light->SetPosition(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  light->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  renderer.AddLight(light);
}

void add_lights(vtkRenderer& renderer) {
  renderer.SetAutomaticLightCreation(0);
  add_light(renderer, -38, 52, 0.86, rgb(0xfffbf5));  // key: high on the left, a little warm
  add_light(renderer, 50, 12, 0.50, rgb(0xebf5ff));   // fill: low on the right, a little cool
  add_light(renderer, 0, 0, 0.16, rgb(0xffffff));     // from the viewer
}

Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).normalized(); }

/// The triangle is of the flat face that was picked: of the same block, joint and plane.
bool on_face(const BlockSurface& surface, const BlockSurface::Triangle& triangle, const Pick& pick,
             const BlockSystem& system, double rock_size) {
  if (triangle.block != pick.block) return false;
  const Block& block = system.blocks[static_cast<std::size_t>(pick.block)];
  const SurfaceTriangle& picked = block.surface[static_cast<std::size_t>(pick.facet)];
  if (block.surface[static_cast<std::size_t>(triangle.facet)].joint != picked.joint) return false;
  const auto node = [&](int i) { return block.mesh.nodes[static_cast<std::size_t>(picked.nodes[i])]; };
  const Vec3 normal = normal_of(node(0), node(1), node(2));
  const auto& v = triangle.vertices;
  const Vec3& first = surface.rest[v[0]];
  return normal.dot(normal_of(first, surface.rest[v[1]], surface.rest[v[2]])) > std::cos(radians(2)) &&
         std::abs(normal.dot(first - node(0))) < 1e-4 * rock_size;
}

/// Includes the vertices of blocks, at `places`, one block after the other.
template <class Wanted>
void include_blocks(ViewExtent& extent, const BlockSurface& surface, std::span<const Vec3> places,
                    const Wanted& wanted) {
  for (std::size_t block = 0; block + 1 < surface.begins.size(); ++block) {
    const auto begin = static_cast<std::size_t>(surface.begins[block].vertex),
               end = static_cast<std::size_t>(surface.begins[block + 1].vertex);
    if (wanted(static_cast<int>(block))) extent.include(places.subspan(begin, end - begin));
  }
}

void fill(vtkLookupTable& table, const ColourMap& map, Rgb missing) {
  table.SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i) {
    const Rgb c = map.table()[static_cast<std::size_t>(i)];
    table.SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0, 1);
  }
  table.SetNanColor(missing.red / 255.0, missing.green / 255.0, missing.blue / 255.0, 1);
}

}  // namespace

Scene::State::State(const BlockSystem& blocks, SceneSettings wanted)
    : system(blocks),
      settings(std::move(wanted)),
      origin(bounds_or_point(blocks).center()),
      rock_size(bounds_or_point(blocks).diagonal().norm()),
      block_colours(colours_of_blocks(blocks)),
      fixed(block_surface(blocks, with_body(blocks, true)), origin),
      movable(block_surface(blocks, with_body(blocks, false)), origin),
      concern({&fixed, &movable}),
      selection({&fixed, &movable}),
      hover({&fixed, &movable}),
      face({&fixed, &movable}),
      joints(origin),
      fields(blocks),
      walls(origin) {
  backdrop.add_to(*renderer);
  for (BlockActors* part : {&fixed, &movable}) part->add_faces_to(*renderer);
  section.add_to(*renderer);
  walls.add_to(*renderer);
  for (BlockActors* part : {&fixed, &movable}) part->add_lines_to(*renderer);
  concern.add_to(*renderer);
  selection.add_to(*renderer);
  hover.add_to(*renderer);
  face.add_to(*renderer);
  joints.add_to(*renderer);
  contacts.add_to(*renderer);
  ways.add_to(*renderer);
  ghost_edges.add_to(*renderer);
  action_shapes.add_to(*renderer);
  add_lights(*renderer);

  renderer->SetSSAORadius(0.05 * rock_size);
  renderer->SetSSAOBias(0.002 * rock_size);
  renderer->SetSSAOKernelSize(32);
  renderer->SSAOBlurOn();

  vtkNew<PainterItem> item;
  item->paint = [this](Painter& painter) {
    const CameraPose camera = pose();
    const Vec3 towards_viewer = (camera.position - camera.focal_point).normalized();
    const Vec3 right = camera.view_up.cross(towards_viewer).normalized();
    const auto [width, height] = size();
    talus::paint(painter, overlay,
                 {width, height, right, towards_viewer.cross(right), towards_viewer, metres_per_pixel()});
    paint_marks(painter, paint_actions(painter));
  };
  vtkNew<vtkContextActor> context;
  context->GetScene()->AddItem(item);
  renderer->AddActor(context);
  renderer->AddObserver(vtkCommand::StartEvent, this, &State::prepare_drawing);

  reset_extent();
  look_from(view_angles(View::iso)[0], view_angles(View::iso)[1]);
  style();
  fixed.move({}, 1, settings.explosion);
  move();
  colour();
  make_overlay();
  cut_open();
}

Scene::State::~State() = default;

/// Tens of thousands of triangles are touched only by what concerns them.
void Scene::State::apply(SceneSettings wanted) {
  const SceneSettings before = std::exchange(settings, std::move(wanted));
  style();
  if (settings.explosion != before.explosion) fixed.move({}, 1, settings.explosion);
  if (settings.explosion != before.explosion || settings.deformation_scale != before.deformation_scale) move();
  if (settings.deformation_scale != before.deformation_scale) reset_extent();
  if (settings.contacts != before.contacts) place_contacts();
  const auto colours_of = [](const SceneSettings& s) {
    return std::tie(s.theme, s.field, s.range, s.block_colours, s.only);
  };
  if (colours_of(settings) != colours_of(before)) colour();
  if (settings.troubles != before.troubles) mark_troubles();
  const auto ways_of = [](const SceneSettings& s) {
    return std::tie(s.theme, s.trails, s.deformation_scale, s.explosion, s.turning_axes);
  };
  if (ways_of(settings) != ways_of(before)) draw_ways();
  if (settings.section != before.section || settings.explosion != before.explosion) cut_open();
  make_overlay();
}

void Scene::State::style() {
  const ThemeColours& c = colours(settings.theme);
  backdrop.style(c.view_top, c.view_bottom);
  const auto set = [](Rgb colour, auto setter) {
    setter(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  };
  set(c.view_bottom, [this](double r, double g, double b) { renderer->SetBackground(r, g, b); });
  set(c.view_top, [this](double r, double g, double b) { renderer->SetBackground2(r, g, b); });
  renderer->SetGradientBackground(!occludes());
  backdrop.show(occludes());
  renderer->GetActiveCamera()->SetParallelProjection(settings.parallel_projection);
  for (BlockActors* part : {&fixed, &movable}) part->let_through(opacity());
  joints.use(settings.theme);
}

void Scene::State::take(std::shared_ptr<const Frame> shown) {
  frame = std::move(shown);
  style();
  move();
  colour();
  draw_ways();
  make_overlay();
}

void Scene::State::move() {
  section_is_stale = walls_are_stale = true;
  movable.move(frame ? std::span<const Vec3>(frame->displacement) : std::span<const Vec3>(), settings.deformation_scale,
               settings.explosion);
  place_contacts();
}

void Scene::State::place_contacts() {
  const bool with_contacts = settings.contacts && frame && settings.explosion == 0;  // they lie between blocks
  contact_dots = with_contacts ? contact_places(system, *frame, settings.deformation_scale) : std::vector<Vec3>{};
}

const BlockColours* Scene::State::chosen_colours() const {
  const BlockColours* chosen = settings.block_colours.get();
  return chosen && chosen->colours.size() == system.blocks.size() ? chosen : nullptr;
}

Rgb Scene::State::colour_of(int block) const {
  const auto index = static_cast<std::size_t>(block);
  if (shows_walls()) return colours(settings.theme).rock;
  if (shows_blocks()) return colour_by_field(block);
  if (const BlockColours* chosen = chosen_colours(); chosen && !(frame && settings.field))
    return chosen->colours[index];
  const bool is_fixed = system.blocks[index].body == BodyKind::fixed;
  return is_fixed ? colours(settings.theme).rock : block_colours[index];
}

void Scene::State::colour() {
  section_is_stale = walls_are_stale = true;
  field_values = frame && settings.field ? fields.of(*frame, *settings.field) : std::vector<double>{};
  of_field = field_values.empty() ? nullptr : field_colours();
  keep_wanted_faces();
  fixed.colour_by_block([this](int block) { return colour_of(block); });
  if (field_values.empty() || shows_walls() || shows_blocks()) {
    movable.colour_by_block([this](int block) { return colour_of(block); });
    return;
  }
  fill(*table, is_signed(*settings.field) ? vik() : batlow(), colours(settings.theme).rock);
  const ValueRange range = colour_range();
  movable.colour_by_values(field_values, settings.field->place() == FieldPlace::node, *table, range.low, range.high);
}

void Scene::State::show() {
  std::vector<bool> shown = flags(hidden);
  shown.flip();
  for (BlockActors* part : {&fixed, &movable}) part->show(shown);
  colour();
  mark_troubles();
  selection.mark(selected);
  mark_hovered();
  mark_face();
  draw_ways();
}

void Scene::State::mark_face() {
  if (!marked_face) return face.mark({});
  face.mark(marked_face->block, [this](const BlockSurface& surface, const BlockSurface::Triangle& triangle) {
    return on_face(surface, triangle, *marked_face, system, rock_size);
  });
}

/// Lines and dots grow with the writing; the window is asked for its size only now, when it draws.
void Scene::State::apply_lines() {
  const ThemeColours& c = colours(settings.theme);
  const double unit = text_height() / 14;
  // Where rock is seen through, or faces are left out, edges lie on the background.
  const bool on_dark = settings.theme == Theme::dark && (opacity() < 1 || leaves_out_faces());
  const Rgb edge = mix(c.edge, c.rock, on_dark ? 0.8 : 0.25);
  const double thin = std::max(0.9 * unit, 1.2);
  const double wide = settings.edges == Edges::none ? 0 : thin, fine = settings.edges == Edges::mesh ? 0.75 * unit : 0;
  const CameraPose camera = pose();
  const Vec3 pixel = metres_per_pixel() * (camera.position - camera.focal_point).normalized();
  for (BlockActors* part : {&fixed, &movable}) {
    // Very many lines of the mesh wait until nothing moves.
    const bool waits = !settings.fine && part->surface().edges.size() > most_lines_in_motion;
    part->draw_edges(wide, waits ? 0 : fine, edge, pixel);
  }
  concern.style(c.warn, 1.6 * unit, field_values.empty() ? 0.12 : 0, pixel);
  selection.style(c.pick, 2 * unit, field_values.empty() ? tint_of_selection : 0, pixel);  // it would falsify a field
  hover.style(c.pick, unit, 0, pixel);
  joints.style(1.4 * unit);
  ways.style(2.4 * unit);
  ghost_edges.style(1.6 * unit);
  section.style(thin, edge, pixel);
  walls.style(pixel);
  face.style(c.pick, 2 * unit, 0.35, pixel);
  const bool with_contacts = !contact_dots.empty();
  contacts.show(with_contacts ? std::span<const ContactSample>(frame->contacts) : std::span<const ContactSample>(),
                contact_dots, origin, 7 * unit);
}

ValueRange Scene::State::colour_range() const {
  if (settings.range) return *settings.range;
  return legend_range(*settings.field, field_range(system, std::span<const double>(field_values), *settings.field));
}

void Scene::State::make_overlay() {
  overlay = Overlay{.theme = settings.theme,
                    .text_height = text_height(),
                    .title = settings.title,
                    .time = {},
                    .remarks = {},
                    .legend = {},
                    .colour_key = {},
                    .triad = settings.triad,
                    .scale_bar = settings.scale_bar};
  if (frame && settings.time_stamp) {
    overlay.time = "t = " + format_decimals(frame->time, 2) + " s";
    const auto stage = static_cast<std::size_t>(frame->stage);
    if (stage < stage_names.size()) overlay.remarks = stage_names[stage];
  }
  const bool whole = settings.deformation_scale == std::round(settings.deformation_scale);
  if (frame && settings.deformation_scale != 1)
    overlay.remarks += (overlay.remarks.empty() ? "" : ", ") + picture_word("displacements") + " \u00d7 " +
                       format_decimals(settings.deformation_scale, whole ? 0 : 2);
  if (frame && !settings.remark.empty()) overlay.remarks += (overlay.remarks.empty() ? "" : ", ") + settings.remark;
  if (settings.legend && settings.contacts && frame) {
    overlay.key_title = picture_word("contacts");
    overlay.key = {{state_colour(ContactState::open), picture_word("open")},
                   {state_colour(ContactState::stick), picture_word("stick")},
                   {state_colour(ContactState::slip), picture_word("slip")}};
  }
  if (const BlockColours* chosen = chosen_colours(); settings.legend && chosen && !chosen->key.empty())
    overlay.colour_key = ColourKey{chosen->title, chosen->key};
  using Kind = ActionGlyph::Kind;
  for (const Kind kind : {Kind::load, Kind::support, Kind::velocity, Kind::stress, Kind::monitor})
    if (settings.legend && settings.actions && std::ranges::find(actions, kind, &ActionGlyph::kind) != actions.end())
      overlay.key.push_back({action_colour(kind, settings.theme), action_meaning(kind, largest_of(actions, kind))});
  if (!field_values.empty()) explain_field();
  if (settings.legend && frame && settings.arrows != Arrows::none) overlay.key.push_back(meaning_of_arrows());
  if (settings.legend && !axes_of_frame.empty()) overlay.key.push_back(meaning_of_axes());
  if (settings.legend && ghost_surface) overlay.key.push_back({colours(settings.theme).pick, ghost.name});
}

void Scene::State::reset_extent() {
  extent = ViewExtent();
  for (const BlockActors* part : parts())
    include_blocks(extent, part->surface(), part->surface().rest, [](int) { return true; });
}

void Scene::State::prepare_drawing() {
  renderer->SetUseSSAO(occludes());
  renderer->SetUseDepthPeeling(opacity() < 1);  // what is seen through rock, from the back to the front
  renderer->SetMaximumNumberOfPeels(settings.fine ? most_layers : layers_in_motion);
  renderer->SetUseFXAA(settings.fine && settings.smooth_outlines && pixel_scale == 1);
  overlay.text_height = text_height();
  const auto [width, height] = size();
  const PixelRect area = area_for_rock(width, height);
  if (fits_itself && (fit_is_stale || fitted_area != area)) fit_to(width, height);
  if (section_is_stale) fill_section();
  if (walls_are_stale) draw_walls();
  apply_lines();
  shape_actions();
  // The camera looks at the middle of the free part, not of the picture.
  renderer->GetActiveCamera()->SetWindowCenter(1 - (area.left + area.right) / width,
                                               1 - (area.bottom + area.top) / height);
  renderer->ResetCameraClippingRange();
}

void Scene::State::look_from(double azimuth, double elevation) {
  const Vec3 to_viewer = direction_to_viewer(azimuth, elevation);
  const Vec3 up = std::abs(to_viewer.z()) > 0.999 ? Vec3(-direction_to_viewer(azimuth, 0)) : Vec3(Vec3::UnitZ());
  CameraPose look;
  look.focal_point = origin;
  look.position = origin + to_viewer;
  look.view_up = up;
  look.parallel = settings.parallel_projection;
  set_pose(look);
  const auto [width, height] = size();
  fit_to(width, height);
}

void Scene::State::fit_to(double width, double height) {
  overlay.text_height = text_height();
  PixelRect area = area_for_rock(width, height);
  fitted_area = area;
  ViewExtent wanted = hidden.empty() ? extent : ViewExtent();
  for (const BlockActors* part : parts())
    include_blocks(wanted, part->surface(), part->positions(), [&](int block) { return part->shows(block); });
  std::vector<Vec3> points = wanted.points();
  const auto look = [&] { set_pose(fitted(pose(), points, area.width(), area.height(), height)); };
  look();
  if (settings.actions && !actions.empty()) {
    constexpr double above = 1.5, beside = 2;  // text heights: labels stand beside the ends of arrows
    area.top -= above * text_height();
    area.left += beside * text_height();
    area.right -= beside * text_height();
    // Arrows have their length on the screen: the farther the camera, the farther they reach out of the rock.
    const std::size_t rock = points.size();
    for (int i = 0; i < 3; ++i) {
      points.resize(rock);
      for (std::size_t k = 0; k < actions.size(); ++k)
        for (const Vec3& end : arrow_of(k)) points.push_back(origin + end);
      look();
    }
  }
  fits_itself = true;
  fit_is_stale = false;
}

/// Beside what stands over the right edge, where that leaves enough.
PixelRect Scene::State::area_for_rock(double width, double height) const {
  if (rock_part)
    return {rock_part->left * width, rock_part->bottom * height, rock_part->right * width, rock_part->top * height};
  constexpr double enough = 0.4, gap = 0.6;  // of the width; text heights
  PixelRect area = free_area(overlay, width, height);
  for (const PixelRect& place : covered)
    if (place.left < area.right && place.right > area.right - (area.right - area.left) / 2)
      area.right = std::max(place.left - gap * text_height(), area.left + enough * width);
  return area;
}

std::array<double, 2> Scene::State::size() const {
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (window == nullptr || window->GetSize()[0] <= 0) return {1280, 720};
  return {static_cast<double>(window->GetSize()[0]), static_cast<double>(window->GetSize()[1])};
}

double Scene::State::text_height() const {
  const auto [width, height] = size();
  if (settings.text_height > 0) return settings.text_height * pixel_scale;
  return automatic_text_height(width / pixel_scale, height / pixel_scale) * pixel_scale;
}

std::vector<bool> Scene::State::flags(const std::vector<int>& chosen) const {
  std::vector<bool> result(system.blocks.size(), false);
  for (const int block : chosen) result.at(static_cast<std::size_t>(block)) = true;
  return result;
}

Vec3 Scene::State::drawn_place(std::span<const BlockActors* const> among, const std::vector<bool>& own,
                               const Vec3& rest, const Vec3& otherwise) const {
  double least = std::numeric_limits<double>::infinity();
  Vec3 place = otherwise;
  for (const BlockActors* part : among)
    for (const auto& triangle : part->surface().triangles) {
      if (!own[static_cast<std::size_t>(triangle.block)]) continue;
      for (const int vertex : triangle.vertices) {
        const Vec3 away = rest - part->surface().rest[vertex];
        if (away.squaredNorm() >= least) continue;
        least = away.squaredNorm();
        place = part->positions()[vertex] + away;
      }
    }
  return place;
}

std::optional<PixelPoint> Scene::State::pixel_of(const Vec3& point) const {
  vtkCamera& camera = *renderer->GetActiveCamera();
  const Vec3 eye(camera.GetPosition()), ahead(camera.GetDirectionOfProjection());
  if ((point - eye).dot(ahead) <= 0) return {};
  renderer->SetWorldPoint(point.x(), point.y(), point.z(), 1);
  renderer->WorldToDisplay();
  const double* pixel = renderer->GetDisplayPoint();
  return PixelPoint{pixel[0], pixel[1]};
}

CameraPose Scene::State::pose() const {
  vtkCamera& camera = *renderer->GetActiveCamera();
  CameraPose result;
  result.position = origin + Vec3(camera.GetPosition());
  result.focal_point = origin + Vec3(camera.GetFocalPoint());
  result.view_up = Vec3(camera.GetViewUp());
  result.view_angle = camera.GetViewAngle();
  result.parallel_scale = camera.GetParallelScale();
  result.parallel = camera.GetParallelProjection() != 0;
  return result;
}

void Scene::State::set_pose(const CameraPose& wanted) {
  vtkCamera& camera = *renderer->GetActiveCamera();
  const Vec3 position = wanted.position - origin, focal_point = wanted.focal_point - origin;
  camera.SetPosition(position.data());
  camera.SetFocalPoint(focal_point.data());
  camera.SetViewUp(wanted.view_up.data());
  camera.SetViewAngle(wanted.view_angle);
  camera.SetParallelScale(wanted.parallel_scale);
  camera.SetParallelProjection(wanted.parallel);
  fits_itself = false;
}

}  // namespace talus
