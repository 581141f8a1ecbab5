// Fields of joints on the walls of joints, those of whole blocks, and what a field's colours mean.
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/fields/field_classes.hpp"
#include "render/paint/colour_map.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"
#include "render/scene/scene_state.hpp"

namespace talus {

namespace {

constexpr double opacity_before_walls = 0.16;

}  // namespace

bool Scene::State::shows_walls() const {
  return frame && settings.field && settings.field->place() == FieldPlace::wall;
}

bool Scene::State::shows_blocks() const {
  return frame && settings.field && settings.field->place() == FieldPlace::block;
}

Rgb Scene::State::colour_by_field(int block) const {
  const auto index = static_cast<std::size_t>(block);
  const bool told = settings.field->is_class() || system.blocks[index].body != BodyKind::fixed;
  const double value = field_values[index];
  return told && std::isfinite(value) ? of_field(value) : colours(settings.theme).rock;
}

double Scene::State::opacity() const {
  const bool in_the_way = shows_walls() && settings.explosion == 0;
  return in_the_way ? std::min(settings.rock_opacity, opacity_before_walls) : settings.rock_opacity;
}

std::function<Rgb(double)> Scene::State::field_colours() const {
  const Field& field = *settings.field;
  if (field.is_class())
    return [classes = classes_of(field)](double value) { return classes.at(static_cast<std::size_t>(value)).colour; };
  const ColourMap* const map = is_signed(field) ? &vik() : &batlow();
  return
      [map, range = colour_range()](double value) { return map->at((value - range.low) / (range.high - range.low)); };
}

void Scene::State::draw_walls() {
  walls_are_stale = false;
  if (!shows_walls()) return walls.hide();
  std::vector<Vec3> at(frame->displacement.size());  // a node, as it is drawn
  for (const BlockActors* part : parts()) {
    const BlockSurface& surface = part->surface();
    for (std::size_t v = 0; v < surface.nodes.size(); ++v)
      at[static_cast<std::size_t>(surface.nodes[v])] = part->positions()[v];
  }
  std::vector<Vec3> places;
  for (const WallPoint& point : fields.walls().points)
    places.push_back(SurfacePlace{point.place.nodes, point.corner}.of(at));
  std::vector<bool> shown = flags(hidden);
  shown.flip();
  walls.show(fields.walls(), places, field_values, shown, {of_field, settings.only, settings.field->is_class()});
}

bool Scene::State::leaves_out_faces() const {
  return settings.only && !field_values.empty() && !settings.field->is_class() && !shows_walls();
}

void Scene::State::keep_wanted_faces() {
  if (!leaves_out_faces()) {
    for (BlockActors* part : {&fixed, &movable}) part->keep({});
    return;
  }
  const ValueRange wanted = *settings.only;
  const auto value_of = [this](const BlockSurface::Triangle& triangle) {
    const auto value = [this](int i) { return field_values[static_cast<std::size_t>(i)]; };
    if (shows_blocks()) return value(triangle.block);
    if (settings.field->place() == FieldPlace::tetrahedron)
      return triangle.tetrahedron < 0 ? std::numeric_limits<double>::quiet_NaN() : value(triangle.tetrahedron);
    double sum = 0;
    for (const int vertex : triangle.vertices)
      sum += value(movable.surface().nodes[static_cast<std::size_t>(vertex)]) / 3;
    return sum;
  };
  fixed.keep([](int) { return false; });
  movable.keep([&](int t) {
    const double value = value_of(movable.surface().triangles[static_cast<std::size_t>(t)]);
    return value >= wanted.low && value <= wanted.high;
  });
}

void Scene::State::explain_field() {
  const Field& field = *settings.field;
  if (const std::string absent = why_absent(system, *frame, field); !absent.empty()) {
    overlay.remarks = picture_word(absent);
    return;
  }
  if (!settings.legend) return;
  if (field.is_class()) {
    overlay.colour_key = ColourKey{picture_word(field.title), {}};
    double value = 0;
    for (const FieldClass& each : classes_of(field))  // of blocks those that are there: they may be many
      if (std::ranges::count(field_values, value++) > 0 || !shows_blocks())
        overlay.colour_key->entries.push_back({each.colour, each.word});
    return;
  }
  const ValueRange range = colour_range();
  const DisplayUnit unit = display_unit(field.unit, std::max(std::abs(range.low), std::abs(range.high)));
  overlay.legend = Legend{.title = picture_word(field.title),
                          .unit = unit.name,
                          .map = is_signed(field) ? &vik() : &batlow(),
                          .low = range.low * unit.factor,
                          .high = range.high * unit.factor};
}

}  // namespace talus
