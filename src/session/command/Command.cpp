#include "session/command/Command.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Error.h"
#include "core/NearestName.h"
#include "core/Text.h"
#include "session/Session.h"
#include "session/command/CommandRow.h"
#include "session/document/SetFields.h"

namespace velum::session {

namespace {

std::vector<Command> allCommands() {
  std::vector<Command> all;
  for (auto rows :
       {detail::documentCommands(), detail::viewCommands(), detail::cutCommands(), detail::membraneCommands(),
        detail::extrusionCommands(), detail::growthCommands(), detail::structureCommands(), detail::lookCommands(),
        detail::modelCommands(), detail::letteringCommands(), detail::markCommands(), detail::filmCommands()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

/// "structures=LIST" of an argument, for the head of its help.
std::string formOf(const Command& command) {
  std::string form(command.name);
  for (const auto& row : command.arguments()) form += fmt::format(" [{}]", row.path);
  return form;
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> kAll = allCommands();
  return kAll;
}

const Command& findCommand(std::string_view name) {
  auto all = commands();
  auto found = std::find_if(all.begin(), all.end(), [&](const Command& command) { return command.name == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Command& command : all) names.emplace_back(command.name);
  std::string meant = nearestName(name, names);
  throw ArgumentError(fmt::format("'{}' is no command{}; velum-batch help lists them", printable(name),
                                  meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant)));
}

std::string Call::line() const {
  std::string arguments = mCommand->write(mArguments);
  return std::string(mCommand->name) + (arguments.empty() ? "" : " ") + arguments;
}

Call parseCall(std::string_view line) {
  line = trimmed(line);
  std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  const Command& command = findCommand(line.substr(0, end));
  return {command, command.parse(trimmed(line.substr(end)))};
}

Edit editOf(const scene::Scene& scene, const Call& call, Progress& progress) {
  Edit edit{call.command().step(scene, call.arguments()), scene, scene, {}};
  edit.told = call.command().change(edit.after, call.arguments(), progress);
  auto followed = followFields(edit.after, scene, progress);
  edit.told.insert(edit.told.end(), followed.begin(), followed.end());
  return edit;
}

bool isLong(const scene::Scene& scene, const Call& call) {
  if (call.command().act || call.command().isSlow) return true;
  scene::Scene after = scene;
  Progress progress;
  call.command().change(after, call.arguments(), progress);
  return mustFollow(after, scene);
}

void commit(Document& document, const Edit& edit, const Call& call, bool merge) {
  if (call.command().isView)
    return document.view([&](scene::Scene& scene) {
      scene.camera = edit.after.camera;
      scene.sections = edit.after.sections;
    });
  document.edit(
      edit.step, [&](scene::Scene& scene) { scene = edit.after; }, merge, call.line());
}

void edit(Document& document, const Call& call, bool merge, const std::string& step) {
  Progress progress;
  Edit made = editOf(document.shown(), call, progress);
  if (!step.empty()) made.step = step;
  commit(document, made, call, merge);
}

void editByHand(Document& document, const std::string& step, const std::function<void(scene::Scene&)>& change,
                bool merge) {
  auto changeAndFollow = [&change](scene::Scene& scene) {
    scene::Scene before = scene;
    Progress progress;
    change(scene);
    followFields(scene, before, progress);
  };
  document.edit(step, changeAndFollow, merge);
}

void commitCuts(Document& document, const Edit& edit, const Call& call) {
  document.edit(
      edit.step, [&](scene::Scene& scene) { scene.cuts = edit.after.cuts; }, false, call.line());
}

std::vector<std::string> run(Session& session, const Call& call, Progress& progress, bool merge) {
  if (call.command().act) return call.command().act(session, call.arguments(), progress);
  Edit edit = editOf(session.shown(), call, progress);
  commit(session.document(), edit, call, merge);
  return edit.told;
}

void runScript(Session& session, std::string_view text, const std::string& name, Progress& progress,
               const std::function<void(const Call&, const std::string&)>& told) {
  for (int number = 1; !text.empty(); ++number) {
    std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#')) continue;
    auto where = [&](const std::exception& error) { return fmt::format("{}:{}: {}", name, number, error.what()); };
    try {
      Call call = parseCall(line);
      for (const auto& news : run(session, call, progress)) told(call, news);
      session.settle(progress);
    } catch (const ArgumentError& error) {
      throw ArgumentError(where(error));
    } catch (const InputError& error) {
      throw InputError(where(error));
    }
  }
}

std::string commandHelp(const Command& command) {
  std::string text = fmt::format("{}\n  {}\n", formOf(command), command.doc);
  for (const auto& row : command.arguments()) {
    text += fmt::format("    {:<12} {} ({}", row.path, row.doc, row.type);
    if (!row.unit.empty()) text += ", " + row.unit;
    if (!row.range.empty()) text += ", " + row.range;
    text += fmt::format("; {})\n",
                        row.defaultValue == "\"\"" || row.defaultValue == "[]" ? "no default" : row.defaultValue);
  }
  return text + fmt::format("  e.g. {}\n", command.example);
}

std::string commandTable() {
  std::string text;
  for (const Command& command : commands()) {
    text += fmt::format("## {}\n\n{} For example: `{}`\n\n", command.name, command.doc, command.example);
    auto rows = command.arguments();
    if (rows.empty()) continue;
    text += "| argument | kind | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
    for (const auto& row : rows)
      text += fmt::format("| `{}` | {} | {} | {} | `{}` | {} |\n", row.path, row.type, row.unit, row.range,
                          row.defaultValue, row.doc);
    text += "\n";
  }
  return text;
}

}  // namespace velum::session
