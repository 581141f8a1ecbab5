#pragma once

#include <Eigen/Geometry>
#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "document/selection.hpp"
#include "jobs/latest_job.hpp"
#include "render/scene/scene.hpp"
#include "render/views/view_file.hpp"
#include "widgets/view/camera_moves.hpp"

class QLabel;
class QPushButton;
class QRubberBand;

namespace talus {

class Display;
class Lasso;
class PlacePicker;
class Playback;
class RenderSurface;
class ViewOverlay;
class ViewTool;
struct JointedRock;
struct PickedPlace;
class Selection;
enum class WorkflowPage;
struct Session;

/// The 3-D view: draws the session's blocks and frame, or its solids as long as they are not cut, moves the camera,
/// picks blocks and solids into the shared selection. Left drag turns, middle drag pans, the wheel zooms to the
/// pointer. Shift and left drag select by a box: to the right what lies wholly in it, to the left all that it touches;
/// Alt and left drag draw a lasso around them. With Ctrl as well they are added.
class Viewport : public QWidget {
  Q_OBJECT
 public:
  explicit Viewport(Session& session, QWidget* parent = nullptr);
  ~Viewport() override;

  void look(View view);
  void fit();
  void toggleProjection();
  void hideSelected();
  void isolateSelected();
  void showAll();
  /// Blocks are drawn apart, or again where they are.
  void toggleExplosion();
  /// Cuts what is selected, or all, open in its middle, upright and across the view; or closes it again.
  void toggleSection();
  /// Shift and drag draw a lasso from now on, where they draw a box otherwise.
  void setLasso(bool lasso) { drawsLasso_ = lasso; }

  /// Blocks of other results over its own; without a system none.
  void setGhost(const Ghost& ghost);
  const Ghost& ghost() const { return ghost_; }
  /// Draws once what is to be drawn quickly later; for a window that a user has before him, soon after it is shown.
  void warmUp();
  /// Empty until there are blocks.
  std::optional<CameraPose> pose() const;
  /// As Scene::rock_area; empty until there are blocks.
  std::optional<PixelRect> rockArea() const;
  /// As if the user had moved the camera there.
  void moveTo(const CameraPose& pose);
  /// What the user chose, as this screen wants it on this page.
  SceneSettings screenSettings() const;
  /// The camera is on its way to a place that was asked for.
  bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }
  const std::vector<int>& hiddenBlocks() const { return hidden_; }
  /// What is drawn: the project's blocks, or its solids; null where there is nothing.
  const std::shared_ptr<const BlockSystem>& shown() const { return system_; }
  bool showsSolids() const { return showsSolids_; }
  /// Blocks are coloured by a field where there are results, on the pages that tell of a run.
  bool showsField() const;
  /// Loads, supports, velocities, stress in situ and monitors that are shown on this page.
  const std::vector<ActionGlyph>& actions() const { return actions_; }
  /// The one of them that is drawn at a point of the view.
  std::optional<ActionGlyph> actionAt(QPointF point) const;
  /// What lies under a point of the view, logical pixels from its upper left corner.
  std::optional<Pick> pickAt(QPointF point) const;
  /// The place of a pick on the rock at rest.
  PickedPlace placeOf(const Pick& pick) const;
  /// Where a point [m], or a place in the frame that is shown, lies in the view; empty behind the viewer.
  std::optional<QPointF> pointOf(const Vec3& point) const;
  std::optional<QPointF> pointOf(const PickedPlace& place) const;
  std::optional<SightLine> sightAt(QPointF point) const;
  /// m on the screen's plane at a place, of a logical pixel.
  double metresPerPixel(const Vec3& place) const;
  /// Around what is drawn, at rest; empty where nothing is.
  std::optional<Eigen::AlignedBox3d> extent() const;
  /// Joints are drawn in the rock: on their page, unless they are switched off.
  bool showsJoints() const;
  /// The cut whose plane lies under a point of the view.
  std::optional<int> jointAt(QPointF point) const;
  /// Marks the flat face of a pick.
  void markFace(const std::optional<Pick>& pick);
  void usePointer(Qt::CursorShape shape);
  /// What is worked with in the view; the last one that was added is asked first.
  ViewOverlay& overlay() { return *overlay_; }
  const RenderSurface& surface() const { return *surface_; }
  /// What the view shows, without its tools.
  QPixmap picture();
  /// The same as it is in a theme.
  QPixmap picture(Theme theme);
  /// All that the picture of results depends on; empty where none are shown.
  std::optional<SavedView> savedView() const;
  /// Shows results as a saved view did, in the size that the view has now. Throws InputError where it is of other
  /// blocks.
  void show(const SavedView& view);
  /// The toolbar over the view's right edge; the window adds to it.
  QWidget* tools() { return tools_; }
  /// Strips and tools that lie over the view get their places again.
  void placeOverlays();
  void keepLabelsBesideTools();
  /// Pixels from the lower left corner.
  std::vector<PixelRect> coveredByTools() const;
  QString surveyedPlace(const Pick& pick) const;

