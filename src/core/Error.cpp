#include "core/Error.h"

#include "core/Text.h"

namespace velum {

Error::Error(ExitCode code, const std::string& message) : std::runtime_error(printable(message)), mExitCode(code) {}

}  // namespace velum
