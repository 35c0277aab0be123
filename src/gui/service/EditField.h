#pragma once
#include <string>

#include "session/document/Document.h"

namespace velum::gui {

/// Sets a field of the scene by the command `set`, with all changes that follow from it, as one undo step. @param step
/// the undo step's name for people  @param merge  as of Document::edit()
/// @throw ArgumentError, InputError; then nothing has changed
void setField(session::Document& document, const std::string& path, const std::string& value, const std::string& step,
              bool merge = false);

}  // namespace velum::gui
