#pragma once

#include <QMainWindow>
#include <optional>

#include "document/autosave.hpp"
#include "session/session.hpp"
#include "widgets/results/export_job.hpp"

class QDockWidget;
class QLabel;
class QStackedWidget;

namespace talus {

class AccuracyPanel;
class ExportStrip;
class FilmDialog;
class Guards;
class PasteJoints;
class ManualWindow;
class ProjectTree;
class Rail;
class StartPage;
class StereonetPanel;
class WorkflowBar;
class Timeline;
class TopBar;
class Verification;
class Viewport;
class WindowActions;

/// The window: bars above, rail at the left edge, tree, view, properties or run or display, tables and plots below.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(SolverParts parts = solverParts());
  ~MainWindow() override;

  Session& session() { return session_; }
  Viewport& viewport() { return *viewport_; }
  Timeline& timeline() { return *timeline_; }
  ExportJob& exporter() { return exporter_; }

  /// Asks what a new project is to be; `key`: the template that is chosen first.
  void newProject(const std::string& key = {});
  /// Shows it in the size that is asked for, else as it was when it was last closed, never larger than the screen.
  void present(std::optional<QSize> size);
  void open(const std::filesystem::path& path);
  /// A sample, as a project that has no file of its own yet.
  void openCopy(const std::filesystem::path& sample);
  /// What a file or folder is, it becomes: the project, its results, geometry that is asked about.
  void takeDropped(const std::filesystem::path& path);
  /// Asks what is to become of work that other windows left unsaved when they ended without closing.
  void offerRecovery();
  /// In the view's shape, so many pixels wide.
  void savePicture(const std::filesystem::path& path, int width = 1920);
  /// The height is that of the view's shape, the speed that of play.
  void saveFilm(const std::filesystem::path& path, const FilmOptions& film = {});
  /// Of the results that are open: as HTML or PDF, by the file's ending; of STL the frame in view.
  void saveReport(const std::filesystem::path& path);
  void exportData(DataFormat format, const std::filesystem::path& path);
  /// How results are shown, as a view file by which talus-cli draws the same; what goes wrong is said as a problem.
  void saveView(const std::filesystem::path& path);
  void openView(const std::filesystem::path& path);
  /// Shows other results beside those that are open.
  void compareWith(const std::filesystem::path& folder);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeBars();
  void makeCentre();
  void makeDocks();
  void makeStatusBar();
  void makeViewTools();
  void connectActions();
  QDockWidget* makeDock(const QString& name);
  void addDock(Qt::DockWidgetArea area, QDockWidget* dock, QWidget* content);
  void showStart(bool start);
  void showPage();
  void focusField(QString place);
  void showViewAlone(bool alone);
  void showRecent();
  void askForProject();
  void askForResults();
  void askForComparison();
  bool saveAs();
  void solve();
  bool begin(const Draft& draft, const QString& what);
  void beginBeside(const std::filesystem::path& file);
  void showMenu(const QPoint& at);
  void keepPictureOfProject();
  void askForPicture();
  void askForFilm();
  void askForFilmFile();
  void askForReport();
  void askForView(bool save);
  void askForExport(DataFormat format);
  void write(const QString& what, const std::filesystem::path& path, Writing writing);
  /// Null, and a problem is said, where the samples cannot be read.
  Verification* verification();
  void showAccuracy();
  void showStereonet();
  void askForJoints();
  void takeJoints(const std::filesystem::path& file);
  PasteJoints& pasteJoints();
  /// At the page that tells of what is selected, or of the page of the workflow.
  void showManual();
  void showAbout();
  ExportTask exportTask(const std::filesystem::path& path, int width);
  static int heightFor(int width, const QWidget& view);
  QString folderForDialogs() const;
  /// What a dialog for saving begins with: beside the project under its name, or under its title where it has no file.
  QString proposedFile(const QString& ending) const;
  void updateTitle();
  bool mayCloseDuringRun();

  Session session_;
  Autosave autosave_;
  ExportJob exporter_;
  Guards* guards_;
  WindowActions* actions_;
  TopBar* topBar_;
  WorkflowBar* workflowBar_;
  Rail* rail_;
  QStackedWidget* centre_;
  StartPage* start_;
  Viewport* viewport_;
  QWidget* views_;  ///< of it and of those beside it
  Timeline* timeline_;
  ProjectTree* tree_;
  QDockWidget *left_, *right_, *bottom_;
  QStackedWidget* rightPages_;
  Verification* verification_ = nullptr;  ///< once it has been asked for
  ManualWindow* manual_ = nullptr;        ///< once it has been asked for
  AccuracyPanel* accuracy_ = nullptr;     ///< once it has been asked for
  StereonetPanel* stereonet_ = nullptr;   ///< likewise
  FilmDialog* film_ = nullptr;            ///< likewise
  PasteJoints* pasteJoints_ = nullptr;    ///< likewise
  QList<QToolBar*> bars_;
  QLabel *message_, *place_;
  bool docksSized_ = false;
  bool closing_ = false;  ///< waits for the run to stop, or to go on without it
};

}  // namespace talus