 signals:
  void redrawn();  ///< or about to be: the camera, the frame or the settings may be others
  /// Of what is selected, at a point of the screen.
  void menuWanted(const QPoint& at);
  /// The project has none yet.
  void rockWanted();
  /// Where the point of rock under the mouse lies in the coordinates of the survey, in words; empty beside the rock.
  void pointedAt(const QString& place);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::shared_ptr<const BlockSystem> wantedSystem() const;
  void followSystem();
  /// A system and what is drawn of it; null: nothing.
  struct Drawn {
    std::shared_ptr<const BlockSystem> system;  ///< the scene keeps a reference
    std::shared_ptr<Scene> scene;
    std::vector<int> hidden;  ///< blocks, while it is not in view
  };
  static Drawn drawn(const std::shared_ptr<const BlockSystem>& system, const SceneSettings& settings,
                     const std::vector<JointedRock>& solids);
  void showScene(const Drawn& next);
  bool mayStand(const Drawn& next) const;
  void keepScenes(const std::function<bool(const Drawn&)>& isKept);
  static bool isMadeAtOnce(const BlockSystem& system);
  /// What is drawn is not what is there any more: its successor is being made ready.
  bool isStale() const { return wanted_ != system_; }
  void showFrame();
  void takeDisplay();
  void applySettings();
  void applySelection();
  void applyJoints();
  void applyTroubles();
  void applyTrails();
  void applyActions();
  /// Selects the load, support or monitor whose glyph is there; false where there is none.
  bool selectActionAt(QPointF point);
  void flyTo(const CameraPose& pose);
  // What the mouse and the glyphs need of the session.
  const Project& project() const;
  WorkflowPage page() const;
  Selection& selection() const;
  bool isRunning() const;
  bool isComputing() const;
  const SceneSettings& displayed() const;
  Display& display() const;
  Playback& playback() const;
  void moveCamera(const CameraPose& pose);
  void render();
  void drawNow();
  void tellOfFit();
  void drawRoughlyFirst();
  void becomeStill();
  void showEmptyState();
  bool hasRock() const;

  bool mousePressed(const QMouseEvent& event);
  bool mouseMoved(const QMouseEvent& event);
  bool mouseReleased(const QMouseEvent& event);
  bool toolTakes(const QMouseEvent& event);
  bool toolClicked(const QMouseEvent& event);
  bool keyPressed(QEvent* event);
  void menuAsked(const QMouseEvent& event);
  bool wheelTurned(const QWheelEvent& event);
  void pickForHover();
  void selectIn(const QPolygonF& outline, bool touched, bool added);
  void selectAt(QPointF point, Qt::KeyboardModifiers modifiers);
  /// Of what is drawn: the blocks that are selected, or those of the solids that are.
  std::vector<int> selectedInView() const;
  std::optional<int> hoveredInView() const;
  Item itemOf(int block) const;
  /// The frame in which the blocks are drawn; null where they are drawn at rest.
  std::shared_ptr<const Frame> shownFrame() const;
  bool tellsOfRun() const;
  QString wordsOfPick(const Pick& pick) const;
  void showCard(const Pick& pick, QPointF point);

  Session& session_;
  RenderSurface* surface_;
  std::vector<Drawn> made_;                    ///< what can be shown without a wait
  std::shared_ptr<const BlockSystem> system_;  ///< what scene_ draws
  bool showsSolids_ = false;                   ///< that is solids which are not cut yet
  std::shared_ptr<Scene> scene_;
  std::shared_ptr<const BlockSystem> wanted_;  ///< what is to be drawn
  /// Of the camera: where it is, and whether that is where all is fitted into the view.
  struct Standing {
    CameraPose pose;
    bool fits;
  };
  void takeStanding(const Standing& standing);
  std::optional<Standing> standing_;  ///< where the camera stood last, of this project
  std::vector<int> hidden_;
  Ghost ghost_;
  std::vector<ActionGlyph> actions_;  ///< that the scene was told of

  enum class Drag { none, turn, pan, box, lasso, tool };
  Drag dragOf(const QMouseEvent& event) const;
  Drag drag_ = Drag::none;
  QPointF pressed_, last_;
  bool moved_ = false;
  QRubberBand* band_;
  Lasso* lasso_;
  bool drawsLasso_ = false;
  QTimer stillTimer_;  ///< fires when the camera has rested
  QTimer drawTimer_;   ///< spaces drawings out while a run goes on
  QTimer hoverTimer_;
  bool still_ = true;
  QVariantAnimation flight_;
  CameraPose flightStart_, flightEnd_;
  std::optional<CameraPose> told_;    ///< that those beside it follow
  std::optional<Standing> together_;  ///< to go back to when blocks are no longer drawn apart
  QElapsedTimer sinceDrawing_;

  ViewTool* taken_ = nullptr;  ///< whose drag it is
  ViewOverlay* overlay_;
  PlacePicker* picker_;
  QFrame* tools_;
  QFrame* card_;
  QLabel* cardTitle_;
  QLabel* cardText_;
  QWidget* empty_;
  QLabel* emptyText_;
  QPushButton* emptyButton_;
  LatestJob drawing_;  ///< makes scenes; last: its thread ends before the others go
};

}  // namespace talus
