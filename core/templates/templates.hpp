#pragma once

#include "templates/template.hpp"

namespace talus {

/// All that a project can be begun from, in the order in which they are offered.
const std::vector<ProjectTemplate>& project_templates();

/// Throws InputError for a key that there is not.
const ProjectTemplate& template_named(const std::string& key);

/// "1 to 50 m".
std::string range_text(const TemplateNumber& number);

/// Throws InputError, with the number's name as place, for a value outside its range or a count that is not whole.
void check_number(const TemplateNumber& number, double value);

/// The project of a template; a number that is not given has its preset value. Throws InputError for a number out of
/// its range, and for a key that the template does not ask for.
Project project_from(const ProjectTemplate& chosen, const TemplateValues& given = {});

}  // namespace talus
