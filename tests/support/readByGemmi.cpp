#include "GemmiAssembly.h"

#include <gemmi/cif.hpp>
#include <gemmi/mmcif.hpp>

namespace velum {

GemmiAssembly readByGemmi(const std::string& text) {
  gemmi::cif::Document document = gemmi::cif::read_memory(text.data(), text.size(), "test.cif");
  GemmiAssembly out;
  out.block = document.blocks.at(0).name;
  gemmi::Structure structure = gemmi::make_structure_from_block(document.blocks[0]);
  out.count = structure.assemblies.size();
  for (const auto& generator : structure.assemblies.at(0).generators)
    for (const auto& oper : generator.operators) {
      gemmi::Vec3 t = oper.transform.vec, z = oper.transform.mat.multiply(gemmi::Vec3(0, 0, 1));
      out.operators.push_back({{t.x, t.y, t.z}, {z.x, z.y, z.z}, generator.subchains.size()});
    }
  for (const gemmi::Chain& chain : structure.models.at(0).chains)
    for (const gemmi::Residue& residue : chain.residues) out.atoms += residue.atoms.size();
  return out;
}

}  // namespace velum
