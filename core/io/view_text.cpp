#include "io/view_text.hpp"

#include "io/json_format.hpp"
#include "io/json_text.hpp"
#include "io/schema_check.hpp"

namespace talus {

std::string checked_view_text(const std::string& text) {
  const JsonText parsed = parse_json_text(text);
  check_view_against_schema(parsed);
  return parsed.value.dump();
}

std::string laid_out(const std::string& json) { return format_json(OrderedJson::parse(json), 0, {}, true) + '\n'; }

}  // namespace talus
