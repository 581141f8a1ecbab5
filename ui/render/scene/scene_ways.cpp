// Lines through space in the picture: the trails of blocks, the axes about which they turn, a line that is probed.
#include <algorithm>

#include "base/units.hpp"
#include "measures/block_trails.hpp"
#include "render/paint/picture_words.hpp"
#include "render/scene/scene_state.hpp"

namespace talus {

namespace {

constexpr double same_moment = 1e-9;  // of a time: frames are told of by their times

}  // namespace

void Scene::State::draw_ways() {
  draw_trails();
  find_axes();
  draw_ghost();
}

/// Not where blocks are drawn apart: nothing of them lies on its way then.
void Scene::State::draw_trails() {
  std::vector<Way> drawn;
  const bool wanted = frame && trails && settings.trails != Trails::none && settings.explosion == 0;
  const std::vector<bool> chosen = flags(settings.trails == Trails::selected ? selected : std::vector<int>());
  for (std::size_t b = 0; wanted && b < system.blocks.size(); ++b) {
    if (!movable.shows(static_cast<int>(b)) || system.blocks[b].body == BodyKind::fixed) continue;
    if (settings.trails == Trails::selected && !chosen[b]) continue;
    Way way{{}, mix(colours(settings.theme).edge, block_colours[b], 0.35)};
    const Vec3& rest = trails->rest[b];
    for (std::size_t i = 0; i < trails->times.size(); ++i) {
      if (trails->times[i] > frame->time * (1 + same_moment)) break;
      way.points.push_back(rest + settings.deformation_scale * ((*trails->centroids[i])[b] - rest) - origin);
    }
    if (way.points.size() > 1) drawn.push_back(std::move(way));
  }
  ways.show(drawn);
}

/// They are places of the rock as it is, not of what is drawn of it.
void Scene::State::find_axes() {
  axes_of_frame.clear();
  if (!frame || !settings.turning_axes || settings.explosion > 0 || settings.deformation_scale != 1) return;
  for (const TurningAxis& axis : turning_axes(system, *frame))
    if (movable.shows(axis.block)) axes_of_frame.push_back(axis);
}

void Scene::State::add_axes() {
  for (const TurningAxis& axis : axes_of_frame) {
    const Vec3 half = 1.15 * axis.size * axis.direction, at = axis.point - origin;
    add_arrow(at - half, at + half, 2, colours(settings.theme).pick, 0.6);
  }
}

KeyEntry Scene::State::meaning_of_axes() const {
  double fastest = 0;
  for (const TurningAxis& axis : axes_of_frame) fastest = std::max(fastest, axis.rate);
  return {colours(settings.theme).pick, picture_word("axes of rotation") + ", " + picture_word("fastest") + " " +
                                            amount_text(degrees(fastest), "°/s")};
}

void Scene::State::add_probed_line() {
  if (!settings.probed_line) return;
  constexpr double bar = 0.13, ball = 0.4;  // text heights
  const double em = metres_per_pixel() * text_height();
  const Vec3 from = (*settings.probed_line)[0] - origin, to = (*settings.probed_line)[1] - origin;
  const Rgb colour = colours(settings.theme).pick;
  action_shapes.add_bar(from, to, bar * em, bar * em, colour);
  for (const Vec3& end : {from, to}) action_shapes.add_ball(end, ball * em, colour);
}

/// Not where blocks are drawn apart, as trails.
void Scene::State::draw_ghost() {
  std::vector<Way> edges;
  if (ghost_surface && settings.explosion == 0) {
    const auto place = [&](int vertex) -> Vec3 {
      const auto node = static_cast<std::size_t>(ghost_surface->nodes[static_cast<std::size_t>(vertex)]);
      return ghost_surface->rest[static_cast<std::size_t>(vertex)] +
             settings.deformation_scale * ghost.frame->displacement[node] - origin;
    };
    for (const BlockSurface::Edge& edge : ghost_surface->edges)
      if (edge.sharp)
        edges.push_back({{place(edge.vertices[0]), place(edge.vertices[1])}, colours(settings.theme).pick});
  }
  ghost_edges.show(edges);
}

void Scene::set_ghost(Ghost ghost) {
  State& s = *state_;
  if (ghost.system && ghost.system != s.ghost.system) {
    std::vector<bool> may_move;
    for (const Block& block : ghost.system->blocks) may_move.push_back(block.body != BodyKind::fixed);
    s.ghost_surface = block_surface(*ghost.system, may_move);
  }
  if (!ghost.system) s.ghost_surface.reset();
  s.ghost = std::move(ghost);
  s.draw_ghost();
  s.make_overlay();
}

void Scene::set_trails(std::shared_ptr<const BlockTrails> trails) {
  if (trails && trails->rest.size() != state_->system.blocks.size()) trails.reset();
  state_->trails = std::move(trails);
  state_->draw_trails();
}

}  // namespace talus
