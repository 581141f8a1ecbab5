#include "io/project_schema.hpp"

extern const char project_schema[];
extern const char view_schema[];

namespace talus {

const char* project_schema_text() { return project_schema; }

const char* view_schema_text() { return view_schema; }

}  // namespace talus
