#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/block.hpp"
#include "render/fields/field_range.hpp"
#include "render/paint/theme.hpp"
#include "render/scene/action_glyphs.hpp"
#include "render/scene/block_colours.hpp"
#include "render/scene/joint_face.hpp"
#include "results/convergence_trouble.hpp"
#include "results/frame.hpp"

class vtkCamera;
class vtkRenderer;

namespace talus {

struct BlockTrails;
struct PixelRect;

enum class View { iso, front, back, left, right, top };
enum class Edges { none, blocks, mesh };
/// What arrows show of a frame: how blocks move, how they push each other, or the principal stresses in them.
enum class Arrows { none, velocity, contact_force, principal_stress };

/// Of which blocks the way of the centre up to the frame is drawn.
enum class Trails { none, selected, all };

/// "iso", "front", "back", "left", "right", "top"; throws InputError that lists them.
View view_named(std::string_view name);

/// What lies on the side that `towards` points to is not drawn.
struct SectionPlane {
  Vec3 point = Vec3::Zero();     ///< m
  Vec3 towards = Vec3::UnitZ();  ///< unit
  bool operator==(const SectionPlane&) const = default;
};

/// What a scene shows and how. Plain values; hand a changed copy to Scene::set_settings.
struct SceneSettings {
  Theme theme = Theme::light;
  std::optional<Field> field;  ///< colours the movable blocks; empty: a colour a block
  /// Of blocks that no field colours; null, or of other blocks: each has its own, fixed ones are grey.
  std::shared_ptr<const BlockColours> block_colours{};
  std::vector<MarkedPlace> places{};
  std::optional<ValueRange> range;  ///< of the legend, SI; empty: of the frame that is shown
  /// Of the field, SI: of faces whose value lies outside, and of rock that it does not colour, the edges alone are
  /// drawn.
  std::optional<ValueRange> only{};
  Arrows arrows = Arrows::none;  ///< in front of everything, the longest of one length
  Trails trails = Trails::none;  ///< as far as they were told
  bool turning_axes = false;     ///< about which blocks turn in the frame
  /// Both ends of a line that a field is followed along [m], drawn in front of everything.
  std::optional<std::array<Vec3, 2>> probed_line{};
  Edges edges = Edges::blocks;
  double deformation_scale = 1;           ///< displacements are drawn this many times too large
  double explosion = 0;                   ///< blocks are drawn apart, by so much of their way from the middle of all
  std::optional<SectionPlane> section{};  ///< the blocks are seen cut open, where they are not drawn apart
  bool contacts = false;                  ///< contact points, coloured open grey, stick blue, slip orange
  bool troubles = true;                   ///< where the run has trouble to converge, as far as it was told
  bool joints = true;                     ///< of the project, where they are set up
  double rock_opacity = 1;                ///< below 1 joints inside the rock are seen through it
  bool actions = true;                    ///< what acts on the rock and watches it, as far as it was told
  bool parallel_projection = false;
  bool fine = true;  ///< ambient occlusion and smooth edges; off while the user drags
  /// Smooths outlines of pictures that are drawn at their own size. On a screen it would break thin edges into dashes.
  bool smooth_outlines = true;

  std::string title;   ///< top left; empty: none
  std::string remark;  ///< beside the time: how fast a film goes
  bool legend = true, time_stamp = true, triad = true, scale_bar = true;
  double text_height = 0;  ///< pixels; 0: grows with the picture's height
};

/// Blocks of other results, at a moment, that are drawn over a scene's own as outlines.
struct Ghost {
  std::shared_ptr<const BlockSystem> system;  ///< null: none
  std::shared_ptr<const Frame> frame;
  std::string name;  ///< for the key
};

/// Blocks of someone who outlives who takes them.
inline std::shared_ptr<const BlockSystem> borrowed(const BlockSystem& system) {
  return {std::shared_ptr<const BlockSystem>(), &system};
}

/// Where the camera stands; to carry a view from the window to a picture.
struct CameraPose {
  Vec3 position, focal_point, view_up;  ///< m, in the project's coordinates
  double view_angle = 26;               ///< degrees, perspective
  double parallel_scale = 1;            ///< m, half the height of a parallel view
  bool parallel = false;
};

/// What lies under a pixel.
struct Pick {
  int block = -1;
  Vec3 position;                ///< m, in the project's coordinates, where the ray meets the drawn surface
  int facet = -1;               ///< of the block's surface, index into Block::surface
  Vec3 rest;                    ///< m, the same point of the rock before anything moved
  int node = -1;                ///< nearest node of the triangle that was hit, numbered through all blocks
  int tetrahedron = -1;         ///< the one behind the triangle, numbered through all blocks
  std::optional<double> value;  ///< of the field that is shown, SI
};

/// A line of sight, in the project's coordinates.
struct SightLine {
  Vec3 from = Vec3::Zero();    ///< m
  Vec3 along = Vec3::UnitX();  ///< away from the viewer, of unit length
};

/// The blocks of a project as a picture: what the window shows and what is drawn off-screen. Knows no window:
/// `renderer()` is added to a RenderWindow (or the scene handed to OffscreenView); the scene then is drawn by
/// the window's Render(). Setters only change what the next drawing shows.
/// Keeps a reference to `system`, which must outlive it. One thread at a time.
class Scene {
 public:
  explicit Scene(const BlockSystem& system, SceneSettings settings = {});
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const SceneSettings& settings() const;
  void set_settings(SceneSettings settings);

