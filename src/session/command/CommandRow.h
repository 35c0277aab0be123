#pragma once
#include <any>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/json/FieldPaths.h"
#include "scene/json/FieldTable.h"
#include "session/command/Command.h"

/// How the rows of the table of commands are made, from a struct of arguments and functions that take this struct.
namespace velum::session::detail {

/// How a command names an item of a list: by its name where no other item has the name, else by its id; by "#12" where
/// another item is called 12. findByKey() is the counterpart.
template <class Item>
std::string keyOf(const std::vector<Item>& list, int id) {
  std::string number = std::to_string(id);
  auto count = [&](const std::string& name) {
    return std::count_if(list.begin(), list.end(), [&](const Item& item) { return item.name == name; });
  };
  for (const Item& item : list)
    if (item.id == id && !item.name.empty() && item.name.front() != '#' && count(item.name) == 1) return item.name;
  return (count(number) > 0 ? "#" : "") + number;
}

/// A place of the world as text for errors.
inline std::string textOf(glm::dvec3 place) { return fmt::format("{:g},{:g},{:g}", place.x, place.y, place.z); }

/// A value of a line, with the argument's name that is in front of it; the name is empty where the value stands at its
/// place.
struct Word {
  std::string name, value;
};
/// The words of a line. @param names  of the arguments  @param rest  number, from 1, of the word without a name that
/// takes all that is left of the line; 0: no word does  @throw ArgumentError where a quote or bracket is not closed
std::vector<Word> wordsOfLine(std::string_view text, const std::vector<std::string>& names, std::size_t rest);
/// A value, in quotes where a line needs them.
std::string quoted(const std::string& value);
/// "aorta,left kidney" as a list of texts.
std::string asTexts(std::string_view value);

template <class Arguments>
std::vector<std::string> namesOf() {
  std::vector<std::string> names;
  Arguments some{};
  auto visit = [&](std::string_view name, auto&, const FieldInfo&) { names.emplace_back(name); };
  Arguments::fields(some, visit);
  return names;
}

/// Number, from 1, of the argument that takes what is left of a line; 0: no argument does.
template <class Arguments>
constexpr std::size_t restOf() {
  if constexpr (requires { Arguments::kTakesRest; })
    return Arguments::kTakesRest;
  else
    return 0;
}

/// See Command::renamed.
template <class Arguments>
constexpr std::pair<std::string_view, std::string_view> renamedOf() {
  if constexpr (requires { Arguments::kRenamed; })
    return Arguments::kRenamed;
  else
    return {};
}

template <class Arguments>
std::any parseArguments(std::string_view text) {
  std::vector<std::string> names = namesOf<Arguments>(), known = names;
  auto [before, now] = renamedOf<Arguments>();
  if (!before.empty()) known.emplace_back(before);
  Arguments out{};
  std::size_t place = 0;
  for (Word& word : wordsOfLine(text, known, restOf<Arguments>())) {
    if (!before.empty() && word.name.substr(0, word.name.find_first_of(".[")) == before)
      word.name.replace(0, before.size(), now);
    if (word.name.empty() && place >= names.size())
      throw ArgumentError(fmt::format("'{}' is one argument too many for {}", word.value, Arguments::kName));
    std::string path = word.name.empty() ? names[place++] : word.name;
    auto visit = [&](std::string_view name, auto& member, const FieldInfo&) {
      using Member = std::remove_cvref_t<decltype(member)>;
      if constexpr (std::is_same_v<Member, std::vector<std::string>>)
        if (name == path) word.value = asTexts(word.value);
    };
    Arguments::fields(out, visit);
    try {
      scene::detail::assignMember(out, path, word.value, "");
    } catch (const ArgumentError& error) {
      std::string_view what = error.what();
      if (what.starts_with("scene: ")) what.remove_prefix(7);
      throw ArgumentError(fmt::format("{}: {}", Arguments::kName, what));
    }
  }
  return out;
}

/// A value as a word of a line.
template <class Value>
std::string wordOf(const Value& value) {
  if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    bool isPlain = std::none_of(value.begin(), value.end(), [](const std::string& item) {
      return item.empty() || trimmed(item) != item || item.find_first_of(",[\"\n\r") != std::string::npos;
    });
    return isPlain ? fmt::format("{}", fmt::join(value, ","))
                   : scene::detail::write(value).dump(-1, ' ', false, scene::detail::Json::error_handler_t::replace);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    bool isOneLine = !value.empty() && value.find_first_of("\n\r") == std::string::npos && trimmed(value) == value;
    return isOneLine && value.front() != '"'
               ? value
               : scene::detail::Json(value).dump(-1, ' ', false, scene::detail::Json::error_handler_t::replace);
  } else {
    return scene::detail::valueText(scene::detail::write(value));
  }
}

