// Tables of measures as files.
#include "session/measure/Table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "MeasureGrids.h"

namespace velum::session {
namespace {

/// The fields of each record of CSV, by RFC 4180.
std::vector<std::vector<std::string>> recordsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> records(1, std::vector<std::string>(1));
  bool isQuoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& field = records.back().back();
    if (isQuoted && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
      field += csv[++i];
    else if (csv[i] == '"')
      isQuoted = !isQuoted;
    else if (!isQuoted && csv[i] == ',')
      records.back().emplace_back();
    else if (!isQuoted && csv[i] == '\r')
      records.emplace_back(1), ++i;
    else
      field += csv[i];
  }
  records.pop_back();
  return records;
}

scene::Scene tableScene() {
  scene::Scene scene = sceneOfBall(measureGrids()[1], 13.0);
  glm::dmat4 frame = frameOf(measureGrids()[1]);
  Volume volume = makeVolume(
      dimsOf(measureGrids()[1]), SampleType::Int16, [](glm::ivec3 v) { return v.x + v.y; }, frame);
  volume.unit = "a,\"b\"";
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.labels.structures[0].name = "ball, \"left\"\nhalf";
  scene::addCut(scene, cutAt(scene::CutShape::Plane, {0, 0, 0}, {0, 0, 1}));
  auto& marks = scene.lettering.marks;
  scene::addMark(marks, markOf(scene::MarkKind::Distance, {{0, 0, 0}, {3, 4, 0}}));
  scene::Mark circle = markOf(scene::MarkKind::Circle, {{0, 0, 0}, {5, 0, 0}});
  circle.text = "Stra\u00dfe; \"x\"", circle.timeStep = 2;
  scene::addMark(marks, circle);
  scene::addMark(marks, markOf(scene::MarkKind::Profile, {{0, 0, 0}, {90, 0, 0}}));
  scene::addMark(marks, markOf(scene::MarkKind::Circle, {{500, 0, 0}, {505, 0, 0}}));
  scene::Mark region = markOf(scene::MarkKind::Region, {});
  region.structure = 1;
  scene::addMark(marks, region);
  return scene;
}

std::vector<MeasureRow> rowsOf(const scene::Scene& scene) {
  Progress progress;
  return measureAll(scene, {true, true, true}, progress);
}

TEST(MeasureTable, CsvHasALineForEachThingAndAllOfItsNumbers) {
  auto rows = rowsOf(tableScene());
  ASSERT_EQ(rows.size(), 5u + 1 + 1);
  auto records = recordsOf(tableCsv(rows));
  ASSERT_EQ(records.size(), rows.size() + 1);
  for (const auto& record : records) EXPECT_EQ(record.size(), records[0].size());
  auto field = [&](std::size_t row, const std::string& name) {
    auto column = std::find(records[0].begin(), records[0].end(), name);
    EXPECT_NE(column, records[0].end()) << name;
    return records[row + 1][std::size_t(column - records[0].begin())];
  };
  EXPECT_EQ(field(0, "id"), "1");
  EXPECT_EQ(field(0, "kind"), "distance");
  EXPECT_EQ(field(0, "value"), "5.00");
  EXPECT_EQ(field(0, "unit"), "mm");
  EXPECT_EQ(field(0, "points"), "0 0 0; 3 4 0");
  EXPECT_EQ(field(1, "name"), "Stra\u00dfe; \"x\"");
  EXPECT_EQ(field(1, "time step"), "2");
  EXPECT_EQ(field(1, "values unit"), "a,\"b\"");
  EXPECT_EQ(field(1, "value"), "");
  EXPECT_NEAR(std::stod(field(1, "mean")), findQuantity(rows[1].measured, "mean")->value, 0.01);
  EXPECT_NE(field(3, "problem"), "");
  EXPECT_EQ(field(4, "name"), "ball, \"left\"\nhalf");
  // A region of the structure is the structure.
  EXPECT_EQ(field(5, "kind"), "structure");
  for (const char* name : {"value", "unit", "share", "surface", "voxels", "mean", "structure"})
    EXPECT_EQ(field(4, name), field(5, name)) << name;
  EXPECT_NEAR(std::stod(field(5, "share")), 50.0, 0.5);
  EXPECT_EQ(field(6, "kind"), "face");
  EXPECT_EQ(field(6, "id"), "1");
  EXPECT_NEAR(std::stod(field(6, "value")), M_PI * 169.0, 0.01 * M_PI * 169.0);
}

TEST(MeasureTable, JsonSaysTheSame) {
  auto rows = rowsOf(tableScene());
  auto json = nlohmann::json::parse(tableJson(rows, LengthUnit::Millimetre));
  EXPECT_EQ(json["unit"], "mm");
  ASSERT_EQ(json["marks"].size(), 5u);
  EXPECT_EQ(json["marks"][0]["length"]["value"], 5.0);
  EXPECT_EQ(json["marks"][0]["text"], "5.0 mm");
  EXPECT_EQ(json["marks"][2]["profile"].size(), rows[2].measured.profile.size());
  EXPECT_TRUE(json["marks"][2]["profile"].back()["value"].is_null());
  EXPECT_TRUE(json["marks"][3].contains("problem"));
  EXPECT_EQ(json["structures"][0]["volume"], json["marks"][4]["volume"]);
  EXPECT_EQ(json["faces"].size(), 1u);
}

TEST(MeasureTable, ProfilesHaveTheirSamples) {
  auto rows = rowsOf(tableScene());
  auto records = recordsOf(profilesCsv(rows));
  ASSERT_EQ(records.size(), rows[2].measured.profile.size() + 1);
  EXPECT_EQ(records[1][0], "3");
  EXPECT_NEAR(std::stod(records[2][1]), rows[2].measured.profile[1].distance, 1e-6);
  EXPECT_EQ(records.back().back(), "");  // outside of the volume
}

}  // namespace
}  // namespace velum::session