  /// Moves the blocks, colours and the time stamp to this frame. Throws std::invalid_argument when its node or
  /// tetrahedron counts are not the system's.
  void set_frame(std::shared_ptr<const Frame> frame);
  /// Back to the undeformed blocks, without time stamp.
  void clear_frame();
  /// Names shown beside the time, by Frame::stage.
  void set_stage_names(std::vector<std::string> names);

  /// Lets `fit` frame this frame too, so that a film whose first and last frames (or all) were included never
  /// leaves the picture. The undeformed blocks are included from the start.
  void include_in_view(const Frame& frame);

  /// Turns the camera to a named side and fits. Front looks north, left looks east, top has north up;
  /// iso stands in the south-west, 30° up.
  void look(View view);
  /// Stands at `azimuth` degrees clockwise from north as seen from the blocks, `elevation` degrees up, and fits.
  void look(double azimuth, double elevation);
  /// Keeps the direction and frames everything visible in the part of the picture that legend and texts leave free.
  /// Pictures are fitted anew to their size, and to what acts on the rock, until `set_pose` is called.
  void fit();
  bool fits_itself() const;
  /// Stands where another scene was fitted, and counts as fitted.
  void take_fit(const CameraPose& pose);
  CameraPose pose() const;
  void set_pose(const CameraPose& pose);

  /// For each block triangles of its nodes that show about the same surface with fewer of them: they are drawn where
  /// the rock is seen through, and drawn again and again. Nothing else knows of them.
  void set_thinned(std::span<const std::span<const std::array<int, 3>>> triangles);

  /// By index into BlockSystem::blocks.
  void set_hidden(std::vector<int> blocks);
  void set_selected(std::vector<int> blocks);
  void set_hovered(std::optional<int> block);
  /// Joints inside the rock, null: none; `chosen`: the cuts that are drawn stronger. False where nothing changes.
  bool set_joints(std::shared_ptr<const std::vector<JointFace>> faces, std::vector<int> chosen);
  /// The cut whose face lies under a pixel, whatever rock is before it. Needs what `pick` needs.
  std::optional<int> joint_at(double x, double y) const;
  /// The flat face that a pick lies on; none: no face is marked.
  void set_marked_face(const std::optional<Pick>& pick);
  /// Where the run has trouble to converge: a ring and a label over everything, and a fine outline of the blocks. A
  /// mark goes with its block from frame to frame; blocks that the system does not have are passed over.
  void set_troubles(std::vector<ConvergenceTrouble> troubles);
  /// A pose that looks the way the camera looks now, at the place of a trouble, with the smaller of its blocks whole.
  CameraPose pose_at(const ConvergenceTrouble& trouble) const;
  /// The same of a marked place.
  CameraPose pose_at(const MarkedPlace& place) const;

  /// Loads, supports, velocities, stress in situ and monitors, in front of everything and of one size on the screen.
  void set_actions(std::vector<ActionGlyph> glyphs);
  /// The one of them under a pixel counted from the picture's upper left corner. Needs what `pick` needs.
  std::optional<ActionGlyph> action_at(double x, double y) const;

  /// Draws the edges of movable blocks of other results in front of everything, moved as many times too far as its own.
  void set_ghost(Ghost ghost);
  /// The ways of the blocks' centres through all frames; null: not known.
  void set_trails(std::shared_ptr<const BlockTrails> trails);

  /// Where something lies over the picture, pixels from its lower left corner: labels keep out of it, and
  /// so does rock that is fitted, where that is along the right edge.
  void set_covered(std::vector<PixelRect> places);

  /// The part of the picture in whose middle the camera looks, of its width and height: 0…1 from the lower left corner.
  PixelRect rock_area() const;
  /// That of a scene beside this one, so that rock stands alike in both; empty: what is written leaves it.
  void set_rock_area(const std::optional<PixelRect>& part);

  /// The visible surface under a pixel counted from the picture's upper left corner; empty over the background.
  /// Needs a renderer that is in a window of known size, but no GL context.
  std::optional<Pick> pick(double x, double y) const;

  /// Where a point [m, in the project's coordinates] is drawn, pixels from the picture's upper left corner; empty
  /// behind the viewer. Needs what `pick` needs.
  std::optional<std::array<double, 2>> pixel_of(const Vec3& point) const;
  /// Through a pixel, from the near end of what is drawn. Needs what `pick` needs.
  std::optional<SightLine> sight_at(double x, double y) const;
  /// Where a point of a block at rest is drawn in the frame that is shown, m.
  Vec3 drawn_place(int block, const Vec3& rest) const;

  /// Blocks that are shown and lie in a closed outline in the picture, its corners in pixels from the upper left
  /// corner: wholly, or where `touched` is said with a corner of the surface. Ascending. Needs what `pick` needs.
  std::vector<int> blocks_in(std::span<const std::array<double, 2>> outline, bool touched) const;
  /// The same of a rectangle.
  std::vector<int> blocks_in(double left, double top, double right, double bottom, bool touched) const;

  /// Colour that a block has when coloured by block (for tables and trees).
  Rgb block_colour(int block) const;
  /// Range the legend shows now; empty when no field is shown.
  std::optional<ValueRange> shown_range() const;

  vtkRenderer* renderer() const;

 private:
  friend class OffscreenView;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
