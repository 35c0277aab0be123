#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/models/ModelParts.h"

namespace velum::io {

/// The files of structures that lie near a model. Models come from strangers: they may name what lies in their own
/// folder, in the two levels of folders below, and in folders of structures ("proteins") beside or next to it; a name
/// with folders in it counts by its last part.
class StructureFiles {
 public:
  explicit StructureFiles(const Path& model);

  /// A structure of a name with or without its ending, in any case; nothing where there is none.
  std::optional<Path> find(std::string_view name) const;

 private:
  void addFolder(const Path& folder, int depth);

  std::map<std::string, Path> mByName;  ///< Lower case, with its ending.
  std::size_t mSeen = 0;
};

/// What an ingredient is made of.
struct StructureParts {
  std::vector<Atom> atoms;
  std::vector<glm::vec4> beads;  ///< Where the file has balls and no atoms.
  bool isNucleic = false;
};

/// Reads a PDB file, or balls: x, y, z and radius as 32-bit numbers. @param withCopies  as the biological assembly says
/// @throw InputError
StructureParts readStructure(const Path& path, bool withCopies);

}  // namespace velum::io
