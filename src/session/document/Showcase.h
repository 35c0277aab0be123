#pragma once
#include <filesystem>
#include <span>
#include <string_view>

#include "session/document/WorkFile.h"

/// What the program is for, shown by three scenes of its own phantoms that open at once.
namespace velum::session {

struct Showcase {
  std::string_view name;   ///< "head"; its picture among the window's resources has this name, too
  std::string_view title;  ///< for people: "A head"
  std::string_view what;   ///< what there is to see, a few words
};

/// The showcases: a membrane, structures pulled out of a cut, a cell model.
std::span<const Showcase> showcases();

/// Opens a showcase. Its data is made where it is not there yet, and kept for the next time.
/// @param folder  where the data's files are written  @throw ArgumentError for an unknown name; InputError when the
/// disk refuses; Cancelled. Any thread.
Loaded readShowcase(std::string_view name, const std::filesystem::path& folder, Progress& progress);

}  // namespace velum::session
