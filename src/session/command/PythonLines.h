#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Commands as the Python module `velum` has them: methods of a session, made from the same table.
namespace velum::session {

/// A name of the table as Python takes it: `from` and `import` are words of that language, and become `from_` and
/// `import_`.
std::string pythonName(std::string_view name);

/// The value of a field or argument as Python writes it. @param json  a text of JSON
std::string pythonValue(std::string_view json);

/// A program in Python that does what the lines of a script do: `s.cut.add("box")` for a command, `s["FIELD"] = VALUE`
/// for `set`; comments stay. @throw ArgumentError for a line that is none
std::string pythonProgram(const std::vector<std::string>& lines);

}  // namespace velum::session
