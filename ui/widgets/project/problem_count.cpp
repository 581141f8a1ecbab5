#include "widgets/project/problem_count.hpp"

#include <algorithm>

#include "session/current_project.hpp"
#include "session/messages.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

ProblemCount::ProblemCount(CurrentProject& project, Messages& messages) : project_(project), messages_(messages) {
  setObjectName(QStringLiteral("problem-count"));
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setIconSize({12, 12});
  setToolTip(tr("What is wrong with the project, what is odd, what may be on purpose; a click lists it"));
  connect(&project_.problems(), &ProjectProblems::changed, this, &ProblemCount::refresh);
  connect(&messages_, &Messages::problemsChanged, this, &ProblemCount::refresh);
  connect(&project_, &CurrentProject::opened, this, &ProblemCount::refresh);
  refresh();
}

void ProblemCount::refresh() {
  using Severity = Problem::Severity;
  const auto count = [this](Severity severity) {
    const auto& events = messages_.problems();
    return project_.problems().count(severity) +
           static_cast<int>(std::count_if(events.begin(), events.end(),
                                          [severity](const Problem& one) { return one.severity == severity; }));
  };
  const int errors = count(Severity::error), warnings = count(Severity::warning), hints = count(Severity::info);
  QStringList words;
  if (errors > 0) words << numbers::counted(errors, "error");
  if (warnings > 0) words << numbers::counted(warnings, "warning");
  if (hints > 0) words << numbers::counted(hints, "hint");
  setText(words.isEmpty() ? tr("No problems") : words.join(QStringLiteral(", ")));
  setAccessibleName(tr("Problems: %1").arg(text()));
  const bool sound = errors + warnings == 0;
  setIcon(theme::icon(sound        ? QStringLiteral("check")
                      : errors > 0 ? QStringLiteral("error")
                                   : QStringLiteral("warning"),
                      sound        ? theme::Tone::ok
                      : errors > 0 ? theme::Tone::error
                                   : theme::Tone::warn));
  setVisible(project_.document().isOpen() || !words.isEmpty());
}

}  // namespace talus
