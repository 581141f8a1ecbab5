#include "session/field_line.hpp"

#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/picking.hpp"
#include "session/playback.hpp"

namespace talus {

FieldLine::FieldLine(CurrentProject& project, Playback& playback, Display& display, Picking& picking)
    : project_(project), playback_(playback), display_(display), picking_(picking) {
  connect(&playback, &Playback::framesChanged, this, [this] {
    if (playback_.times().empty()) remove();
  });
  connect(&playback, &Playback::frameChanged, this, &FieldLine::changed);
  connect(&display, &Display::changed, this, &FieldLine::changed);
  connect(&display, &Display::themeChanged, this, &FieldLine::changed);
}

bool FieldLine::isPossible() const { return playback_.frame() && project_.system(); }

void FieldLine::ask(const QString& prompt) {
  picking_.ask(prompt, 2, [this](const std::vector<PickedPlace>& places) {
    draw(std::array{places[0].seen(), places[1].seen()});
  });
}

void FieldLine::remove() { draw(std::nullopt); }

void FieldLine::draw(const std::optional<std::array<Vec3, 2>>& ends) {
  SceneSettings settings = display_.settings();
  if (settings.probed_line == ends) return;
  settings.probed_line = ends;
  display_.set(settings);
}

const std::optional<std::array<Vec3, 2>>& FieldLine::ends() const { return display_.settings().probed_line; }

const Field& FieldLine::field() const {
  return display_.settings().field ? *display_.settings().field : field_named("displacement");
}

LineProbe FieldLine::probe() const {
  const auto& line = ends();
  if (!line || !isPossible() || (*line)[0] == (*line)[1]) return {};
  return probe_line(*project_.system(), *playback_.frame(), field(), (*line)[0], (*line)[1]);
}

std::string FieldLine::table() const {
  return probe_csv(probe(), *project_.system(), field(), (*ends())[0], (*ends())[1]);
}

Theme FieldLine::theme() const { return display_.settings().theme; }

}  // namespace talus
