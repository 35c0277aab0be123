#pragma once
#include <any>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/Task.h"
#include "scene/Scene.h"
#include "scene/json/Schema.h"

namespace velum::session {

class Document;
class Session;

/// Something that can be done, by its name: a row of the table that menus, keys, scripts, verbs and tests share. Its
/// arguments are a struct with fields(). It either changes the scene, as one undo step, or acts on the session.
struct Command {
  std::string_view name;     ///< "structure.show"
  std::string_view doc;      ///< One sentence.
  std::string_view example;  ///< A line of a script.

  /// Name, type, unit, range, meaning and default of each argument, in their order.
  std::vector<scene::FieldRow> (*arguments)() = nullptr;
  /// The arguments of a line, without its name: values in their order, then NAME=VALUE. @throw ArgumentError
  std::any (*parse)(std::string_view text) = nullptr;
  /// The counterpart, without those that are as by default.
  std::string (*write)(const std::any& arguments) = nullptr;

  /// Of those that change the scene: the name of the undo step, "Hide aorta"; and the change. Any thread.
  /// @return what there is to tell, one line each  @throw ArgumentError, InputError, Cancelled
  std::function<std::string(const scene::Scene&, const std::any&)> step = {};
  std::function<std::vector<std::string>(scene::Scene&, const std::any&, Progress&)> change = {};
  bool isView = false;  ///< It changes camera and sections alone, and goes into the history as Document::view().
  bool isSlow = false;  ///< The change may take longer than an eye blinks; else only what followFields() does.
  /// Of the others. The session's thread. @return what there is to tell, one line each
  std::function<std::vector<std::string>(Session&, const std::any&, Progress&)> act = {};
  bool answers = false;  ///< What it tells is what was asked for, rather than notes.
};

/// All there are, by their rooms.
std::span<const Command> commands();
/// @throw ArgumentError that says which one was most likely meant
const Command& findCommand(std::string_view name);
/// A page about all of them, for the documents.
std::string commandTable();
/// A few lines about one, for a terminal.
std::string commandHelp(const Command& command);

/// A command with its arguments.
class Call {
 public:
  Call(const Command& command, std::any arguments) : mCommand(&command), mArguments(std::move(arguments)) {}
  /// @param arguments  a struct of the headers beside this one, which names its command
  template <class Arguments>
  requires requires { Arguments::kName; }
  Call(Arguments arguments)  // NOLINT: run(session, ShowStructures{...}) is how it reads best
      : mCommand(&findCommand(Arguments::kName)), mArguments(std::move(arguments)) {}

  const Command& command() const { return *mCommand; }
  const std::any& arguments() const { return mArguments; }
  /// As in a script: "structure.show aorta visible=false". One line.
  std::string line() const;

 private:
  const Command* mCommand;
  std::any mArguments;
};

/// A line of a script: NAME, then values in the order of the arguments, or NAME=VALUE. Blanks in a value stand within
/// quotes or brackets; what is left of a line belongs to the last argument of `set`, `open` and their like.
/// @throw ArgumentError
Call parseCall(std::string_view line);

/// What a call makes of a scene.
struct Edit {
  std::string step;  ///< name of the undo step
  scene::Scene before, after;
  std::vector<std::string> told;  ///< what there is to tell, one line each
};
/// What a call of a command that changes the scene makes of one, with all that follows but growth. Any thread.
/// @throw ArgumentError, InputError, Cancelled
Edit editOf(const scene::Scene& scene, const Call& call, Progress& progress);
/// editOf() takes long: it is work for a job.
bool isLong(const scene::Scene& scene, const Call& call);
/// Makes it an undo step, which a script can do again by the call's line. The session's thread.
/// @param merge  as of Document::edit()
void commit(Document& document, const Edit& edit, const Call& call, bool merge = false);
/// Both, for a call that is not long. @param step  another name of the undo step than the command's
/// @throw as editOf(); then nothing has changed
void edit(Document& document, const Call& call, bool merge = false, const std::string& step = {});
/// The same of what a hand drags or draws, for which there is no command: a script does it again by a `set` line for
/// each field that has changed. @throw as followFields() and the change do; then nothing has changed
void editByHand(Document& document, const std::string& step, const std::function<void(scene::Scene&)>& change,
                bool merge = false);
/// As commit(), of the cuts alone: what else has changed since the edit was worked out stays as it is.
void commitCuts(Document& document, const Edit& edit, const Call& call, bool merge = false);

/// Does it, with all that follows. Where it changes the scene, that is one undo step. The session's thread; long
/// commands take as long as they take: a window makes the edit in a job where isLong().
/// @param merge  as of Document::edit()  @return what there is to tell, one line each
/// @throw ArgumentError, InputError, Cancelled; then nothing has changed
std::vector<std::string> run(Session& session, const Call& call, Progress& progress, bool merge = false);

/// Runs lines one after the other and lets all come to rest after each; lines that are empty or begin with # are passed
/// over. @param told  hears what there is to tell, and of which call  @param name  of the text, for errors, which name
/// the line, too
void runScript(Session& session, std::string_view text, const std::string& name, Progress& progress,
               const std::function<void(const Call&, const std::string&)>& told);

}  // namespace velum::session
