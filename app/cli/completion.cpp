#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"

// What shells need to complete command lines, made from the commands themselves: none is forgotten.
namespace talus::cli {

namespace {

using Words = std::vector<std::string>;

Words split_words(const std::string& text, char between) {
  Words words;
  std::istringstream rest(text);
  for (std::string word; std::getline(rest, word, between);) words.push_back(word);
  return words;
}

std::string joined_words(const Words& words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
  return text;
}

struct OptionWords {
  std::string name, help;  ///< "--theme"
  bool has_value;
  Words choices;  ///< "light", "dark"; empty where anything is allowed, or a file
};

/// A command with the way to it, "talus-cli new wedge"; its hidden parts are left out.
struct CommandWords {
  std::string path, name, help;
  std::vector<OptionWords> options;
  Words subcommands;
};

/// Those that a type such as "light|dark" or "draft|standard|X" names; a placeholder has capitals or signs.
Words choices_in(const std::string& type) {
  Words choices = split_words(type, '|');
  if (choices.size() < 2) return {};
  std::erase_if(choices, [](const std::string& word) {
    return !std::ranges::all_of(word, [](char letter) { return letter >= 'a' && letter <= 'z'; });
  });
  return choices;
}

/// One line, without what a shell would take for its own.
std::string plain_help(std::string text) {
  std::erase_if(text, [](char c) { return c == '\'' || c == '[' || c == ']' || c == '\\'; });
  std::ranges::replace(text, '\n', ' ');
  std::ranges::replace(text, ':', ',');
  return text;
}

/// `command` and all below it, each after those above it.
void collect(const CLI::App& command, const std::string& above, std::vector<CommandWords>& all) {
  CommandWords words{above + command.get_name(), command.get_name(), plain_help(command.get_description()), {}, {}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || option->get_group().empty()) continue;
    const bool has_value = option->get_items_expected_max() > 0;
    for (const std::string& name : option->get_lnames())
      words.options.push_back({"--" + name, plain_help(option->get_description()), has_value,
                               has_value ? choices_in(option->get_type_name()) : Words{}});
  }
  std::vector<const CLI::App*> shown;
  for (const CLI::App* below : command.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    words.subcommands.push_back(below->get_name());
    shown.push_back(below);
  }
  all.push_back(words);
  for (const CLI::App* below : shown) collect(*below, words.path + " ", all);
}

/// All paths but the program's own, quoted, as the patterns of one case.
std::string path_patterns(const std::vector<CommandWords>& commands, std::string_view between = "|") {
  Words paths;
  for (const CommandWords& command : commands)
    if (&command != &commands.front()) paths.push_back('"' + command.path + '"');
  return joined_words(paths, between);
}

std::string bash_script(const std::vector<CommandWords>& commands) {
  std::string values, words;
  for (const CommandWords& command : commands) {
    Words names;
    for (const OptionWords& option : command.options) {
      names.push_back(option.name);
      if (!option.has_value) continue;
      values += "    \"" + command.path + ' ' + option.name + "\") ";
      if (!option.choices.empty())
        values += "COMPREPLY=($(compgen -W \"" + joined_words(option.choices, " ") + "\" -- \"$word\")); ";
      values += "return ;;\n";
    }
    words += "    \"" + command.path + "\") subcommands=\"" + joined_words(command.subcommands, " ") + "\" options=\"" +
             joined_words(names, " ") + "\" ;;\n";
  }
  return R"(_talus_cli() {
  local word=${COMP_WORDS[COMP_CWORD]} path=talus-cli subcommands options i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$path ${COMP_WORDS[i]}" in
      )" +
         path_patterns(commands) +
         R"() path+=" ${COMP_WORDS[i]}" ;;
    esac
  done
  case "$path ${COMP_WORDS[COMP_CWORD-1]}" in
)" + values +
         R"(  esac
  case "$path" in
)" + words +
         R"(  esac
  [[ $word == -* ]] || options=
  COMPREPLY=($(compgen -W "$subcommands $options" -- "$word"))
}
complete -o default -F _talus_cli talus-cli
)";
}

std::string zsh_script(const std::vector<CommandWords>& commands) {
  std::string cases;
  for (const CommandWords& command : commands) {
    cases += "  \"" + command.path + "\")\n";
    if (!command.subcommands.empty()) {
      cases += "    if [[ $PREFIX != -* ]]; then\n      subcommands=(";
      for (const CommandWords& below : commands)
        if (below.path == command.path + ' ' + below.name)
          cases += "\n        '" + below.name + ':' + below.help + '\'';
      cases += ")\n      _describe command subcommands && return\n    fi\n";
    }
    cases += "    _arguments '*:file:_files'";
    for (const OptionWords& option : command.options) {
      cases += " \\\n      '" + option.name + '[' + option.help + ']';
      if (option.has_value)
        cases += ":value:" +
                 (option.choices.empty() ? std::string("_files") : '(' + joined_words(option.choices, " ") + ')');
      cases += '\'';
    }
    cases += " ;;\n";
  }
  return R"(#compdef talus-cli
local path_of=talus-cli depth=1 i
local -a subcommands
for ((i = 2; i < CURRENT; i++)); do
  case "$path_of ${words[i]}" in
    )" + path_patterns(commands) +
         R"() path_of+=" ${words[i]}" depth=$i ;;
  esac
done
words=("${(@)words[depth,-1]}")
((CURRENT -= depth - 1))
case $path_of in
)" + cases +
         "esac\n";
}

std::string fish_script(const std::vector<CommandWords>& commands) {
  std::string lines;
  for (const CommandWords& command : commands) {
    const std::string here = "complete -c talus-cli -n '__talus_cli_at " + command.path + "' ";
    for (const CommandWords& below : commands)
      if (below.path == command.path + ' ' + below.name)
        lines += here + "-f -a " + below.name + " -d '" + below.help + "'\n";
    for (const OptionWords& option : command.options) {
      lines += here + "-l " + option.name.substr(2);
      if (!option.choices.empty())
        lines += " -x -a '" + joined_words(option.choices, " ") + '\'';
      else if (option.has_value)
        lines += " -r";
      lines += " -d '" + option.help + "'\n";
    }
  }
  return R"(function __talus_cli_at
  set -l path talus-cli
  for word in (commandline -opc)[2..]
    switch "$path $word"
      case )" +
         path_patterns(commands, " ") + R"(
        set path "$path $word"
    end
  end
  test "$path" = "$argv"
end
)" + lines;
}

}  // namespace

void add_completion(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("completion", "Print what a shell completes command lines by");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "Whose")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}).description(""))
      ->type_name("bash|zsh|fish");
  command->callback([&program, &invocation, shell] {
    invocation.run = [&program, shell] {
      std::vector<CommandWords> commands;
      collect(program, "", commands);
      std::cout << (*shell == "bash"  ? bash_script(commands)
                    : *shell == "zsh" ? zsh_script(commands)
                                      : fish_script(commands));
      return done;
    };
  });
}

}  // namespace talus::cli
