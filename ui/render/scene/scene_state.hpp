#pragma once

#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include "fields/field_values.hpp"
#include "measures/turning_axes.hpp"
#include "render/fields/wall_actor.hpp"
#include "render/gl/solid_shapes.hpp"
#include "render/gl/way_actor.hpp"
#include "render/scene/backdrop.hpp"
#include "render/scene/block_actors.hpp"
#include "render/scene/camera_fit.hpp"
#include "render/scene/contact_actor.hpp"
#include "render/scene/joint_actors.hpp"
#include "render/scene/overlay.hpp"
#include "render/scene/scene.hpp"
#include "render/scene/section_actor.hpp"

namespace talus {

/// The colour of the glyphs of a kind, and what the key says of them.
Rgb action_colour(ActionGlyph::Kind kind, Theme theme);
std::string action_meaning(ActionGlyph::Kind kind, double largest);

/// The inside of Scene; OffscreenView sets its size.
struct Scene::State {
  State(const BlockSystem& blocks, SceneSettings wanted);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void apply(SceneSettings wanted);
  /// Shows a frame; null: the undeformed blocks.
  void take(std::shared_ptr<const Frame> shown);
  /// Backdrop, projection, opacity.
  void style();
  /// Puts the movable blocks, and the contacts between them, where frame and settings say.
  void move();
  void place_contacts();
  void colour();
  /// Draws what is not hidden, its colours and marks.
  void show();
  void mark_troubles();
  void mark_hovered();
  void mark_face();
  void apply_lines();
  void make_overlay();
  /// Where a point of the chosen blocks at rest lies in the frame that is shown: goes with their nearest vertex in
  /// these parts; `otherwise` where there is none [m].
  Vec3 drawn_place(std::span<const BlockActors* const> among, const std::vector<bool>& own, const Vec3& rest,
                   const Vec3& otherwise) const;
  /// Pixel of a point [m from the origin]; none where it is behind the viewer.
  std::optional<PixelPoint> pixel_of(const Vec3& point) const;
  /// Where the point of rock that a trouble is about lies in the frame that is shown [m].
  Vec3 place_of(const ConvergenceTrouble& trouble) const;
  CameraPose pose_at(const ConvergenceTrouble& trouble) const;
  /// Looks the way the camera looks now, at something of a size [m] about a place [m].
  CameraPose pose_at(const Vec3& place, double size) const;
  std::vector<int> blocks_of(const ConvergenceTrouble& trouble) const;
  /// Labels keep out of what is taken.
  void paint_marks(Painter& painter, std::vector<PixelRect> taken) const;
  /// The chosen colours; null where there are none of these blocks.
  const BlockColours* chosen_colours() const;
  Rgb colour_of(int block) const;
  void set_actions(std::vector<ActionGlyph> glyphs);
  /// Where a glyph lies in the frame that is shown [m].
  Vec3 place_of_action(std::size_t i) const;
  /// From where to where its arrow goes [m from the origin]; twice its place for one without.
  std::array<Vec3, 2> arrow_of(std::size_t i) const;
  void shape_actions();
  /// `size`: of its head, of the usual.
  void add_arrow(const Vec3& from, const Vec3& to, int heads, Rgb colour, double size = 1);
  /// Bars along principal stresses at a place [m from the origin]; the longest stands for `largest` [Pa]. `size`: of
  /// the usual.
  void add_cross(const Vec3& at, const std::array<ActionGlyph::Principal, 3>& cross, double largest, Rgb colour,
                 double size);
  /// Principal stresses behind faces that are seen, and the largest behind any [Pa].
  struct StressCross {
    Vec3 at;  ///< m from the origin
    std::array<ActionGlyph::Principal, 3> principal;
  };
  std::vector<StressCross> stress_crosses() const;
  /// Returns what labels have to keep out of from now on: what covers the view, and its own labels.
  std::vector<PixelRect> paint_actions(Painter& painter) const;
  std::optional<ActionGlyph> action_at(const PixelPoint& pixel) const;
  /// At the depth of the focal point.
  double metres_per_pixel() const;
  void reset_extent();
  /// Blocks are seen cut open.
  bool is_cut() const { return settings.section && settings.explosion == 0; }
  void cut_open();
  void fill_section();
  /// The field is one of the walls of joints: these have its colours, and the rock is in their way.
  bool shows_walls() const;
  /// Of some blocks the edges alone may be drawn: the field has other values there than are wanted.
  bool leaves_out_faces() const;
  /// The field has a value a block.
  bool shows_blocks() const;
  void draw_walls();
  /// Of the rock: seen through where it is in the way, unless blocks are drawn apart.
  double opacity() const;
  /// Of a block by its own value; rock where it has none, or is fixed and not of a class.
  Rgb colour_by_field(int block) const;
  /// Colours of values of the field that is shown.
  std::function<Rgb(double value)> field_colours() const;
  /// Leaves faces out whose value is not wanted.
  void keep_wanted_faces();
  /// Of the frame, m from the origin, and what they stand for [m/s or N].
  struct FrameArrow {
    Vec3 at, value;
  };
  std::vector<FrameArrow> frame_arrows() const;
  std::vector<FrameArrow> velocity_arrows() const;
  std::vector<FrameArrow> contact_arrows() const;
  static double largest_value(const std::vector<FrameArrow>& arrows);
  /// Of their usual size, that of arrows which stand close on the screen: a crowd would hide the rock.
  double size_among(const std::vector<FrameArrow>& arrows) const;
  double largest_stress() const;
  void shape_frame_arrows();
  KeyEntry meaning_of_arrows() const;
  /// Trails, and axes of rotation.
  void draw_ways();
  void draw_trails();
  void find_axes();
  void add_axes();
  KeyEntry meaning_of_axes() const;
  void add_probed_line();
  void draw_ghost();
  /// What the colours of the field mean: a scale, or words.
  void explain_field();
  /// Corners are shaded: where nothing moves, and nothing is seen through.
  bool occludes() const { return settings.fine && opacity() == 1; }
  /// Just before VTK draws: what depends on the camera and on the window's size.
  void prepare_drawing();

