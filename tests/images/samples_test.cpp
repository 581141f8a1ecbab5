// Every sample, light and dark: the blocks that it is cut into, and how its first steps move them.
#include <gtest/gtest.h>

#include <set>

#include "images/baseline.hpp"
#include "images/solved_scene.hpp"
#include "io/project_file.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/slope_view.hpp"
#include "results/field.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int sample_width = 480, sample_height = 300;
constexpr int few_steps = 20;  // of each stage: the rockslide and the bench of 100 blocks take minutes in full

std::set<std::string> all_samples() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(TALUS_SOURCE_DIR) / "samples"))
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  return names;
}

/// From where the picture of each is worth most: blocks that would be hidden are seen.
void look_at(const std::string& name, Scene& scene, const BlockSystem& system) {
  if (name == "wedge")
    scene.look(60, 40);
  else
    look_at_slope(scene, system, nullptr);
}

class SampleImage : public testing::TestWithParam<std::string> {};

TEST_P(SampleImage, IsAsItWas) {
  const fs::path folder = fs::path(TALUS_SOURCE_DIR) / "samples" / GetParam();
  const SolvedScene sample = solved(read_project(folder / (GetParam() + ".talus")), folder, few_steps);
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const std::string ending = theme == Theme::dark ? ".dark" : ".light";
    SceneSettings settings;
    settings.theme = theme;
    settings.title = sample.project.name;
    Scene scene(sample.system, settings);
    look_at(GetParam(), scene, sample.system);
    expect_baseline(draw_image(scene, sample_width, sample_height), "Sample." + GetParam() + ".blocks" + ending);
    settings.field = field_named("displacement");
    scene.set_settings(settings);
    scene.set_frame(sample.frame);
    expect_baseline(draw_image(scene, sample_width, sample_height), "Sample." + GetParam() + ".moved" + ending);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SampleImage, testing::ValuesIn(all_samples()),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace talus
