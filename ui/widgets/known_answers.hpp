#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QProgressBar>
#include <filesystem>
#include <map>

#include "run/verify_job.hpp"
#include "widgets/parts.hpp"
#include "widgets/plain_table.hpp"

namespace talus {

class CasePage;

/// Help → Known answers: what the solver is held to, case by case, run here and now. Not modal: the window stays
/// usable, and closing the dialog lets the cases run on.
class KnownAnswers : public QDialog {
  Q_OBJECT
 public:
  explicit KnownAnswers(std::vector<KnownCase> cases, QWidget* parent = nullptr);

  VerifyJob& job() { return job_; }
  /// Results of this session, in the list's order.
  std::vector<CaseResult> results() const;
  /// Writes them as JSON; false when the file cannot be written.
  bool exportJson(const std::filesystem::path& file) const;

 private:
  QWidget* makeList();
  QWidget* makeFoot();
  void runQuick();
  void runSelected();
  void run(std::vector<std::size_t> indices);
  void take(const CaseResult& result);
  void showRow(std::size_t index);
  void showCurrent();
  void showProgress(double fraction, const QString& what);
  void refresh();
  void askForExport();

  std::vector<KnownCase> cases_;
  std::map<std::string, CaseResult> results_;  ///< by name
  std::vector<std::size_t> waiting_;           ///< of the run that goes on; the first is being computed
  VerifyJob job_;
  PlainTable* list_;
  CasePage* page_;
  QCheckBox* repeat_;
  QProgressBar* bar_;
  ElidedLabel* what_;
  QLabel* left_;
  QPushButton *cancel_, *export_, *runSelected_, *runQuick_;
};

}  // namespace talus
