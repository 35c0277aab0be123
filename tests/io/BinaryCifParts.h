#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

/// What files of BinaryCIF are made of, and a small one.
namespace velum::io::binaryCif {

using Json = nlohmann::json;

template <class T>
inline Json bytesOf(std::vector<T> values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return Json::binary(bytes);
}
inline Json byteArray(int type) { return {{"kind", "ByteArray"}, {"type", type}}; }
inline Json numbers(const std::vector<float>& values) {
  return {{"data", bytesOf(values)}, {"encoding", Json::array({byteArray(32)})}};
}
inline Json integers(const std::vector<std::int32_t>& values) {
  return {{"data", bytesOf(values)}, {"encoding", Json::array({byteArray(3)})}};
}
inline Json texts(const std::string& all, const std::vector<std::int32_t>& offsets,
                  const std::vector<std::int32_t>& indices) {
  Json plain = Json::array({byteArray(3)});
  return {{"data", bytesOf(indices)},
          {"encoding", Json::array({{{"kind", "StringArray"},
                                     {"stringData", all},
                                     {"offsets", bytesOf(offsets)},
                                     {"offsetEncoding", plain},
                                     {"dataEncoding", plain}}})}};
}
inline Json column(const char* name, Json data) {
  return {{"name", name}, {"data", std::move(data)}, {"mask", nullptr}};
}
inline Json category(const char* name, int rows, Json columns) {
  return {{"name", name}, {"rowCount", rows}, {"columns", std::move(columns)}};
}
inline Json file(Json categories) {
  return {{"encoder", "a test"},
          {"version", "0.3.0"},
          {"dataBlocks", Json::array({{{"header", "CELLPACK_MODEL"}, {"categories", std::move(categories)}}})}};
}
inline std::string packed(const Json& json) {
  std::vector<std::uint8_t> bytes = Json::to_msgpack(json);
  return {bytes.begin(), bytes.end()};
}

/// Two types: one of two asyms, that stands twice, and two lipids.
inline Json small() {
  std::vector<float> one{1, 1, 1}, zero{0, 0, 0};
  Json matrix = Json::array({column("id", integers({1, 2, 3}))});
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      matrix.push_back(column(fmt::format("matrix[{}][{}]", r + 1, c + 1).c_str(), numbers(r == c ? one : zero)));
  for (int r = 0; r < 3; ++r) matrix.push_back(column(fmt::format("vector[{}]", r + 1).c_str(), numbers({0, 10, 20})));
  return file(Json::array(
      {category("_entity", 2,
                Json::array({column("id", integers({7, 8})),
                             column("pdbx_description",
                                    texts("root.in.proteins.Proot.membrane.outer_membrane", {0, 18, 46}, {0, 1}))})),
       category("_atom_site", 4,
                Json::array({column("Cartn_x", numbers({0, 1, 2, 3})), column("Cartn_y", numbers({0, 0, 0, 0})),
                             column("Cartn_z", numbers({0, 0, 0, 0})),
                             column("type_symbol", texts("CN", {0, 1, 2}, {0, 1, 0, 0})),
                             column("label_asym_id", texts("ABXY", {0, 1, 2, 3, 4}, {0, 1, 2, 3})),
                             column("label_entity_id", integers({7, 7, 8, 8}))})),
       category("_pdbx_struct_assembly_gen", 3,
                Json::array({column("oper_expression", texts("(2-3)(1)(9-8)", {0, 5, 8, 13}, {0, 1, 2})),
                             column("asym_id_list", texts("A,BX,Y,noneX", {0, 3, 11, 12}, {0, 1, 2}))})),
       category("_pdbx_struct_oper_list", 3, matrix)}));
}

}  // namespace velum::io::binaryCif