  void look_from(double azimuth, double elevation);
  void fit_to(double width, double height);
  /// Of the window, pixels: kept free for the rock.
  PixelRect area_for_rock(double width, double height) const;
  /// Pixels of the window the renderer is in; 1280×720 before it is in one.
  std::array<double, 2> size() const;
  double text_height() const;
  ValueRange colour_range() const;
  std::vector<bool> flags(const std::vector<int>& chosen) const;
  std::vector<const BlockActors*> parts() const { return {&fixed, &movable}; }
  CameraPose pose() const;
  void set_pose(const CameraPose& pose);

  const BlockSystem& system;
  SceneSettings settings;
  Vec3 origin;           ///< m, the blocks' middle: everything is drawn relative to it
  double rock_size = 1;  ///< m, diagonal of the undeformed blocks
  std::vector<Rgb> block_colours;
  BlockActors fixed, movable;
  Highlight concern, selection, hover, face;
  JointActors joints;
  ContactActor contacts;
  Backdrop backdrop;
  SectionActor section;
  vtkNew<vtkPlane> section_plane;
  bool section_is_stale = false;
  FieldValues fields;
  WallActor walls;
  bool walls_are_stale = false;
  std::vector<int> hidden, selected;
  std::optional<int> hovered;
  std::optional<Pick> marked_face;
  std::vector<ConvergenceTrouble> troubles;
  std::vector<ActionGlyph> actions;
  /// The vertex that each glyph goes with; none where it has no block.
  struct Anchor {
    const BlockActors* part = nullptr;
    int vertex = 0;
  };
  std::vector<Anchor> action_anchors;
  SolidShapes action_shapes;
  std::shared_ptr<const BlockTrails> trails;
  WayActor ways, ghost_edges;
  Ghost ghost;
  std::optional<BlockSurface> ghost_surface;  ///< of its movable blocks
  std::vector<TurningAxis> axes_of_frame;
  std::optional<PixelRect> rock_part;  ///< as Scene::set_rock_area
  std::vector<PixelRect> covered;      ///< pixels of the window that labels keep out of, and rock that is fitted

  std::shared_ptr<const Frame> frame;
  std::vector<Vec3> contact_dots;    ///< where the frame's contact points are drawn, m; none where they are not
  std::vector<double> field_values;  ///< of the frame, SI
  std::function<Rgb(double value)> of_field;  ///< their colours; none where no field is shown
  std::vector<std::string> stage_names;
  ViewExtent extent;
  bool fits_itself = true;  ///< no pose was set since the last look or fit
  bool fit_is_stale = false;
  PixelRect fitted_area{};  ///< pixels that were free for the rock when it was fitted: a legend may come later
  double pixel_scale = 1;   ///< supersampling: pixels drawn for each pixel of the picture

  Overlay overlay;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLookupTable> table;
};

}  // namespace talus
