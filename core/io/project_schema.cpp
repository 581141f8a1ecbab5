#include "io/project_schema.hpp"

extern const char project_schema[];

namespace talus {

const char* project_schema_text() { return project_schema; }

}  // namespace talus
