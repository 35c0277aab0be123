#pragma once
#include <filesystem>
#include <memory>
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
/// Makes one piece after the other in one session: what a driver compiles and keeps serves all of them. A piece that
/// fails ends the session, and leaves nothing to those behind it.
class PieceMaker {
 public:
  /// @param options  outlive this object  @throw gpu::GpuError where pictures are wanted and there is no driver
  explicit PieceMaker(const EachVerb& options);
  /// Opens the data of a piece, and writes its outputs. @throw what opening, drawing and writing throw; Cancelled
  void make(const session::Piece& piece);

 private:
  session::Session& session();

  const EachVerb& mOptions;
  bool mDraws;
  std::unique_ptr<session::Session> mSession;
};

}  // namespace velum::app
