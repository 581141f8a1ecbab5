#pragma once

#include <QDialog>

#include "render/film/movie.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace talus {

class ComparedResults;
class Messages;
class NumberField;
class PlainTable;
class Section;
class Playback;
class Timeline;
class Viewport;

/// What a film is to be: its size, and how the camera moves. Stays open beside the view, whose camera and moment become
/// the keys of its path.
class FilmDialog : public QDialog {
  Q_OBJECT
 public:
  FilmDialog(Playback& playback, ComparedResults& compared, Viewport& viewport, Timeline& timeline, Messages& messages,
             QWidget* parent);
  /// To the front; the first of the selected blocks is the one that would be followed.
  void present(const std::vector<int>& selected);
  /// As chosen; the height is left to the view's shape. The speed is that of play.
  FilmOptions options() const;

 signals:
  /// It is to be written.
  void filmWanted();

 private:
  QWidget* makeKeys();
  void forgetMoments();
  void addKey();
  void removeKey();
  void readKeys();
  void saveKeys();
  void setKeys(std::vector<CameraKey> keys);
  void fillBlocks();
  void refresh();

  Playback& playback_;
  ComparedResults& compared_;
  Viewport& viewport_;
  Timeline& timeline_;
  Messages& messages_;
  double turn_ = 360;                ///< degrees
  std::optional<double> from_, to_;  ///< s of the model; the first frame, the last
  std::vector<CameraKey> keys_;
  QComboBox *width_, *rate_, *block_, *others_;
  Section* pictures_;
  QCheckBox *turns_, *follows_, *goes_;
  NumberField *degrees_, *begin_, *end_;
  PlainTable* table_;
  QPushButton *add_, *remove_, *read_, *keep_, *save_;
  QLabel* speed_;
};

}  // namespace talus
