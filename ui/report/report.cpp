#include "report/report.hpp"

#include <utility>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "report/html.hpp"
#include "report/pdf.hpp"
#include "report/sections.hpp"

namespace talus::report {

namespace {

/// "2026-03-01T17:04:00Z" as "2026-03-01 17:04 UTC".
std::string moment_text(const std::string& iso) {
  if (iso.size() != 20) return iso;
  return iso.substr(0, 10) + " " + iso.substr(11, 5) + " UTC";
}

std::string origin_text(const RunRecord& run) {
  if (!run.report) return "Not finished";
  if (run.report->version.empty()) return "Solved by an earlier version of Talus";
  return "Solved by Talus " + run.report->version + ", finished " + moment_text(run.report->finished);
}

/// A project that is gone or no longer understood leaves sections out, and no report.
ProjectOfRun project_of_run(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "project.talus";
  try {
    return {read_project(file, {.allow_outside = true}), ""};  // no file that it names is opened
  } catch (const InputError& error) {
    return {std::nullopt, file.string() + ": " + error.what()};
  }
}

}  // namespace

Document report_of(const std::filesystem::path& folder) {
  const RunRecord run(folder, project_of_run(folder));
  const std::string name = run.results.project_name();
  Document document{name.empty() ? folder.stem().string() : name, {}, {}};
  document.below_title = {
      origin_text(run) + ". Results: " + std::filesystem::weakly_canonical(folder).filename().string(),
      "Three-dimensional discontinuous deformation analysis. SI units; x east, y north, z up; stress positive in "
      "tension."};
  for (const auto section : {answer, pictures, model, motion, slide, events, contacts, energy, settings, effects,
                             accuracy_and_cost, hard_places})
    if (Section one = section(run); !one.parts.empty()) document.sections.push_back(std::move(one));
  return document;
}

Writer writer_for(const std::filesystem::path& file) {
  if (file.extension() == ".html") return html_of;
  if (file.extension() == ".pdf") return pdf_of;
  throw InputError(file.string(), "reports are written as HTML or PDF", "let the name end in .html or .pdf");
}

}  // namespace talus::report
