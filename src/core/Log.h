#pragma once
#include <string_view>

/// Messages for people, on stderr. One line each. Any thread.
namespace velum::log {

void setVerbose(bool verbose);
/// Shown with --verbose only.
void info(std::string_view message);
/// Writes the line without any prefix. The line is lost where stderr refuses it, as on a full disk.
void say(std::string_view line);
/// Always shown, prefixed with "warning: ".
void warning(std::string_view message);

}  // namespace velum::log
