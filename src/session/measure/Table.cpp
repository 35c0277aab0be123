#include "session/measure/Table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/Text.h"
#include "scene/Scene.h"
#include "session/measure/Region.h"

namespace velum::session {

namespace {

using Json = nlohmann::ordered_json;

std::string nameOfStructure(const scene::Scene& scene, int id) {
  for (const scene::Structure& structure : scene.labels.structures)
    if (structure.id == id) return structure.name;
  if (scene.labels.data)
    for (const LabelInfo& label : scene.labels.data->table)
      if (label.id == id) return label.name;
  return {};
}

MeasureRow rowOf(const scene::Scene& scene, const scene::Mark& mark, Progress& progress) {
  bool hasStructure = mark.structure != 0;
  std::string name = !mark.text.empty() ? mark.text : hasStructure ? nameOfStructure(scene, mark.structure) : mark.type;
  return {mark.id,     std::string(enumName(mark.kind)), name, mark.structure, mark.timeStep,
          mark.points, measure(scene, mark, progress)};
}

/// What names the row among its quantities: that of a place, not of values.
const Quantity* mainOf(const MeasureRow& row) {
  for (const char* name : {"length", "angle", "area", "volume"})
    if (const Quantity* quantity = findQuantity(row.measured, name)) return quantity;
  return nullptr;
}

std::string pointsText(const std::vector<glm::dvec3>& points) {
  std::string text;
  for (const glm::dvec3& p : points)
    text += fmt::format("{}{:.10g} {:.10g} {:.10g}", text.empty() ? "" : "; ", p.x, p.y, p.z);
  return text;
}

std::string quotedOrEmpty(const std::string& text) { return text.empty() ? text : csvQuoted(text); }

Json placeJson(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
Json placesJson(const std::vector<glm::dvec3>& places) {
  Json json = Json::array();
  for (const glm::dvec3& place : places) json.push_back(placeJson(place));
  return json;
}

Json rowJson(const MeasureRow& row) {
  Json json = {{"id", row.id}, {"kind", row.kind}, {"name", row.name}};
  if (row.structure != 0) json["structure"] = row.structure;
  if (row.timeStep >= 0) json["timeStep"] = row.timeStep;
  if (!row.points.empty()) json["points"] = placesJson(row.points);
  const Measured& measured = row.measured;
  if (!measured.problem.empty()) json["problem"] = measured.problem;
  for (const Quantity& quantity : measured.quantities) {
    json[quantity.name] = {{"value", quantity.value}, {"unit", quantity.unit}};
  }
  if (!measured.text.empty()) json["text"] = measured.text;
  if (!measured.way.empty()) json["way"] = placesJson(measured.way);
  for (const ProfileSample& sample : measured.profile)
    json["profile"].push_back({{"distance", sample.distance},
                               {"place", placeJson(sample.place)},
                               {"value", std::isfinite(sample.value) ? Json(sample.value) : Json()}});
  return json;
}

}  // namespace

std::vector<MeasureRow> measureAll(const scene::Scene& scene, const TableParts& parts, Progress& progress) {
  std::vector<MeasureRow> rows;
  if (parts.marks)
    for (const scene::Mark& mark : scene.lettering.marks) rows.push_back(rowOf(scene, mark, progress));
  std::map<int, StructureLeft> left;
  if (parts.structures || parts.faces) left = measureLeft(scene, 0, progress);
  if (parts.structures)
    for (const auto& [id, part] : left)
      rows.push_back(
          {id, "structure", nameOfStructure(scene, id), id, -1, {}, measureStructure(scene, id, part, progress)});
  if (!parts.faces) return rows;
  Telling telling = tellingOf(scene);
  for (const FaceArea& face : faceAreas(left, 0)) {
    Measured measured;
    measured.quantities = {areaQuantity(telling, face.area)};
    measured.text = quantityText(measured.quantities.front());
    rows.push_back({face.cut, "face", nameOfStructure(scene, face.structure), face.structure, -1, {}, measured});
  }
  return rows;
}

std::string tableCsv(const std::vector<MeasureRow>& rows) {
  std::string csv =
      "id,kind,name,value,unit,share,surface,surface unit,voxels,mean,deviation,least,most,values unit,structure,"
      "time step,points,problem\r\n";
  for (const MeasureRow& row : rows) {
    auto numberOf = [](const Quantity* quantity) { return quantity ? quantityNumber(*quantity) : std::string(); };
    auto find = [&](const char* name) { return findQuantity(row.measured, name); };
    const Quantity *main = mainOf(row), *surface = find("surface"), *most = find("most");
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", row.id, row.kind,
                       quotedOrEmpty(row.name), numberOf(main), main ? main->unit : "", numberOf(find("share")),
                       numberOf(surface), surface ? surface->unit : "", numberOf(find("voxels")),
                       numberOf(find("mean")), numberOf(find("deviation")), numberOf(find("least")), numberOf(most),
                       most ? quotedOrEmpty(most->unit) : "", row.structure != 0 ? fmt::to_string(row.structure) : "",
                       row.timeStep >= 0 ? fmt::to_string(row.timeStep) : "", quotedOrEmpty(pointsText(row.points)),
                       quotedOrEmpty(row.measured.problem));
  }
  return csv;
}

std::string tableJson(const std::vector<MeasureRow>& rows, LengthUnit unit) {
  Json json = {{"unit", std::string(enumName(unit))},
               {"marks", Json::array()},
               {"structures", Json::array()},
               {"faces", Json::array()}};
  for (const MeasureRow& row : rows)
    json[row.kind == "structure" ? "structures" : row.kind == "face" ? "faces" : "marks"].push_back(rowJson(row));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string profilesCsv(const std::vector<MeasureRow>& rows) {
  std::string csv = "mark,distance,x,y,z,value\r\n";
  for (const MeasureRow& row : rows)
    for (const ProfileSample& s : row.measured.profile)
      csv += fmt::format("{},{:.9g},{:.10g},{:.10g},{:.10g},{}\r\n", row.id, s.distance, s.place.x, s.place.y,
                         s.place.z, std::isfinite(s.value) ? fmt::format("{:.9g}", s.value) : "");
  return csv;
}

}  // namespace velum::session
