#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/Inputs.h"
#include "app/StandardInput.h"
#include "app/Verbs.h"
#include "core/Error.h"
#include "core/Log.h"
#include "session/Session.h"
#include "session/command/Command.h"

namespace velum::app {

namespace {

constexpr std::uintmax_t kLongestScript = 64u << 20;

struct ScriptOptions {
  Common common;
  std::string script;
  std::vector<std::string> inputs;
};

std::string textOf(const std::string& script) {
  std::string path = fileOfInput(script);
  std::error_code error;
  auto size = std::filesystem::file_size(path, error);
  if (error) throw InputError(fmt::format("{}: {}", script, error.message()));
  if (size > kLongestScript) throw InputError(fmt::format("{}: {} MiB is too much for a script", script, size >> 20));
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int run(const ScriptOptions& options) {
  std::string text = textOf(options.script);
  session::Session session;
  session.setContextKind(options.common.context);
  Progress& progress = consoleProgress();
  if (!options.inputs.empty()) {
    InputOptions input;
    input.inputs = options.inputs;
    openInputs(session, input, 16.0 / 9.0);
  }
  session::runScript(session, text, options.script, progress, [](const session::Call& call, const std::string& line) {
    call.command().answers ? fmt::print("{}\n", line) : log::warning(line);
  });
  progress.report(1.0, "");
  return 0;
}

int help(const std::string& name) {
  if (!name.empty()) {
    fmt::print("{}", session::commandHelp(session::findCommand(name)));
    return 0;
  }
  for (const session::Command& command : session::commands()) fmt::print("{:<22} {}\n", command.name, command.doc);
  fmt::print("velum-batch help COMMAND says more about one.\n");
  return 0;
}

}  // namespace

Run registerRunScript(CLI::App& verb) {
  auto options = std::make_shared<ScriptOptions>();
  addCommon(verb, options->common);
  verb.add_option("script", options->script,
                  "text file with a command a line (see velum-batch help); - for standard input")
      ->required();
  verb.add_option("input", options->inputs, "what is open when it begins");
  return [options] { return run(*options); };
}

Run registerHelp(CLI::App& verb) {
  auto name = std::make_shared<std::string>();
  verb.add_option("command", *name, "say all about this one");
  return [name] { return help(*name); };
}

}  // namespace velum::app
