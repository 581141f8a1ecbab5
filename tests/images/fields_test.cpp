// Every field of results, light and dark, of one run.
#include <gtest/gtest.h>

#include "images/baseline.hpp"
#include "images/solved_scene.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/slope_view.hpp"
#include "results/field.hpp"

namespace talus {
namespace {

constexpr int field_width = 480, field_height = 300;

class FieldImage : public testing::TestWithParam<Theme> {};

TEST_P(FieldImage, OfEachFieldIsAsItWas) {
  const SolvedScene& slab = sliding_slab();
  SceneSettings settings;
  settings.theme = GetParam();
  Scene scene(slab.system, settings);
  scene.set_frame(slab.frame);
  look_at_slope(scene, slab.system, slab.frame.get());
  OffscreenView view(scene, field_width, field_height);
  for (const Field& field : all_fields()) {
    settings.field = field;
    settings.title = field.title;
    scene.set_settings(settings);
    expect_baseline(view.draw(),
                    "Field." + std::string(field.name) + (settings.theme == Theme::dark ? ".dark" : ".light"));
  }
}

INSTANTIATE_TEST_SUITE_P(Light, FieldImage, testing::Values(Theme::light));
INSTANTIATE_TEST_SUITE_P(Dark, FieldImage, testing::Values(Theme::dark));

}  // namespace
}  // namespace talus
