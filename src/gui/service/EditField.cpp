#include "gui/service/EditField.h"

#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"

namespace velum::gui {

void setField(session::Document& document, const std::string& path, const std::string& value, const std::string& step,
              bool merge) {
  session::edit(document, session::SetField{path, value}, merge, step);
}

}  // namespace velum::gui
