#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/paint/theme.hpp"
#include "render/scene/joint_face.hpp"

class vtkRenderer;

namespace talus {

/// Joints as translucent faces in the colours of their sets, in front of translucent rock; the chosen ones stronger
/// and outlined.
class JointActors {
 public:
  /// Positions are drawn relative to `origin`, m.
  explicit JointActors(const Vec3& origin);
  void add_to(vtkRenderer& renderer);
  /// `faces` null: none. False where they are drawn like this already.
  bool show(std::shared_ptr<const std::vector<JointFace>> faces, std::vector<int> chosen);
  void style(double line_width);
  void use(Theme theme);
  /// The cut whose face a line of sight meets first.
  std::optional<int> cut_at(const Vec3& from, const Vec3& along) const;

 private:
  std::span<const JointFace> shown() const;
  void draw();
  void colour();

  Vec3 origin_;
  std::shared_ptr<const std::vector<JointFace>> faces_;
  std::vector<int> chosen_;  ///< cuts
  Theme theme_ = Theme::light;
  vtkNew<vtkPolyData> mesh_, lines_;
  vtkNew<vtkActor> face_actor_, line_actor_;
};

}  // namespace talus
