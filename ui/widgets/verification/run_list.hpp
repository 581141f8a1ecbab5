#pragma once

#include <QWidget>
#include <filesystem>
#include <optional>
#include <vector>

#include "jobs/background_job.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"

class QCheckBox;
class QProgressBar;

namespace talus {

/// One line of a list of runs, as it is before the run.
struct RunItem {
  QString title, tip;
  QString group;      ///< to choose by; empty where the list has no groups
  QStringList facts;  ///< what is known of it before, in columns of their own
  QString caution;    ///< why it is known not to pass; empty: it should
  bool takesLong = false;
};

/// What a run came to, as its line shows it.
struct RunVerdict {
  bool passed = false;
  QString words, icon;  ///< "passed", "known shortfall"
  theme::Tone tone = theme::Tone::ok;
  QStringList figures;  ///< in columns of their own
  double seconds = 0;   ///< wall time
};

/// What differs between lists.
struct RunListWords {
  QString list, what;            ///< "Cases with a known answer"; heading of the first column: "Case"
  QStringList facts, figures;    ///< headings of the columns between result and time
  QString goesOn, none, passed;  ///< "Cases are being run", "No case has been run yet", "%1 of %2 passed"
  QString repeat, repeatTip;
  QString file;  ///< to export into: "known_answers.json"
};

/// A list of runs that are held to something, run here and now: a table, a page on the run that is chosen, and below
/// them progress and what can be done. What is run, and what the page says of it, is the derived list's business.
class RunList : public QWidget {
  Q_OBJECT
 public:
  BackgroundJob& job() { return job_; }
  /// Writes what the runs of this session came to as JSON; false when the file cannot be written.
  bool exportJson(const std::filesystem::path& file) const;

 protected:
  /// The page stands beside the table, or below a wide one.
  RunList(RunListWords words, std::vector<RunItem> items, QWidget* page, Qt::Orientation orientation);
  /// Fills the lines; to be called at the end of the derived list's constructor.
  void begin();
  /// The first of the runs that go on has ended: its result is kept. To be called for each.
  void takeEnded();

  /// Starts `job()` with these.
  virtual void start(const std::vector<std::size_t>& indices, bool repeat) = 0;
  /// Empty where it has not been run.
  virtual std::optional<RunVerdict> verdict(std::size_t index) const = 0;
  virtual void showPage(std::size_t index) = 0;
  virtual std::string json() const = 0;

 private:
  QWidget* makeTable();
  QWidget* makeFoot();
  void makeGroups(QBoxLayout& row);
  void runQuick();
  void runSelected();
  void run(std::vector<std::size_t> indices);
  void showGroup();
  void showRow(std::size_t index);
  void showCurrent();
  void showProgress(double fraction, const QString& what);
  void refresh();
  void askForExport();

  RunListWords words_;
  std::vector<RunItem> items_;
  std::vector<std::size_t> waiting_;  ///< of the runs that go on; the first is being computed
  BackgroundJob job_;
  PlainTable* table_;
  QComboBox* groups_;
  QCheckBox* repeat_;
  QProgressBar* bar_;
  ElidedLabel* what_;
  QLabel* left_;
  QPushButton *cancel_, *export_, *runSelected_, *runQuick_;
};

}  // namespace talus
