#pragma once

#include <QDialog>
#include <filesystem>
#include <optional>

#include "model/project.hpp"
#include "orientation/joint_table.hpp"

class QComboBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace talus {

class Document;
class PlainTable;
class SolidSurfaces;

/// Joints from the clipboard or a file into the project: the text, what was read from it line by line with what is
/// wrong, and one undoable step that adds the sound lines as cuts with their joint sets. Of a drawing (DXF) the faces
/// are read in place of text.
class PasteJoints : public QDialog {
  Q_OBJECT
 public:
  PasteJoints(Document& document, const SolidSurfaces& solids, QWidget* parent = nullptr);
  /// Begins with what is in the clipboard.
  void present();
  void setText(const QString& text);
  /// Begins with a table, or a drawing where the name ends in .dxf.
  void presentFile(const std::filesystem::path& file);
  const JointTable& table() const { return table_; }

 private:
  QWidget* makeText();
  QWidget* makePreview();
  QWidget* makeFoot();
  void openFile();
  void prepare();
  void bring();
  void load(const std::filesystem::path& file);
  void read();
  void take(JointTable table);
  void showTable();
  void showNotes();
  void listStrengths();
  void showPlace();
  void add();
  /// Of the rock, where joints with a spacing go all through it.
  std::optional<BoxShape> repeatedIn() const;

  Document& document_;
  const SolidSurfaces& solids_;
  JointTable table_;
  Vec3 through_ = Vec3::Zero();  ///< m, for joints without a place
  std::optional<BoxShape> rock_;
  QPlainTextEdit* text_;
  PlainTable* preview_;
  QLabel *notes_, *refusal_;
  QComboBox* strength_;
  QComboBox* spaced_;  ///< what a joint with a spacing becomes
  QWidget *placeRow_, *spacedRow_;
  QPushButton* add_;
};

}  // namespace talus
