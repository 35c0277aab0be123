#include "io/models/CifModels.h"

#include <algorithm>

#include "core/FileName.h"
#include "io/models/BinaryCif.h"
#include "io/models/CifText.h"
#include "io/models/ModelReaders.h"

namespace velum::io {

namespace {

bool isCellPack(const CifBlock& block) {
  if (lowerCase(block.header).find("cellpack") != std::string::npos) return true;
  const CifTable* assembly = block.find("pdbx_struct_assembly");
  return assembly && (lowerCase(assembly->text("method_details", 0)) == "cellpack" ||
                      lowerCase(assembly->text("details", 0)) == "cellpack");
}

}  // namespace

Model modelOf(const std::vector<CifBlock>& blocks, const Path& path, Progress& progress, const ModelReading&) {
  auto block = std::find_if(blocks.begin(), blocks.end(), [](const CifBlock& b) { return b.find("atom_site"); });
  if (block == blocks.end()) refuse(path, "has no atoms (_atom_site)");
  const CifTable* models = block->find("pdbx_model");
  if (models && models->find("name")) return petWorldModel(*block, path, progress);
  if (isCellPack(*block)) return cellPackModel(*block, path, progress);
  return plainCifModel(*block, path, progress);
}

Model readBinaryCif(const Path& path, Progress& progress, const ModelReading& reading) {
  return modelOf(parseBinaryCif(textOf(path), path), path, progress, reading);
}

Model readCifText(const Path& path, Progress& progress, const ModelReading& reading) {
  return modelOf(parseCifText(textOf(path), path), path, progress, reading);
}

}  // namespace velum::io