/// Calls visit(name, member, isAsByDefault) for each argument, in their order.
template <class Arguments, class Visit>
void visitArguments(const Arguments& arguments, Visit visit) {
  static const Arguments kFresh{};
  std::vector<const void*> fresh;
  auto note = [&](std::string_view, const auto& member, const FieldInfo&) { fresh.push_back(&member); };
  Arguments::fields(kFresh, note);
  std::size_t place = 0;
  auto compare = [&](std::string_view name, const auto& member, const FieldInfo&) {
    visit(name, member, member == *static_cast<decltype(&member)>(fresh[place++]));
  };
  Arguments::fields(arguments, compare);
}

template <class Arguments>
std::string writeArguments(const std::any& arguments) {
  std::string named, placed;  // the argument that takes the rest of a line comes last
  std::size_t place = 0;
  bool isInOrder = true;  // until an argument was left out
  auto visit = [&](std::string_view name, const auto& member, bool isAsByDefault) {
    using Member = std::remove_cvref_t<decltype(member)>;
    bool isRest = ++place == restOf<Arguments>();
    bool hasPlace = isInOrder && (restOf<Arguments>() == 0 || place <= restOf<Arguments>());
    // The argument that takes the rest of a line is found by its place.
    if (isAsByDefault && place >= restOf<Arguments>()) return void(isInOrder = false);
    std::string& line = hasPlace ? placed : named;
    if (!line.empty()) line += ' ';
    if (!hasPlace) line += std::string(name) + "=";
    if (!isRest)
      line += quoted(wordOf(member));
    else if constexpr (std::is_same_v<Member, std::string>)
      line += wordOf(member);
    else
      line += scene::detail::valueText(scene::detail::write(member));
  };
  visitArguments(std::any_cast<const Arguments&>(arguments), visit);
  bool isNamedFirst = restOf<Arguments>() > 0;
  std::string blank = named.empty() || placed.empty() ? "" : " ";
  return isNamedFirst ? named + blank + placed : placed + blank + named;
}

template <class Arguments>
std::vector<scene::FieldValue> valuesOf(const std::any& arguments) {
  std::vector<scene::FieldValue> values;
  auto visit = [&](std::string_view name, const auto& member, bool isAsByDefault) {
    if (!isAsByDefault)
      values.push_back({std::string(name), scene::detail::write(member).dump(
                                               -1, ' ', false, scene::detail::Json::error_handler_t::replace)});
  };
  visitArguments(std::any_cast<const Arguments&>(arguments), visit);
  return values;
}

template <class Arguments>
std::vector<scene::FieldRow> argumentRows() {
  std::vector<scene::FieldRow> rows;
  scene::detail::addRows(Arguments{}, "", rows);
  return rows;
}

template <class Arguments>
Command rowOf(std::string_view doc, std::string_view example) {
  Command row{
      Arguments::kName,   doc, example, argumentRows<Arguments>, parseArguments<Arguments>, writeArguments<Arguments>,
      valuesOf<Arguments>};
  row.renamed = renamedOf<Arguments>();
  return row;
}

/// A command that changes the scene.
/// @param step    std::string(const scene::Scene&, const Arguments&), or a text
/// @param change  void(scene::Scene&, const Arguments&), or with a Progress& behind, which makes it a slow one; where
///                there is something to tell, it gives the lines
template <class Arguments, class Step, class Change>
Command editRow(std::string_view doc, std::string_view example, Step step, Change change) {
  Command row = rowOf<Arguments>(doc, example);
  row.step = [step](const scene::Scene& scene, const std::any& arguments) -> std::string {
    if constexpr (std::is_convertible_v<Step, std::string>)
      return step;
    else
      return step(scene, std::any_cast<const Arguments&>(arguments));
  };
  constexpr bool isSlow = std::is_invocable_v<Change, scene::Scene&, const Arguments&, Progress&>;
  row.isSlow = isSlow;
  row.change = [change](scene::Scene& scene, const std::any& any, Progress& progress) -> std::vector<std::string> {
    const auto& arguments = std::any_cast<const Arguments&>(any);
    auto run = [&] {
      if constexpr (isSlow)
        return change(scene, arguments, progress);
      else
        return change(scene, arguments);
    };
    if constexpr (std::is_void_v<decltype(run())>)
      return run(), std::vector<std::string>();
    else
      return run();
  };
  return row;
}

/// A command that acts on the session. @param act  std::vector<std::string>(Session&, const Arguments&, Progress&)
template <class Arguments, class Act>
Command actRow(std::string_view doc, std::string_view example, Act act) {
  Command row = rowOf<Arguments>(doc, example);
  row.act = [act](Session& session, const std::any& arguments, Progress& progress) {
    return act(session, std::any_cast<const Arguments&>(arguments), progress);
  };
  return row;
}

// The rows, a file each.
std::vector<Command> documentCommands();
std::vector<Command> structureCommands();
std::vector<Command> cutCommands();
std::vector<Command> lookCommands();
std::vector<Command> modelCommands();
std::vector<Command> letteringCommands();
std::vector<Command> markCommands();
std::vector<Command> extrusionCommands();
std::vector<Command> growthCommands();
std::vector<Command> membraneCommands();
std::vector<Command> viewCommands();
std::vector<Command> filmCommands();

}  // namespace velum::session::detail
