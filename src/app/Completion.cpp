#include <fmt/format.h>

#include "app/Inputs.h"
#include "app/Verbs.h"

namespace velum::app {

namespace {

/// An option as the shell is to complete it.
struct Word {
  std::string name, doc;
  bool takesValue = false;
  std::vector<std::string> values;  ///< Values that the option may have; empty: any, such as the name of a file.
};
struct VerbWords {
  std::string name, doc;
  std::vector<Word> options;
};

/// "TEXT:{keep,remove}" and "ENUM:value in {auto->0,egl->1} OR {0,1}" as their words.
std::vector<std::string> valuesIn(const std::string& type) {
  std::size_t begin = type.find('{'), end = type.find('}', begin);
  if (end == type.npos) return {};
  std::vector<std::string> values;
  std::string word;
  for (char c : type.substr(begin + 1, end - begin - 1) + ",") {
    if (c != ',') {
      word += c;
      continue;
    }
    values.push_back(word.substr(0, word.find("->")));
    word.clear();
  }
  return values;
}

std::vector<VerbWords> wordsOf(const CLI::App& program) {
  std::vector<VerbWords> verbs;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    VerbWords words{verb->get_name(), verb->get_description(), {}};
    for (const CLI::Option* option : verb->get_options()) {
      if (option->get_positional()) continue;
      for (const std::string& name : option->get_lnames())
        words.options.push_back({"--" + name, option->get_description(), option->get_expected_max() > 0,
                                 valuesIn(option->get_type_name())});
      for (const std::string& name : option->get_snames())
        words.options.push_back({"-" + name, option->get_description(), option->get_expected_max() > 0, {}});
    }
    verbs.push_back(std::move(words));
  }
  return verbs;
}

std::string joined(const std::vector<Word>& options) {
  std::string text;
  for (const Word& option : options) text += (text.empty() ? "" : " ") + option.name;
  return text;
}

/// A text between single quotes of a shell; characters that must not stand in zsh's brackets become blanks.
std::string quoted(std::string text) {
  std::string out;
  for (char c : text)
    out += c == '\'' ? std::string("'\\''") : c == '[' || c == ']' || c == ':' ? " " : std::string(1, c);
  return out;
}

void printBash(const std::vector<VerbWords>& verbs) {
  std::string names;
  for (const auto& verb : verbs) names += (names.empty() ? "" : " ") + verb.name;
  fmt::print(
      "_velum_batch() {{\n  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\"\n");
  fmt::print(
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n"
      "    return\n  fi\n",
      names);
  fmt::print("  case \"${{COMP_WORDS[1]}} $before\" in\n");
  for (const auto& verb : verbs)
    for (const Word& option : verb.options)
      if (!option.values.empty())
        fmt::print("    '{} {}') COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", verb.name, option.name,
                   fmt::join(option.values, " "));
  fmt::print("  esac\n  case \"$word\" in -*) ;; *) COMPREPLY=($(compgen -f -- \"$word\")); return ;; esac\n");
  fmt::print("  case \"${{COMP_WORDS[1]}}\" in\n");
  for (const auto& verb : verbs)
    fmt::print("    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", verb.name, joined(verb.options));
  fmt::print("  esac\n}}\ncomplete -o filenames -F _velum_batch velum-batch\n");
}

void printZsh(const std::vector<VerbWords>& verbs) {
  fmt::print("#compdef velum-batch\n_velum_batch() {{\n  if (( CURRENT == 2 )); then\n    local -a verbs=(\n");
  for (const auto& verb : verbs) fmt::print("      '{}:{}'\n", verb.name, quoted(verb.doc));
  fmt::print(
      "    )\n    _describe verb verbs\n    return\n  fi\n  local verb=$words[2]\n  shift words\n  (( CURRENT-- ))\n");
  fmt::print("  case $verb in\n");
  for (const auto& verb : verbs) {
    fmt::print("    {}) _arguments", verb.name);
    for (const Word& option : verb.options) {
      std::string value;
      if (option.takesValue)
        value = option.values.empty() ? ":value:_files" : fmt::format(":value:({})", fmt::join(option.values, " "));
      fmt::print(" \\\n      '{}[{}]{}'", option.name, quoted(option.doc), value);
    }
    fmt::print(" \\\n      '*:file:_files' ;;\n");
  }
  // A file that zsh loads is the function's first call; of `eval` it only hears that there is such a function.
  fmt::print(
      "  esac\n}}\nif [ \"$funcstack[1]\" = _velum-batch ]; then\n  _velum_batch \"$@\"\nelse\n"
      "  compdef _velum_batch velum-batch\nfi\n");
}

void printFish(const std::vector<VerbWords>& verbs) {
  for (const auto& verb : verbs) {
    fmt::print("complete -c velum-batch -n __fish_use_subcommand -f -a {} -d '{}'\n", verb.name, quoted(verb.doc));
    for (const Word& option : verb.options) {
      bool isLong = option.name.starts_with("--");
      fmt::print("complete -c velum-batch -n '__fish_seen_subcommand_from {}' {} {}{}{} -d '{}'\n", verb.name,
                 isLong ? "-l" : "-s", option.name.substr(isLong ? 2 : 1), option.takesValue ? " -r" : "",
                 option.values.empty() ? "" : fmt::format(" -f -a '{}'", fmt::join(option.values, " ")),
                 quoted(option.doc));
    }
  }
}

}  // namespace

Run registerCompletion(CLI::App& verb) {
  auto shell = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  verb.add_option("shell", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  verb.add_flag("--json", *json, "the tables as JSON, whatever the shell");
  return [&verb, shell, json] {
    auto verbs = wordsOf(*verb.get_parent());
    if (*json) {
      Json out = Json::object();
      for (const auto& words : verbs)
        for (const Word& option : words.options) out[words.name][option.name] = option.values;
      printJson(out);
    } else if (*shell == "bash") {
      printBash(verbs);
    } else if (*shell == "zsh") {
      printZsh(verbs);
    } else {
      printFish(verbs);
    }
    return 0;
  };
}

}  // namespace velum::app
