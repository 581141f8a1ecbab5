#pragma once

#include <QObject>
#include <map>
#include <string_view>

#include "render/scene/scene.hpp"
#include "session/run_range.hpp"
#include "session/workflow_page.hpp"

namespace talus {

class CurrentProject;
class Playback;

/// What the window shows now, and how: the page of the workflow, the scene's settings, the theme.
class Display : public QObject {
  Q_OBJECT
 public:
  /// Made before all who draw frames: the range of the legend then is ready when they are told of a frame.
  Display(CurrentProject& project, Playback& playback);

  WorkflowPage page() const { return page_; }
  void goTo(WorkflowPage page);

  const SceneSettings& settings() const { return settings_; }
  void set(const SceneSettings& settings);
  /// Shows results as a view did: its field, range, shape and overlays, in its theme.
  void show(const SceneSettings& saved);
  /// Whether the legend spans all frames of the run, as far as it has come, or the one in view alone.
  bool rangeFollowsRun() const { return rangeFollowsRun_; }
  void setRangeFollowsRun(bool follows);
  /// All frames of results on disk have been looked at for it.
  bool knowsRangeOfRun() const { return whole_.isWhole(); }
  /// What the legend spans of the field that is shown, whichever frames are looked at; empty: of the run or the frame.
  /// Each field keeps its own, as it keeps the values that alone are drawn (SceneSettings::only), whichever are shown
  /// in between.
  std::optional<ValueRange> typedRange() const;
  void setTypedRange(const std::optional<ValueRange>& range);
  /// What the legend spans now, SI.
  ValueRange spannedRange() const;
  bool isDark() const { return settings_.theme == Theme::dark; }
  void setDark(bool dark);

  /// Selects the thing that a place of the project belongs to, on its page, and lets its field take the keyboard.
  void showField(const QString& place);
  /// Selects the blocks of a trouble and lets the view go there.
  void showTrouble(const ConvergenceTrouble& trouble);
  /// Marks these places in the view, and no others.
  void mark(std::vector<MarkedPlace> places);
  /// Lets the view go to a place.
  void showPlace(const MarkedPlace& place) { emit placeWanted(place); }

 signals:
  void pageChanged();
  void changed();  ///< the settings
  void themeChanged();
  void unitsChanged();  ///< in which numbers are shown
  void fieldWanted(const QString& place);
  void placeWanted(const talus::MarkedPlace& place);             ///< the view should go there
  void troubleWanted(const talus::ConvergenceTrouble& trouble);  ///< the view should go there

 private:
  using RangesOfFields = std::map<std::string_view, ValueRange>;  ///< by the field's name

  void takeFrame();
  void forgetRanges();
  std::optional<ValueRange> legendRange() const;
  /// Of the field that is shown.
  std::optional<ValueRange> kept(const RangesOfFields& ranges) const;
  void keep(RangesOfFields& ranges, const std::optional<ValueRange>& range) const;

  CurrentProject& project_;
  Playback& playback_;
  WorkflowPage page_ = WorkflowPage::geometry;
  SceneSettings settings_;
  bool rangeFollowsRun_ = true;
  RangesOfFields typedRanges_, onlyRanges_;
  RunRange whole_;
};

}  // namespace talus
