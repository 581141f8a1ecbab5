#pragma once

#include <string>

#include "report/document.hpp"

namespace talus::report {

/// The document as one page of HTML5, well-formed as XML is, that needs no other file: pictures are inside it as PNG,
/// charts as SVG. It prints on A4.
std::string html_of(const Document& document);

}  // namespace talus::report
