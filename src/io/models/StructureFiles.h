#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/models/ModelParts.h"

namespace velum::io {

/// The files of structures that lie near a model. Models come from strangers, so they may only name files in their own
/// folder, in the two levels of folders below it, and in folders of structures ("proteins") beside the file or next to
/// its folder. Of a name with folders in it only the last part counts.
class StructureFiles {
 public:
  explicit StructureFiles(const Path& model);

  /// The file of a structure by its name, with or without ending, in any case; nothing where there is none.
  std::optional<Path> find(std::string_view name) const;

 private:
  void addFolder(const Path& folder, int depth);

  std::map<std::string, Path> mByName;  ///< By file name in lower case, with its ending.
  std::size_t mSeen = 0;
};

/// The parts that an ingredient is made of.
struct StructureParts {
  std::vector<Atom> atoms;
  std::vector<glm::vec4> beads;  ///< Where the file has balls and no atoms.
  bool isNucleic = false;
};

/// Reads a PDB file, or balls: x, y, z and radius as 32-bit numbers. @param withCopies  with the copies of the
/// biological assembly
/// @throw InputError
StructureParts readStructure(const Path& path, bool withCopies);

}  // namespace velum::io
