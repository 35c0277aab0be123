#pragma once
#include <string>

namespace velum::app {

/// The word on a command line that means standard input.
constexpr const char* kStandardInput = "-";

/// The file that an input names; for standard input a file with a copy of it, as readers seek and ask for the length.
/// The copy is removed when the program ends. @throw InputError when nothing comes in, or the disk refuses
std::string fileOfInput(const std::string& input);

}  // namespace velum::app
