#pragma once

#include <memory>
#include <vector>

#include "render/scene/offscreen.hpp"

namespace talus {

/// Scenes beside each other in one picture, in rows as panel_grid finds them, a line of the theme between them; one
/// alone is the picture. As OffscreenView to be made, used and destroyed on one thread.
class SideBySideView {
 public:
  /// At least one. Throws InputError for sizes that leave a scene less than 16 pixels, or are above 8192.
  SideBySideView(std::vector<Scene*> scenes, int width, int height, Sampling sampling);
  ~SideBySideView();
  SideBySideView(const SideBySideView&) = delete;
  SideBySideView& operator=(const SideBySideView&) = delete;

  /// Fits those whose camera was not set: all then look as the first one does, from as far away as the one that needs
  /// the most room, and stand still.
  void hold_camera();
  CameraPose pose() const;
  void set_pose(const CameraPose& pose);
  Image draw();

 private:
  void stand_alike();

  struct Panel {
    std::unique_ptr<OffscreenView> view;
    int left = 0, top = 0;  ///< pixels, of the whole
  };

  std::vector<Scene*> scenes_;
  std::vector<Panel> panels_;
  int width_, height_;
};

}  // namespace talus
