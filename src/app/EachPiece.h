#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/Inputs.h"
#include "session/each/Pieces.h"

namespace velum::app {

/// What the verb `each` makes of every data set.
struct EachVerb {
  Common common;
  InputOptions input;  ///< its inputs are patterns
  LetteringOptions lettering;
  DrawnOptions drawn;
  session::PiecePatterns names;
  std::string scene, by, part;
  bool again = false, retry = false, list = false, structures = false, faces = false;
  std::vector<std::string> words;  ///< of the command line, on which pieces depend
};

/// An output is a table rather than a picture.
bool isTable(const std::filesystem::path& path);
/// Opens the data of a piece in a session of its own, and writes the piece's outputs. @throw what opening, drawing and
/// writing throw; Cancelled
void makePiece(const EachVerb& options, const session::Piece& piece);

}  // namespace velum::app
