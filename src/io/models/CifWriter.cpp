#include <fmt/format.h>

#include <algorithm>

#include "core/FileName.h"
#include "core/ReplaceFile.h"
#include "io/models/ModelWriters.h"
#include "io/read/ByteSink.h"

namespace velum::io {

namespace {

/// A value of CIF, in quotes where it is not a bare word.
std::string quoted(const std::string& text) {
  if (text.empty()) return "?";
  std::string line = text;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  if (line.find('\'') == std::string::npos) return "'" + line + "'";
  std::replace(line.begin(), line.end(), '"', '\'');
  return "\"" + line + "\"";
}

/// "A" to "Z", "AA" and on.
std::string asymName(std::uint32_t index) {
  std::string name;
  for (++index; index > 0; index = (index - 1) / 26) name.insert(name.begin(), char('A' + (index - 1) % 26));
  return name;
}

std::string_view symbolOf(std::uint8_t element) {
  switch (element) {
    case 1:
      return "H";
    case 7:
      return "N";
    case 8:
      return "O";
    case 15:
      return "P";
    case 16:
      return "S";
    case kResidue:
      return "X";
    default:
      return "C";
  }
}

std::string_view residueOf(MoleculeKind kind) {
  switch (kind) {
    case MoleculeKind::Lipid:
      return "LIP";
    case MoleculeKind::NucleicAcid:
      return "G";
    case MoleculeKind::Protein:
      return "GLY";
    default:
      return "UNK";
  }
}

class ModelWriter {
 public:
  ModelWriter(const Model& model, ReplaceFile& file, Progress& progress)
      : mModel(model), mSink(file), mProgress(progress) {}

  void write(bool isDeflated) {
    if (isDeflated) mSink.startGzip();
    mSink.write("data_CELLPACK_MODEL\n#\n");
    mSink.write(fmt::format("_struct.entry_id CELLPACK\n_struct.title {}\n#\n", quoted(mModel.name)));
    writeEntities();
    writeAtoms();
    writeAssembly();
    writeOperators();
    mSink.finish();
  }

 private:
  void writeEntities() {
    mSink.write(
        "loop_\n_entity.id\n_entity.type\n_entity.pdbx_description\n_entity.details\n_entity.formula_weight\n"
        "_entity.pdbx_fragment\n_entity.pdbx_parent_entity_id\n");
    for (std::size_t i = 0; i < mModel.types.size(); ++i) {
      const MoleculeType& type = mModel.types[i];
      mSink.write(fmt::format("{} {} {} {} {:.1f} {} {}\n", i + 1,
                              type.kind == MoleculeKind::Lipid ? "non-polymer" : "polymer",
                              quoted(pathOf(mModel, type)), quoted(type.function), type.mass, quoted(type.structure),
                              quoted(type.description)));
    }
    mSink.write("#\n");
  }

  void writeAtoms() {
    mSink.write(
        "loop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_entity_id\n"
        "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n_atom_site.auth_seq_id\n"
        "_atom_site.auth_asym_id\n_atom_site.pdbx_PDB_model_num\n");
    for (std::uint32_t m = 0; m < mModel.molecules.size(); ++m) {
      mProgress.throwIfCancelled();
      const Molecule& molecule = mModel.molecules[m];
      for (const Atom& atom : molecule.atoms) writeAtom(m, symbolOf(atom.element), atom.position, atom.chain);
      if (molecule.atoms.empty() && !molecule.beads.empty())
        for (const glm::vec4& bead : molecule.beads.front()) writeAtom(m, "X", glm::vec3(bead), 0);
    }
    mSink.write("#\n");
  }

  void writeAtom(std::uint32_t m, std::string_view symbol, glm::vec3 p, std::uint16_t chain) {
    const MoleculeType& type = mModel.types[mModel.molecules[m].type];
    mSink.write(fmt::format("ATOM {} {} {} . {} {} {} {} {:.3f} {:.3f} {:.3f} 1 0 {} {} 1\n", ++mAtom, symbol, symbol,
                            residueOf(type.kind), asymName(m), mModel.molecules[m].type + 1, chain + 1, p.x, p.y, p.z,
                            chain + 1, asymName(chain)));
  }

  /// Instances of a molecule stand in a row, and so do their operators.
  void writeAssembly() {
    mSink.write(
        fmt::format("_pdbx_struct_assembly.id 1\n_pdbx_struct_assembly.details author_and_software_defined_assembly\n"
                    "_pdbx_struct_assembly.method_details cellPACK\n_pdbx_struct_assembly.oligomeric_details ?\n"
                    "_pdbx_struct_assembly.oligomeric_count {}\n#\n",
                    mModel.instances.size()));
    mSink.write(
        "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
        "_pdbx_struct_assembly_gen.asym_id_list\n");
    for (std::uint32_t m = 0; m < mModel.molecules.size(); ++m) {
      const Molecule& molecule = mModel.molecules[m];
      mSink.write(fmt::format("1 '({}-{})' {}\n", molecule.firstInstance + 1,
                              molecule.firstInstance + molecule.instanceCount, asymName(m)));
    }
    mSink.write("#\n");
  }

  void writeOperators() {
    mSink.write("loop_\n_pdbx_struct_oper_list.id\n_pdbx_struct_oper_list.type\n");
    for (int r = 1; r <= 3; ++r) {
      for (int c = 1; c <= 3; ++c) mSink.write(fmt::format("_pdbx_struct_oper_list.matrix[{}][{}]\n", r, c));
      mSink.write(fmt::format("_pdbx_struct_oper_list.vector[{}]\n", r));
    }
    for (std::size_t i = 0; i < mModel.instances.size(); ++i) {
      if (i % 65536 == 0) mProgress.report(double(i) / double(mModel.instances.size()), "writing model");
      glm::mat3 m = glm::mat3_cast(mModel.instances[i].rotation);
      glm::vec3 t = mModel.instances[i].position;
      std::string line = fmt::format("{} 'point symmetry operation'", i + 1);
      for (int r = 0; r < 3; ++r) line += fmt::format(" {:.5f} {:.5f} {:.5f} {:.3f}", m[0][r], m[1][r], m[2][r], t[r]);
      mSink.write(line + "\n");
    }
    mSink.write("#\n");
  }

  const Model& mModel;
  ByteSink mSink;
  Progress& mProgress;
  std::size_t mAtom = 0;
};

}  // namespace

void writeCif(const Model& model, const ModelWriting&, ReplaceFile& file, Progress& progress) {
  ModelWriter(model, file, progress).write(lowerExtension(file.target()).ends_with(".gz"));
}

}  // namespace velum::io
