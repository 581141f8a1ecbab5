#pragma once

#include <QCoreApplication>
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

/// The page on which a place of the project file is changed.
WorkflowPage pageOf(const QString& place);

inline QString pageTitle(WorkflowPage page) {
  constexpr std::array titles{QT_TRANSLATE_NOOP("pages", "Geometry"),  QT_TRANSLATE_NOOP("pages", "Joints"),
                              QT_TRANSLATE_NOOP("pages", "Blocks"),    QT_TRANSLATE_NOOP("pages", "Mesh"),
                              QT_TRANSLATE_NOOP("pages", "Materials"), QT_TRANSLATE_NOOP("pages", "Loads"),
                              QT_TRANSLATE_NOOP("pages", "Stages"),    QT_TRANSLATE_NOOP("pages", "Solve"),
                              QT_TRANSLATE_NOOP("pages", "Results")};
  return QCoreApplication::translate("pages", titles[static_cast<size_t>(page)]);
}

}  // namespace talus
