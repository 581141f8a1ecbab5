#include "side_by_side.hpp"

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "command.hpp"
#include "render/scene/offscreen.hpp"

namespace talus::cli {

namespace {

constexpr std::size_t most_panels = 4;
constexpr int between_panels = 3;  // pixels between two of them

struct Panel {
  explicit Panel(const std::filesystem::path& folder, const FrameChoice& choice)
      : results(folder),
        number(about(folder, [&] { return frame_index(results, choice); })),
        frame(std::make_shared<const Frame>(results.frame(number))) {}

  ResultReader results;
  int number;
  std::shared_ptr<const Frame> frame;
  std::unique_ptr<Scene> scene;
};

using Panels = std::vector<std::unique_ptr<Panel>>;

/// "phi20" of out/phi20.results
std::string name_of(const std::filesystem::path& folder) {
  return std::filesystem::weakly_canonical(folder).stem().string();
}

void make_scenes(const Panels& panels, const std::vector<std::filesystem::path>& folders, const Look& look) {
  const bool alone = panels.size() == 1;
  ValueRange range;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Panel& panel = *panels[i];
    SceneSettings settings = scene_settings(look, panel.results);
    if (!alone) settings.title = (look.title ? *look.title + ": " : "") + name_of(folders[i]);
    about(folders[i], [&] { need_field(panel.results.system(), *panel.frame, settings); });
    if (!alone && settings.field && !look.range)
      range.include(field_range(FieldValues(panel.results.system()), *panel.frame, *settings.field));
    panel.scene = std::make_unique<Scene>(panel.results.system(), settings);
    panel.scene->set_stage_names(panel.results.stage_names());
    panel.scene->set_frame(panel.frame);
    mark_troubles(look, panel.results, *panel.scene);
  }
  point_camera(look, panels.front()->results, *panels.front()->scene);
  if (range.empty()) return;
  for (const auto& panel : panels) {
    SceneSettings settings = panel->scene->settings();
    settings.range = legend_range(*settings.field, range);
    panel->scene->set_settings(settings);
  }
}

/// All look as the first one does, from as far away as the one does that needs the most room.
void share_camera(const Panels& panels, int width, int height) {
  CameraPose farthest;
  double most = -1;
  for (const auto& panel : panels) {
    Scene& scene = *panel->scene;
    if (panel != panels.front()) {
      scene.set_pose(panels.front()->scene->pose());
      scene.fit();
    }
    OffscreenView(scene, width, height).hold_camera();
    const CameraPose pose = scene.pose();
    const double distance = (pose.position - pose.focal_point).norm();
    if (distance <= most) continue;
    most = distance;
    farthest = pose;
  }
  for (const auto& panel : panels) panel->scene->set_pose(farthest);
}

void paste(Image& whole, const Image& part, int left) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(part.rgb.begin() + static_cast<std::ptrdiff_t>(y) * part.width * 3, part.width * 3,
                whole.rgb.begin() + (static_cast<std::ptrdiff_t>(y) * whole.width + left) * 3);
}

Image joined(const Panels& panels, const PictureSize& size, Theme theme) {
  const int count = static_cast<int>(panels.size());
  if (count == 1) return draw_image(*panels.front()->scene, size.width, size.height);
  Image whole(size.width, size.height);
  const Rgb between = colours(theme).frame;
  for (std::size_t i = 0; i < whole.rgb.size(); i += 3) {
    whole.rgb[i] = between.red;
    whole.rgb[i + 1] = between.green;
    whole.rgb[i + 2] = between.blue;
  }
  const int width = (size.width - between_panels * (count - 1)) / count;
  share_camera(panels, width, size.height);
  for (int i = 0; i < count; ++i) {
    const int left = i * (width + between_panels);
    const int own = i + 1 < count ? width : size.width - left;  // the last one takes what division leaves
    paste(whole, draw_image(*panels[static_cast<std::size_t>(i)]->scene, own, size.height), left);
  }
  return whole;
}

}  // namespace

SideBySide draw_side_by_side(const std::vector<std::filesystem::path>& results, const FrameChoice& choice,
                             const Look& look, const PictureSize& size) {
  if (results.size() > most_panels)
    throw InputError("RESULTS", "four are drawn side by side at most", "draw the others into another picture");
  Panels panels;
  SideBySide drawn;
  for (const auto& folder : results) {
    panels.push_back(std::make_unique<Panel>(folder, choice));
    drawn.frames.push_back({folder, panels.back()->number, panels.back()->frame->time});
  }
  make_scenes(panels, results, look);
  drawn.picture = joined(panels, size, look.theme);
  return drawn;
}

}  // namespace talus::cli
