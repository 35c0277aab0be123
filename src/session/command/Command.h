#pragma once
#include <any>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/Task.h"
#include "scene/Scene.h"
#include "scene/json/Paths.h"
#include "scene/json/Schema.h"

namespace velum::session {

class Document;
class Session;

/// Something that can be done, by its name: a row of the table that menus, keys, scripts, verbs and tests share. The
/// arguments of a command are a struct with fields(). A command either changes the scene, as one undo step, or acts on
/// the session.
struct Command {
  std::string_view name;     ///< "structure.show"
  std::string_view doc;      ///< One sentence.
  std::string_view example;  ///< A line of a script.

  /// Name, type, unit, range, meaning and default of each argument, in their order.
  std::vector<scene::FieldRow> (*arguments)() = nullptr;
  /// Reads the arguments from a line, without the command's name: values in the order of the arguments, then
  /// NAME=VALUE. @throw ArgumentError
  std::any (*parse)(std::string_view text) = nullptr;
  /// The counterpart of parse(); arguments that have their default are left out.
  std::string (*write)(const std::any& arguments) = nullptr;
  /// The arguments that have not their default, each by its name and as JSON.
  std::vector<scene::FieldValue> (*values)(const std::any& arguments) = nullptr;

  /// For commands that change the scene: the name of the undo step, "Hide aorta"; and the change. Any thread.
  /// @return of the change: notes for the user, one line each  @throw ArgumentError, InputError, Cancelled
  std::function<std::string(const scene::Scene&, const std::any&)> step = {};
  std::function<std::vector<std::string>(scene::Scene&, const std::any&, Progress&)> change = {};
  bool isView = false;  ///< The command changes camera and sections alone, and goes into the history as
                        ///< Document::view().
  bool isSlow = false;  ///< The change itself may take longer than an eye blinks; else only followFields() may.
  /// For commands that act on the session. The session's thread. @return notes for the user, one line each
  std::function<std::vector<std::string>(Session&, const std::any&, Progress&)> act = {};
  bool answers = false;  ///< The lines that the command returns are what was asked for, rather than notes.
  /// What an argument was called before, and is called now: calls take both. Empty: none has another name.
  std::pair<std::string_view, std::string_view> renamed = {};
};

/// All commands, ordered by the rooms of the window to which they belong.
std::span<const Command> commands();
/// The command with a name. @throw ArgumentError that says which command was most likely meant
const Command& findCommand(std::string_view name);
/// A page about all commands, for the documents.
std::string commandTable();
/// A few lines about one command, for a terminal.
std::string commandHelp(const Command& command);

/// A command with its arguments.
class Call {
 public:
  Call(const Command& command, std::any arguments) : mCommand(&command), mArguments(std::move(arguments)) {}
  /// @param arguments  a struct of one of the headers beside this one; its kName says which command it is for
  template <class Arguments>
  requires requires { Arguments::kName; }
  Call(Arguments arguments)  // NOLINT: run(session, ShowStructures{...}) is how it reads best
      : mCommand(&findCommand(Arguments::kName)), mArguments(std::move(arguments)) {}

  const Command& command() const { return *mCommand; }
  const std::any& arguments() const { return mArguments; }
  /// The call as a line of a script: "structure.show aorta visible=false".
  std::string line() const;

 private:
  const Command* mCommand;
  std::any mArguments;
};

/// A line of a script: NAME, then values in the order of the arguments, or NAME=VALUE. Blanks in a value stand within
/// quotes or brackets; what is left of a line belongs to the last argument of `set`, `open` and their like.
/// @throw ArgumentError
Call parseCall(std::string_view line);

/// What a call makes of a scene, not yet in a document.
struct Edit {
  std::string step;  ///< name of the undo step
  scene::Scene before, after;
  std::vector<std::string> told;  ///< notes for the user, one line each
};
/// What a call of a command that changes the scene makes of a scene, with all that follows except growth. Any thread.
/// @throw ArgumentError, InputError, Cancelled
Edit editOf(const scene::Scene& scene, const Call& call, Progress& progress);
/// True when editOf() of this call takes long, so that it is work for a job.
bool isLong(const scene::Scene& scene, const Call& call);
/// Makes an edit an undo step of the document; the call's line lets a script do the step again. The session's thread.
/// @param merge  as of Document::edit()
void commit(Document& document, const Edit& edit, const Call& call, bool merge = false);
/// editOf() and commit(), for a call that is not long. @param step  a name for the undo step in the place of the
/// command's
/// @throw as editOf(); then nothing has changed
void edit(Document& document, const Call& call, bool merge = false, const std::string& step = {});
/// Makes an undo step of what a hand drags or draws, for which there is no command: a script does the step again by a
/// `set` line for each field that has changed. @throw as followFields() and the change do; then nothing has changed
void editByHand(Document& document, const std::string& step, const std::function<void(scene::Scene&)>& change,
                bool merge = false);
/// As commit(), but takes only the cuts of the edit: what else has changed since the edit was worked out stays as it
/// is.
void commitCuts(Document& document, const Edit& edit, const Call& call);

/// Does what a call says, with all that follows; where it changes the scene, as one undo step. The session's thread; a
/// long command takes as long as it takes: where isLong() a window works out the edit in a job instead.
/// @param merge  as of Document::edit()  @return notes for the user, one line each
/// @throw ArgumentError, InputError, Cancelled; then nothing has changed
std::vector<std::string> run(Session& session, const Call& call, Progress& progress, bool merge = false);

/// Runs the lines of a script one after the other and lets all come to rest after each; lines that are empty or begin
/// with # are passed over. @param told  called with each note for the user, and the call that it is of  @param name  of
/// the text, for errors, which name the line, too
void runScript(Session& session, std::string_view text, const std::string& name, Progress& progress,
               const std::function<void(const Call&, const std::string&)>& told);

}  // namespace velum::session
