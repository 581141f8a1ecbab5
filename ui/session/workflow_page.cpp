#include "session/workflow_page.hpp"

#include <map>

namespace talus {

WorkflowPage pageOf(const QString& place) {
  static const std::map<QString, WorkflowPage> pages{
      {QStringLiteral("solids"), WorkflowPage::geometry}, {QStringLiteral("joints"), WorkflowPage::joints},
      {QStringLiteral("cuts"), WorkflowPage::joints},     {QStringLiteral("default_joint"), WorkflowPage::joints},
      {QStringLiteral("blocks"), WorkflowPage::blocks},   {QStringLiteral("interfaces"), WorkflowPage::blocks},
      {QStringLiteral("merges"), WorkflowPage::blocks},   {QStringLiteral("splinters"), WorkflowPage::blocks},
      {QStringLiteral("mesh"), WorkflowPage::mesh},       {QStringLiteral("materials"), WorkflowPage::materials},
      {QStringLiteral("stages"), WorkflowPage::stages},   {QStringLiteral("monitors"), WorkflowPage::stages},
      {QStringLiteral("expect"), WorkflowPage::stages},   {QStringLiteral("solver"), WorkflowPage::stages},
      {QStringLiteral("output"), WorkflowPage::stages}};
  const auto found = pages.find(place.section(u'/', 1, 1));
  return found == pages.end() ? WorkflowPage::loads : found->second;
}

}  // namespace talus
