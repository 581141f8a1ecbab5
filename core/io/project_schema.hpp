#pragma once

namespace talus {

/// The schema of project files, a JSON text: what can be said, with titles, units and defaults.
const char* project_schema_text();

/// The schema of view files, another JSON text.
const char* view_schema_text();

}  // namespace talus
