#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "io/project_file.hpp"
#include "model/number_text.hpp"
#include "templates/templates.hpp"
#include "text/json_text.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

using NewJson = nlohmann::ordered_json;

/// What was asked of one template.
struct NewProject {
  const ProjectTemplate* chosen = nullptr;
  TemplateValues values;
  std::filesystem::path file;
  bool replace = false;
};

std::string option_of(const TemplateNumber& number) {
  std::string words = "--" + number.key;
  std::replace(words.begin(), words.end(), '_', '-');
  return words;
}

NewJson json_of(const TemplateNumber& number) {
  return {{"option", option_of(number)}, {"name", number.name}, {"meaning", number.meaning}, {"unit", number.unit},
          {"least", number.least},       {"most", number.most}, {"preset", number.preset}};
}

ExitCode list_templates(bool json) {
  NewJson list = NewJson::array();
  for (const ProjectTemplate& candidate : project_templates()) {
    NewJson numbers = NewJson::array();
    Table table({"", "", "range", "default"}, "llll");
    for (const TemplateNumber& number : candidate.numbers) {
      numbers.push_back(json_of(number));
      table.add({"  " + option_of(number), number.name + ", " + number.meaning, range_text(number),
                 number_text(number.preset)});
    }
    list.push_back({{"template", candidate.key},
                    {"name", candidate.name},
                    {"description", candidate.description},
                    {"numbers", numbers}});
    if (!json) std::cout << candidate.key << ": " << candidate.description << '\n' << table.text() << '\n';
  }
  if (json) std::cout << json_text({{"templates", list}}) << '\n';
  return done;
}

/// `slope` becomes slope.talus.
std::filesystem::path with_ending(std::filesystem::path file) {
  if (!file.has_extension()) file += ".talus";
  return file;
}

ExitCode write_new(const NewProject& wanted, bool json) {
  const Project project = project_from(*wanted.chosen, wanted.values);
  const auto file = with_ending(wanted.file);
  std::error_code unknown;
  if (!wanted.replace && std::filesystem::exists(file, unknown))
    throw InputError(file.string(), "is there already", "choose another name, or replace it with --force");
  about(file, [&] { return save_project(project, file), 0; });
  if (json)
    std::cout << json_text({{"template", wanted.chosen->key}, {"file", file.string()}, {"numbers", wanted.values}})
              << '\n';
  else
    std::cout << "wrote " << file.string() << '\n';
  return done;
}

void add_template(CLI::App& command, const ProjectTemplate& chosen, Invocation& invocation) {
  auto* one = command.add_subcommand(chosen.key, chosen.description);
  one->fallthrough();  // --json may follow the file
  auto wanted = std::make_shared<NewProject>();
  wanted->chosen = &chosen;
  for (const TemplateNumber& number : chosen.numbers) {
    one->add_option_function<double>(
           option_of(number), [wanted, key = number.key](double value) { wanted->values[key] = value; },
           number.name + ", " + number.meaning + ": " + range_text(number) + " [" + number_text(number.preset) + "]")
        ->type_name(number.unit.empty() ? "COUNT" : number.unit);
  }
  one->add_option("FILE", wanted->file, "Project file to write (.talus)")->required()->type_name("PATH");
  one->add_flag("--force", wanted->replace, "Replace a file that is there");
  one->callback([&invocation, wanted] {
    invocation.run = [&invocation, wanted] { return write_new(*wanted, invocation.json); };
  });
}

}  // namespace

void add_new(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("new", "Begin a project from a template and a few numbers");
  auto list = std::make_shared<bool>(false);
  command->add_flag("--list", *list, "List the templates with their numbers, units and ranges");
  for (const ProjectTemplate& candidate : project_templates()) add_template(*command, candidate, invocation);
  command->require_subcommand(0, 1);
  command->callback([&invocation, list, command] {
    if (*list)
      invocation.run = [&invocation] { return list_templates(invocation.json); };
    else if (command->get_subcommands().empty())
      throw CLI::RequiredError("the name of a template, or --list");
  });
}

}  // namespace talus::cli
