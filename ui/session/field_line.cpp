#include "session/field_line.hpp"

#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/picking.hpp"
#include "session/playback.hpp"

namespace talus {

FieldLine::FieldLine(CurrentProject& project, Playback& playback, Display& display, Picking& picking)
    : project_(project), playback_(playback), display_(display), picking_(picking) {
  connect(&playback, &Playback::framesChanged, this, [this] {
    if (playback_.times().empty()) ends_.reset();
  });
  connect(&playback, &Playback::frameChanged, this, &FieldLine::changed);
  connect(&display, &Display::changed, this, &FieldLine::changed);
  connect(&display, &Display::themeChanged, this, &FieldLine::changed);
}

bool FieldLine::isPossible() const { return playback_.frame() && project_.system(); }

void FieldLine::ask(const QString& prompt) {
  picking_.ask(prompt, 2, [this](const std::vector<PickedPlace>& places) {
    ends_ = {places[0].seen(), places[1].seen()};
    emit changed();
  });
}

const Field& FieldLine::field() const {
  return display_.settings().field ? *display_.settings().field : field_named("displacement");
}

LineProbe FieldLine::probe() const {
  if (!ends_ || !isPossible() || (*ends_)[0] == (*ends_)[1]) return {};
  return probe_line(*project_.system(), *playback_.frame(), field(), (*ends_)[0], (*ends_)[1]);
}

std::string FieldLine::table() const {
  return probe_csv(probe(), *project_.system(), field(), (*ends_)[0], (*ends_)[1]);
}

Theme FieldLine::theme() const { return display_.settings().theme; }

}  // namespace talus
