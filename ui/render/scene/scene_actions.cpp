// What acts on the rock, in the picture: arrows, cones, crosses and points of one size on the screen, with labels.
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "base/units.hpp"
#include "fields/pair_forces.hpp"
#include "render/paint/picture_words.hpp"
#include "render/paint/place_marks.hpp"
#include "render/scene/contact_places.hpp"
#include "render/scene/scene_state.hpp"

namespace talus {

namespace {

using Kind = ActionGlyph::Kind;

// In text heights.
constexpr double longest_arrow = 6, shortest_arrow = 1.8, shaft = 0.13, head = 1.1, head_radius = 0.4;
constexpr double cone = 1.3, cone_radius = 0.5, ball = 0.34, longest_bar = 3, bar = 0.11, rim = 0.1;
constexpr double reach = 0.7;  ///< of the hand beside a glyph

Rgb shown_colour(const ActionGlyph& glyph, Theme theme) {
  return glyph.selected ? colours(theme).pick : action_colour(glyph.kind, theme);
}

bool same_but_selected(ActionGlyph one, const ActionGlyph& other) {
  one.selected = other.selected;
  return one == other;
}

/// What the longest arrow of a kind stands for.
std::string longest(const std::string& amount) { return ", " + picture_word("longest") + " " + amount; }

double distance_to_segment(const PixelPoint& p, const PixelPoint& a, const PixelPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double share = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

}  // namespace

Rgb action_colour(Kind kind, Theme theme) {
  const auto& palette = curve_palette(theme);
  switch (kind) {
    case Kind::load:
      return palette[4];
    case Kind::support:
      return palette[2];
    case Kind::velocity:
      return palette[5];
    case Kind::stress:
      return palette[1];
    case Kind::monitor:
      break;
  }
  return palette[0];
}

std::string action_meaning(Kind kind, double largest) {
  switch (kind) {
    case Kind::load:
      return picture_word("load") + longest(amount_text(largest, "N"));
    case Kind::support:
      return picture_word("support");
    case Kind::velocity:
      return picture_word("velocity") + (largest > 0 ? longest(amount_text(largest, "m/s")) : std::string());
    case Kind::stress:
      return picture_word("stress in situ") + longest(amount_text(largest, "Pa"));
    case Kind::monitor:
      break;
  }
  return picture_word("monitor");
}

void Scene::State::set_actions(std::vector<ActionGlyph> glyphs) {
  fit_is_stale = fit_is_stale || !std::ranges::equal(glyphs, actions, same_but_selected);
  actions = std::move(glyphs);
  action_anchors.assign(actions.size(), {});
  std::vector<std::vector<std::size_t>> on_block(system.blocks.size());
  for (std::size_t i = 0; i < actions.size(); ++i)
    if (actions[i].block >= 0) on_block[static_cast<std::size_t>(actions[i].block)].push_back(i);
  const auto away = [&](std::size_t i, const Anchor& anchor) {
    return anchor.part ? (actions[i].at - anchor.part->surface().rest[anchor.vertex]).squaredNorm()
                       : std::numeric_limits<double>::infinity();
  };
  for (const BlockActors* part : parts())
    for (const auto& triangle : part->surface().triangles)
      for (const std::size_t i : on_block[static_cast<std::size_t>(triangle.block)])
        for (const int vertex : triangle.vertices)
          if (away(i, {part, vertex}) < away(i, action_anchors[i])) action_anchors[i] = {part, vertex};
  make_overlay();
}

Vec3 Scene::State::place_of_action(std::size_t i) const {
  const auto& [part, vertex] = action_anchors[i];
  if (!part) return actions[i].at;
  return part->positions()[vertex] + actions[i].at - part->surface().rest[vertex];
}

double Scene::State::metres_per_pixel() const {
  const CameraPose camera = pose();
  const double distance = (camera.position - camera.focal_point).norm();
  const double half_height =
      camera.parallel ? camera.parallel_scale : distance * std::tan(radians(camera.view_angle) / 2);
  return 2 * half_height / size()[1];
}

std::array<Vec3, 2> Scene::State::arrow_of(std::size_t i) const {
  const ActionGlyph& glyph = actions[i];
  const Vec3 at = place_of_action(i) - origin;
  const double largest = largest_of(actions, glyph.kind), size = glyph.arrow.norm();
  if (!(size > 0)) return {at, at};
  const double em = metres_per_pixel() * text_height();
  const Vec3 along = std::max(longest_arrow * size / largest, shortest_arrow) * em * glyph.arrow / size;
  return glyph.pushes ? std::array<Vec3, 2>{at - along, at} : std::array<Vec3, 2>{at, at + along};
}

void Scene::State::add_arrow(const Vec3& from, const Vec3& to, int heads, Rgb colour, double size) {
  const double em = size * metres_per_pixel() * text_height();
  const Vec3 along = (to - from).normalized();
  for (int k = 0; k < heads; ++k) {
    const Vec3 tip = to - k * 0.7 * head * em * along;
    action_shapes.add_bar(tip - head * em * along, tip, head_radius * em, 0, colour);
  }
  action_shapes.add_bar(from, to - head * em * along, shaft * em, shaft * em, colour);
}

void Scene::State::add_cross(const Vec3& at, const std::array<ActionGlyph::Principal, 3>& cross, double largest,
                             Rgb colour, double size) {
  const double em = size * metres_per_pixel() * text_height();
  for (const auto& [direction, value] : cross) {
    const double length = largest > 0 ? longest_bar * std::abs(value) / largest : 0;
    if (length < 0.3) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 outer = at + side * length * em * direction;
      action_shapes.add_bar(at, outer, bar * em, bar * em, colour);
      // Heads point inwards where the rock is pressed, outwards where it is pulled.
      const Vec3 tip = outer + (value > 0 ? side * 0.6 * em : 0) * direction;
      const Vec3 base = value > 0 ? outer : Vec3(outer + side * 0.6 * em * direction);
      action_shapes.add_bar(base, tip, 0.3 * em, 0, colour);
    }
  }
}

void Scene::State::shape_actions() {
  const double em = metres_per_pixel() * text_height();
  action_shapes.clear(rim * em, colours(settings.theme).surface);
  for (std::size_t i = 0; settings.actions && i < actions.size(); ++i) {
    const ActionGlyph& glyph = actions[i];
    const Rgb colour = shown_colour(glyph, settings.theme);
    const Vec3 at = place_of_action(i) - origin;
    if (const auto [from, to] = arrow_of(i); from != to) add_arrow(from, to, 1, colour);
    if (!glyph.spin.isZero()) add_arrow(at, at + longest_arrow / 2 * em * glyph.spin.normalized(), 2, colour);
    for (int axis = 0; axis < 3; ++axis)
      if (glyph.held[static_cast<std::size_t>(axis)])
        action_shapes.add_bar(at - cone * em * Vec3::Unit(axis), at, cone_radius * em, 0, colour);
    if (glyph.kind == Kind::monitor || glyph.kind == Kind::support) action_shapes.add_ball(at, ball * em, colour);
    if (glyph.kind == Kind::stress) add_cross(at, glyph.cross, largest_of(actions, Kind::stress), colour, 1);
  }
  shape_frame_arrows();
  add_axes();
  add_probed_line();
  action_shapes.finish();
}

std::vector<Scene::State::FrameArrow> Scene::State::frame_arrows() const {
  if (!frame || settings.arrows == Arrows::none || settings.arrows == Arrows::principal_stress) return {};
  return settings.arrows == Arrows::velocity ? velocity_arrows() : contact_arrows();
}

/// From the middle of each block's vertices along the mean of their velocities.
std::vector<Scene::State::FrameArrow> Scene::State::velocity_arrows() const {
  std::vector<FrameArrow> arrows;
  const BlockSurface& surface = movable.surface();
  for (std::size_t block = 0; block < system.blocks.size(); ++block) {
    const int begin = surface.begins[block].vertex, end = surface.begins[block + 1].vertex;
    if (begin == end || !movable.shows(static_cast<int>(block))) continue;
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    for (int v = begin; v < end; ++v) {
      place += movable.positions()[v] - origin;
      velocity += frame->velocity[surface.nodes[v]];
    }
    arrows.push_back({place / (end - begin), velocity / (end - begin)});
  }
  return arrows;
}

/// On the one of two blocks that may move; not where blocks are drawn apart, for contacts lie between them.
std::vector<Scene::State::FrameArrow> Scene::State::contact_arrows() const {
  std::vector<FrameArrow> arrows;
  if (settings.explosion > 0) return arrows;
  const auto stands = [this](int block) { return system.blocks[block].body == BodyKind::fixed; };
  for (const PairForce& pair : pair_forces(*frame, contact_places(system, *frame, settings.deformation_scale)))
    arrows.push_back({pair.middle - origin, stands(pair.blocks[0]) ? Vec3(-pair.force) : pair.force});
  return arrows;
}

/// Of each field of a grid on the screen that of the face nearest to the viewer: they cover neither each other nor all
/// of the rock.
std::vector<Scene::State::StressCross> Scene::State::stress_crosses() const {
  constexpr double apart = 3.4;  // text heights
  struct Nearest {
    double depth;
    Vec3 at;
    int tetrahedron;
  };
  std::map<std::array<int, 2>, Nearest> of_fields;
  const Vec3 eye = pose().position - origin;
  for (const int number : movable.drawn()) {
    const BlockSurface::Triangle& face = movable.surface().triangles[number];
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = movable.positions()[face.vertices[k]] - origin;
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    const bool is_seen = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(eye - middle) > 0;
    const auto pixel = pixel_of(middle);
    if (face.tetrahedron < 0 || !is_seen || !pixel) continue;
    const auto field_at = [&](double at) { return static_cast<int>(std::floor(at / (apart * text_height()))); };
    const Nearest here{(eye - middle).norm(), middle, face.tetrahedron};
    auto& nearest = of_fields.try_emplace({field_at(pixel->x), field_at(pixel->y)}, here).first->second;
    if (here.depth < nearest.depth) nearest = here;
  }
  std::vector<StressCross> crosses;
  for (const auto& [field, nearest] : of_fields) {
    StressCross& cross = crosses.emplace_back(StressCross{nearest.at, {}});
    const auto [values, directions] = principal_axes(frame->stress[static_cast<std::size_t>(nearest.tetrahedron)]);
    for (int k = 0; k < 3; ++k) cross.principal[static_cast<std::size_t>(k)] = {directions.col(k), values[k]};
  }
  return crosses;
}

double Scene::State::largest_stress() const {
  double largest = 0;
  for (const int number : movable.drawn())
    if (const int tetrahedron = movable.surface().triangles[number].tetrahedron; tetrahedron >= 0)
      largest = std::max(
          largest, principal_axes(frame->stress[static_cast<std::size_t>(tetrahedron)]).values.cwiseAbs().maxCoeff());
  return largest;
}

void Scene::State::shape_frame_arrows() {
  if (frame && settings.arrows == Arrows::principal_stress) {
    constexpr double size = 0.5;  // of crosses of stress in situ, which are few
    const double largest = largest_stress();
    for (const StressCross& cross : stress_crosses())
      add_cross(cross.at, cross.principal, largest, colours(settings.theme).pick, size);
  }
  constexpr double least_seen = 0.03;  // of the longest
  std::vector<FrameArrow> arrows = frame_arrows();
  const double longest = largest_value(arrows);
  std::erase_if(arrows, [&](const FrameArrow& arrow) { return !(arrow.value.norm() > least_seen * longest); });
  const double among = size_among(arrows), em = among * metres_per_pixel() * text_height();
  for (const FrameArrow& arrow : arrows) {
    const double size = arrow.value.norm();
    const Vec3 along = std::max(longest_arrow * size / longest, shortest_arrow) * em * arrow.value / size;
    add_arrow(arrow.at, arrow.at + along, 1, colours(settings.theme).pick, among);
  }
}

double Scene::State::size_among(const std::vector<FrameArrow>& arrows) const {
  constexpr double least = 0.3, over_distance = 2;  // of the usual size; of the longest one
  if (arrows.size() < 2) return 1;
  const CameraPose camera = pose();
  const Vec3 to_viewer = (camera.position - camera.focal_point).normalized();
  const Vec3 right = camera.view_up.cross(to_viewer).normalized(), up = to_viewer.cross(right);
  Eigen::AlignedBox2d box;
  for (const FrameArrow& arrow : arrows) box.extend(Eigen::Vector2d(right.dot(arrow.at), up.dot(arrow.at)));
  const auto count = static_cast<double>(arrows.size());
  const double side = box.sizes().maxCoeff(), apart = std::sqrt(std::max(box.volume(), side * side / count) / count);
  const double usual = longest_arrow * metres_per_pixel() * text_height();
  return std::clamp(over_distance * apart / usual, least, 1.0);
}

double Scene::State::largest_value(const std::vector<FrameArrow>& arrows) {
  double largest = 0;
  for (const FrameArrow& arrow : arrows) largest = std::max(largest, arrow.value.norm());
  return largest;
}

KeyEntry Scene::State::meaning_of_arrows() const {
  if (settings.arrows == Arrows::principal_stress)
    return {colours(settings.theme).pick,
            picture_word("principal stresses") + longest(amount_text(largest_stress(), "Pa"))};
  const std::vector<FrameArrow> arrows = frame_arrows();
  const bool of_velocity = settings.arrows == Arrows::velocity;
  return {colours(settings.theme).pick, picture_word(of_velocity ? "velocity" : "contact force") +
                                            longest(amount_text(largest_value(arrows), of_velocity ? "m/s" : "N"))};
}

std::vector<PixelRect> Scene::State::paint_actions(Painter& painter) const {
  std::vector<PixelRect> taken = covered;
  if (!settings.actions) return taken;
  std::vector<PlaceMark> marks;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (actions[i].label.empty()) continue;
    const auto [from, to] = arrow_of(i);
    if (const auto pixel = pixel_of(actions[i].pushes ? from : to)) marks.push_back({*pixel, actions[i].label});
  }
  const auto [width, height] = size();
  const MarkedPicture picture{settings.theme, text_height(), width, height, covered};
  paint_labels(painter, marks, picture);
  std::ranges::copy(label_places(marks, picture), std::back_inserter(taken));
  return taken;
}

std::optional<ActionGlyph> Scene::State::action_at(const PixelPoint& pixel) const {
  if (!settings.actions) return {};
  std::optional<ActionGlyph> found;
  double least = reach * text_height();
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const auto [from, to] = arrow_of(i);
    const auto a = pixel_of(from), b = pixel_of(to);
    if (!a || !b) continue;
    const double away = distance_to_segment(pixel, *a, *b);
    if (away > least) continue;
    least = away;
    found = actions[i];
  }
  return found;
}

void Scene::set_actions(std::vector<ActionGlyph> glyphs) { state_->set_actions(std::move(glyphs)); }

std::optional<ActionGlyph> Scene::action_at(double x, double y) const {
  if (state_->renderer->GetRenderWindow() == nullptr) return {};
  return state_->action_at({x, state_->size()[1] - 1 - y});
}

}  // namespace talus
