#include <cstring>
#include <nlohmann/json.hpp>

#include "BinaryCifParts.h"
#include "Damage.h"
#include "ModelFiles.h"
#include "PeakMemory.h"
#include "io/models/BinaryCif.h"

namespace velum::io {
namespace {

using namespace binaryCif;

Model readBytes(const std::string& bytes, const char* name = "a.bcif") {
  TempFolder folder;
  writeText(folder / name, bytes);
  return readModelOf(folder / name);
}

TEST(BinaryCif, TypesAreEntitiesAndLipidsStandAlone) {
  Model model = readBytes(packed(small()));
  ASSERT_EQ(model.types.size(), 2u);
  EXPECT_EQ(pathOf(model, model.types[0]), "root.in.proteins.P");
  EXPECT_EQ(model.types[0].instanceCount, 2u) << "both asyms move together";
  EXPECT_EQ(model.types[0].moleculeCount, 1u);
  EXPECT_EQ(model.molecules[0].atoms[1].chain, 1);
  EXPECT_EQ(model.molecules[0].atoms[1].element, 7);
  EXPECT_EQ(model.instances[1].position, glm::vec3(20));
  EXPECT_EQ(model.types[1].kind, MoleculeKind::Lipid);
  EXPECT_EQ(model.types[1].instanceCount, 2u) << "each lipid by itself, and none of a range from high to low";
  EXPECT_EQ(model.types[1].moleculeCount, 2u);
}

TEST(BinaryCif, GzipIsReadToo) {
  TempFolder folder;
  writeGzip(folder / "a.bcif.gz", packed(small()));
  EXPECT_EQ(readModelOf(folder / "a.bcif.gz").instances.size(), 4u);
}

/// What one column of _entity.formula_weight decodes to.
std::vector<double> decoded(const Json& data, int rows) {
  std::vector<CifBlock> blocks = parseBinaryCif(
      packed(file(Json::array({category("_entity", rows, Json::array({column("formula_weight", data)}))}))), "a.bcif");
  const CifColumn& of = blocks.at(0).tables.at("entity").columns.at("formula_weight");
  std::vector<double> values;
  for (std::size_t i = 0; i < of.size(); ++i) values.push_back(of.number(i));
  return values;
}
Json encoded(Json bytes, std::initializer_list<Json> encodings) {
  return {{"data", std::move(bytes)}, {"encoding", Json(encodings)}};
}

TEST(BinaryCif, EveryEncodingIsUndone) {
  using V = std::vector<double>;
  EXPECT_EQ(decoded(encoded(bytesOf<std::int8_t>({-1, 2}), {byteArray(1)}), 2), (V{-1, 2}));
  EXPECT_EQ(decoded(encoded(bytesOf<std::int16_t>({-300, 2}), {byteArray(2)}), 2), (V{-300, 2}));
  EXPECT_EQ(decoded(encoded(bytesOf<std::uint8_t>({255, 2}), {byteArray(4)}), 2), (V{255, 2}));
  EXPECT_EQ(decoded(encoded(bytesOf<std::uint16_t>({65535}), {byteArray(5)}), 1), (V{65535}));
  EXPECT_EQ(decoded(encoded(bytesOf<std::uint32_t>({70000}), {byteArray(6)}), 1), (V{70000}));
  EXPECT_EQ(decoded(encoded(bytesOf<double>({0.1}), {byteArray(33)}), 1), (V{0.1}));
  EXPECT_EQ(
      decoded(encoded(bytesOf<std::int32_t>({25, -5}), {{{"kind", "FixedPoint"}, {"factor", 10}}, byteArray(3)}), 2),
      (V{2.5, -0.5}));
  EXPECT_EQ(
      decoded(encoded(bytesOf<std::int32_t>({0, 4}),
                      {{{"kind", "IntervalQuantization"}, {"min", 1}, {"max", 3}, {"numSteps", 5}}, byteArray(3)}),
              2),
      (V{1, 3}));
  EXPECT_EQ(
      decoded(encoded(bytesOf<std::int32_t>({7, 3, 9, 1}), {{{"kind", "RunLength"}, {"srcSize", 4}}, byteArray(3)}), 4),
      (V{7, 7, 7, 9}));
  EXPECT_EQ(
      decoded(encoded(bytesOf<std::int32_t>({0, 1, -3}), {{{"kind", "Delta"}, {"origin", 100}}, byteArray(3)}), 3),
      (V{100, 101, 98}));
  Json packing = {{"kind", "IntegerPacking"}, {"byteCount", 1}, {"isUnsigned", false}, {"srcSize", 3}};
  EXPECT_EQ(decoded(encoded(bytesOf<std::int8_t>({127, 1, -128, -2, 5}), {packing, byteArray(1)}), 3),
            (V{128, -130, 5}));
  EXPECT_EQ(decoded(encoded(bytesOf<std::int8_t>({127, 0}), {packing, byteArray(1)}), 1), (V{127}));
  packing["isUnsigned"] = true;
  EXPECT_EQ(decoded(encoded(bytesOf<std::uint8_t>({255, 255, 1}), {packing, byteArray(4)}), 1), (V{511}));
  packing["byteCount"] = 2;
  EXPECT_EQ(decoded(encoded(bytesOf<std::uint16_t>({65535, 2}), {packing, byteArray(5)}), 1), (V{65537}));
}

TEST(BinaryCif, EncodingsThatPromiseTooMuchAreRefused) {
  auto growth = peakGrowth([] {
    for (const Json& data :
         {encoded(bytesOf<std::int32_t>({7, 2000000000}), {{{"kind", "RunLength"}}, byteArray(3)}),
          encoded(bytesOf<std::int32_t>({7, -1}), {{{"kind", "RunLength"}}, byteArray(3)}),
          encoded(bytesOf<std::int8_t>({127}), {{{"kind", "IntegerPacking"}, {"byteCount", 1}}, byteArray(1)}),
          encoded(bytesOf<std::int32_t>({2000000000, 2000000000}), {{{"kind", "Delta"}, {"origin", 0}}, byteArray(3)}),
          encoded(bytesOf<std::int32_t>({1, 2}), {{{"kind", "FixedPoint"}, {"factor", 0}}, byteArray(3)}),
          encoded(bytesOf<std::int32_t>({1, 2}), {{{"kind", "Strange"}}, byteArray(3)}),
          encoded(bytesOf<std::int32_t>({1, 2}), {byteArray(77)}),
          encoded(bytesOf<std::int32_t>({1, 2, 3}), {byteArray(3)}),
          encoded(bytesOf<std::uint32_t>({4000000000u, 1}), {byteArray(6)}), encoded(Json(5), {byteArray(3)}),
          texts("abc", {0, 4}, {0, 0}), texts("abc", {2, 1}, {0, 0}), texts("abc", {0, 3}, {0, 1}),
          texts("abc", {0, 3}, {-2, 0})})
      EXPECT_THROW(decoded(data, 2), InputError) << data.dump();
    for (double rows : {1e9, 4e18, -1.0})
      EXPECT_THROW(
          parseBinaryCif(
              packed(file(Json::array({{{"name", "_entity"}, {"rowCount", rows}, {"columns", Json::array()}}}))),
              "a.bcif"),
          InputError);
  });
  EXPECT_LT(growth, std::size_t(32) << 20);
}

TEST(BinaryCif, DeepNestingIsRefused) {
  std::string bytes =
      "\x81\xaa"
      "dataBlocks" +
      std::string(3000000, '\x91') + '\xc0';
  TempFolder folder;
  writeText(folder / "a.bcif", bytes);
  expectClearRefusal(folder / "a.bcif");
}

TEST(BinaryCif, EveryCutIsRefusedAndDamageReadOrRefused) {
  TempFolder folder;
  std::string good = packed(small());
  for (std::size_t length = 0; length < good.size(); length += 7) {
    writeText(folder / "a.bcif", good.substr(0, length));
    expectClearRefusal(folder / "a.bcif");
  }
  auto growth =
      peakGrowth([&] { expectReadOrRefused(good, folder / "a.bcif", 1000, [&] { readModelOf(folder / "a.bcif"); }); });
  EXPECT_LT(growth, std::size_t(64) << 20);
}

const char kText[] = R"(# a comment
data_1ABC
_struct.title 'A capsid'
loop_
_entity.id
_entity.type
_entity.pdbx_description
1 polymer 'coat protein'
2 water water
loop_
_atom_site.group_PDB
_atom_site.type_symbol
_atom_site.label_asym_id
_atom_site.label_entity_id
_atom_site.label_comp_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
_atom_site.pdbx_PDB_model_num
ATOM C 1E5 1 ALA 1.0 0 0 1
ATOM N 1E5 1 ALA 2.0(3) 0 0 1
ATOM C B 1 ALA 3.0 0 0 1
HETATM O W 2 HOH 9 9 9 1
loop_
_pdbx_struct_assembly_gen.assembly_id
_pdbx_struct_assembly_gen.oper_expression
_pdbx_struct_assembly_gen.asym_id_list
1 '(1,2)(3-4)' 1E5,W
1 X B
2 1 B
loop_
_pdbx_struct_oper_list.id
_pdbx_struct_oper_list.matrix[1][1]
_pdbx_struct_oper_list.matrix[1][2]
_pdbx_struct_oper_list.matrix[1][3]
_pdbx_struct_oper_list.vector[1]
_pdbx_struct_oper_list.matrix[2][1]
_pdbx_struct_oper_list.matrix[2][2]
_pdbx_struct_oper_list.matrix[2][3]
_pdbx_struct_oper_list.vector[2]
_pdbx_struct_oper_list.matrix[3][1]
_pdbx_struct_oper_list.matrix[3][2]
_pdbx_struct_oper_list.matrix[3][3]
_pdbx_struct_oper_list.vector[3]
1 1 0 0 0 0 1 0 0 0 0 1 0
2 0 -1 0 0 1 0 0 0 0 0 1 0
3 1 0 0 100 0 1 0 0 0 0 1 0
4 1 0 0 200 0 1 0 0 0 0 1 0
X 1 0 0 0 0 1 0 7 0 0 1 0
)";

TEST(CifText, TheBiologicalAssemblyIsBuilt) {
  Model model = readBytes(kText, "1abc.cif");
  EXPECT_EQ(model.name, "A capsid");
  ASSERT_EQ(model.types.size(), 1u) << "water is left out";
  EXPECT_EQ(model.types[0].name, "coat protein");
  ASSERT_EQ(model.types[0].moleculeCount, 2u) << "two chains, of which one has a name like a number";
  ASSERT_EQ(model.molecules[0].instanceCount, 4u);
  ASSERT_EQ(model.molecules[1].instanceCount, 1u);
  EXPECT_EQ(model.molecules[0].atoms[1].position.x, 2.0f);
  // The right operator comes first: moved along x, then turned to y.
  glm::vec3 p = model.instances[2].position;
  EXPECT_NEAR(glm::length(p - glm::vec3(0, 100, 0)), 0.0f, 1e-4f);
  EXPECT_EQ(model.instances[4].position, glm::vec3(0, 7, 0));
}

TEST(CifText, DamageIsReadOrRefused) {
  TempFolder folder;
  auto growth =
      peakGrowth([&] { expectReadOrRefused(kText, folder / "a.cif", 1000, [&] { readModelOf(folder / "a.cif"); }); });
  EXPECT_LT(growth, std::size_t(64) << 20);
}

TEST(CifText, ExpressionsThatNameMillionsAreRefused) {
  TempFolder folder;
  std::string list;
  for (int i = 0; i < 3000; ++i) list += "1-4,";
  for (std::string expression : {"(" + list + "1)(" + list + "1)", std::string("(1-4"), std::string("5"),
                                 std::string("(1)(1)(1)(1)(1)"), std::string("1-2-3")}) {
    std::string text = kText;
    text.replace(text.find("'(1,2)(3-4)'"), 12, "'" + expression + "'");
    writeText(folder / "a.cif", text);
    expectClearRefusal(folder / "a.cif");
  }
  std::string text = kText;
  text.replace(text.find("'(1,2)(3-4)'"), 12, "(1-4000000000000)");
  EXPECT_EQ(readBytes(text, "a.cif").molecules[0].instanceCount, 4u) << "as many as there are";
  text = kText;
  text.replace(text.find("2 0 -1 0 0 1"), 12, "2 0 +1 0 0 1");
  writeText(folder / "a.cif", text);
  expectClearRefusal(folder / "a.cif");
}

}  // namespace
}  // namespace velum::io
