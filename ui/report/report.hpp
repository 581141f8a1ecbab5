#pragma once

#include <filesystem>
#include <string>

#include "report/document.hpp"
#include "report/run_record.hpp"

namespace talus::report {

/// All that a reader needs to believe the run of a results folder, the answer first. Throws InputError where the folder
/// holds no results, or no frame yet; std::runtime_error where no off-screen OpenGL is to be had.
Document report_of(const std::filesystem::path& folder);

/// What makes a file of a document: HTML or PDF, as the file's ending says. Throws InputError for another ending.
using Writer = std::string (*)(const Document&);
Writer writer_for(const std::filesystem::path& file);

}  // namespace talus::report
