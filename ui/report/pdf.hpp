#pragma once

#include <string>

#include "report/document.hpp"

namespace talus::report {

/// The document as the bytes of a PDF of A4 pages: its letters can be searched, its charts are lines.
std::string pdf_of(const Document& document);

}  // namespace talus::report
