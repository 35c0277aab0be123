#pragma once
#include <filesystem>
#include <string>
#include <vector>

/// The same work for many data sets: which there are, and what becomes of each.
namespace velum::session {

/// How a thousand data sets and their files are named. In the names of files "{name}" is the name of a data set and
/// "{dir}" that of the folder in which it lies.
struct PiecePatterns {
  std::vector<std::string> data;     ///< paths, or patterns with *, ? and [a-z] in parts of a path, as of a shell
  std::string labels;                ///< of each data set; empty: none
  std::vector<std::string> outputs;  ///< files that are made of each
  std::string records;               ///< folder for what became of each; empty: "pieces" beside each first output
};

/// A data set, and what is made of it.
struct Piece {
  std::string name;  ///< what the wildcards of its pattern stand for, with "-" between; of a path, its file's name
                     ///< without endings
  std::string data, labels;  ///< paths; no labels: empty
  std::vector<std::filesystem::path> outputs;
  std::filesystem::path record;  ///< see PieceRecord; the same for the same first output, however that is spelled
};

/// All pieces, by their paths in alphabetical order, each once: the same list in each process that sees the same
/// files. Reads folders only. @throw ArgumentError where two pieces would write one file, or an output has no name of
/// its own for each; InputError where a pattern matches nothing
std::vector<Piece> findPieces(const PiecePatterns& patterns);

}  // namespace velum::session
