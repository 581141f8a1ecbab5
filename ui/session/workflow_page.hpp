#pragma once

#include <QString>
#include <array>

namespace talus {

/// The pages of the workflow, in its order; Ctrl+1…9 goes to each.
enum class WorkflowPage { geometry, joints, blocks, mesh, materials, loads, stages, solve, results };

inline constexpr std::array all_pages{WorkflowPage::geometry, WorkflowPage::joints,    WorkflowPage::blocks,
                                      WorkflowPage::mesh,     WorkflowPage::materials, WorkflowPage::loads,
                                      WorkflowPage::stages,   WorkflowPage::solve,     WorkflowPage::results};

/// Pages that set the project up, before anything is solved.
constexpr bool isSetUp(WorkflowPage page) { return page < WorkflowPage::solve; }

/// The word that the command line and tests use, which is the icon's name too.
constexpr const char* pageKey(WorkflowPage page) {
  constexpr std::array keys{"geometry", "joints", "blocks", "mesh", "materials", "loads", "stages", "solve", "results"};
  return keys[static_cast<size_t>(page)];
}

inline QString pageTitle(WorkflowPage page) {
  QString title = QString::fromLatin1(pageKey(page));
  title[0] = title[0].toUpper();
  return title;
}

}  // namespace talus
