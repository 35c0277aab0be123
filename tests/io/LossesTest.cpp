#include <functional>
#include <limits>

#include "TestFiles.h"
#include "io/looks/TransferFile.h"
#include "io/meshes/ReadMesh.h"
#include "io/meshes/WriteMesh.h"

/// What writers cannot keep they say.
namespace velum::io {
namespace {

using Lines = std::vector<std::string>;

bool says(const Lines& lines, const std::string& word) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(word) != std::string::npos; });
}

Lines writeTo(const Volume& v, const std::filesystem::path& path) {
  Progress progress;
  return writeVolume(v, path, progress);
}

/// Of the name that its file has, with nothing that a format could lack.
Volume plainVolume(SampleType type = SampleType::Int16, int channels = 1) {
  Volume v = rampVolume(type, {9, 8, 7}, channels);
  v.worldFromVoxel = obliqueMatrix(false, false);
  v.worldFromVoxel[3] = glm::dvec4(-30, 20, 10, 1);
  v.name = "a";
  computeRange(v);
  return v;
}

constexpr const char* kFormats[] = {"a.nrrd", "a.nii", "a.nii.gz", "a.vti", "a.vdb"};

TEST(Losses, APlainVolumeHasNone) {
  TempFolder folder;
  for (const char* name : kFormats) {
    Lines lines = writeTo(plainVolume(), folder / name);
    EXPECT_TRUE(lines.empty()) << name << ": " << lines[0];
  }
}

struct Field {
  const char* word;  ///< That a line has where it is lost.
  std::function<void(Volume&)> set;
  std::function<bool(const Volume& wanted, const Volume& got)> isKept;
};

bool samePlace(const Volume& a, const Volume& b, double voxels) {
  double inMm = glm::length(
      glm::dvec3((worldFromVoxelIn(LengthUnit::Millimetre, a) - worldFromVoxelIn(LengthUnit::Millimetre, b)) *
                 glm::dvec4(8, 7, 6, 1)));
  return inMm < voxels * spacingOf(a).x * millimetresPer(a.lengthUnit);
}

bool sameValues(const Volume& a, const Volume& b) {
  for (int z = 0; z < a.dims.z; ++z)
    for (int y = 0; y < a.dims.y; ++y)
      for (int x = 0; x < a.dims.x; ++x)
        for (int c = 0; c < a.channels; ++c) {
          double wanted = valueAt(a, {x, y, z}, c), got = valueAt(b, {x, y, z}, c);
          if (wanted != got && !(std::isnan(wanted) && std::isnan(got))) return false;
        }
  return true;
}

std::vector<Field> fieldsOfVolumes() {
  auto same = [](auto member) { return [member](const Volume& a, const Volume& b) { return a.*member == b.*member; }; };
  return {
      {"name", [](Volume& v) { v.name = "of\nthe \\scanner"; }, same(&Volume::name)},
      {"unit", [](Volume& v) { v.unit = "Bq/ml \xc2\xb5"; }, same(&Volume::unit)},
      {"PET", [](Volume& v) { v.modality = Modality::PET; }, same(&Volume::modality)},
      {"spacing", [](Volume& v) { v.isSpacingKnown = false; }, same(&Volume::isSpacingKnown)},
      {"orientation", [](Volume& v) { v.isOrientationKnown = false; }, same(&Volume::isOrientationKnown)},
      {"both", [](Volume& v) { v.isSpacingKnown = v.isOrientationKnown = false; },
       [](const Volume&, const Volume& b) { return !b.isSpacingKnown && !b.isOrientationKnown; }},
      {"angstrom", [](Volume& v) { v.lengthUnit = LengthUnit::Angstrom; }, same(&Volume::lengthUnit)},
      {"angstrom", [](Volume& v) { v.lengthUnit = LengthUnit::Angstrom; },
       [](const Volume& a, const Volume& b) { return samePlace(a, b, 1e-4); }},
      {"voxels off", [](Volume& v) { v.worldFromVoxel[3] = glm::dvec4(1e8, 1.0 / 3, 0, 1); },
       [](const Volume& a, const Volume& b) { return samePlace(a, b, 1e-2); }},
      {"scale", [](Volume& v) { v.scale = 0.1, v.offset = 1.0 / 3; }, sameValues},
      {"channel", [](Volume& v) { v.channelNames = {"DAPI"}; }, same(&Volume::channelNames)},
  };
}

TEST(Losses, EveryFieldIsKeptOrSaid) {
  TempFolder folder;
  for (const char* name : kFormats)
    for (const Field& field : fieldsOfVolumes()) {
      Volume v = plainVolume();
      field.set(v);
      computeRange(v);
      Lines lines = writeTo(v, folder / name);
      bool isKept = field.isKept(v, read(folder / name));
      EXPECT_TRUE(isKept || says(lines, field.word)) << name << ", " << field.word;
    }
}

TEST(Losses, OnlyOursReadAScaleOfFormatsWithoutOne) {
  TempFolder folder;
  Volume v = plainVolume();
  v.scale = 0.5, v.offset = 3;
  computeRange(v);
  for (const char* name : {"a.nrrd", "a.vti"}) EXPECT_TRUE(says(writeTo(v, folder / name), "0.5 times one plus 3"));
  for (const char* name : {"a.nii", "a.vdb"}) EXPECT_TRUE(writeTo(v, folder / name).empty()) << name;
}

TEST(Losses, ColoursAndNamesOfChannelsAreKeptOrSaid) {
  TempFolder folder;
  for (const char* name : {"a.nrrd", "a.nii", "a.vti"})
    for (SampleType type : {SampleType::UInt8, SampleType::UInt16})
      for (bool isColor : {false, true}) {
        Volume v = plainVolume(type, 3);
        v.isColor = isColor;
        v.channelNames = {"red <&> \"dye\"", "green", "blue"};
        Lines lines = writeTo(v, folder / name);
        Volume back = read(folder / name);
        EXPECT_TRUE(sameValues(v, back)) << name;
        EXPECT_TRUE(back.isColor == isColor || says(lines, "colours")) << name << enumName(type) << isColor;
        EXPECT_TRUE(back.channelNames == v.channelNames || says(lines, "names of channels")) << name;
      }
}

TEST(Losses, NiftiIsInMicrometresWhereItIsInAngstrom) {
  TempFolder folder;
  Volume v = plainVolume();
  v.lengthUnit = LengthUnit::Angstrom;
  writeTo(v, folder / "a.nii");
  std::string bytes = bytesOf(folder / "a.nii");
  EXPECT_EQ(bytes[123], 3 | 8);
  float spacing;
  std::memcpy(&spacing, bytes.data() + 80, 4);
  EXPECT_FLOAT_EQ(spacing, float(spacingOf(v).x * 1e-4));
  v.lengthUnit = LengthUnit::Millimetre;
  v.isSpacingKnown = false;
  writeTo(v, folder / "a.nii");
  EXPECT_EQ(bytesOf(folder / "a.nii")[123], 8) << "a length of no unit";
}

template <class T>
Volume volumeOfNumbers(SampleType type, const std::vector<T>& numbers) {
  Volume v = plainVolume(type);
  auto* samples = reinterpret_cast<T*>(v.voxels.data());
  for (std::size_t i = 0; i < voxelCount(v); ++i) samples[i] = numbers[i % numbers.size()];
  computeRange(v);
  return v;
}

TEST(VdbWriter, EveryNumberIsKeptInDoublesWhereFloatsDoNotHoldIt) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  TempFolder folder;
  struct Case {
    Volume v;
    SampleType type;
  };
  Volume scaled = plainVolume();
  scaled.scale = 0.1;
  computeRange(scaled);
  const Case cases[] = {
      {volumeOfNumbers<double>(SampleType::Float64, {0.5, -3, 1e10, 0}), SampleType::Float32},
      {volumeOfNumbers<double>(SampleType::Float64, {0.5, 1.0 / 3}), SampleType::Float64},
      {volumeOfNumbers<double>(SampleType::Float64, {1e300, -kInf, kInf, 0}), SampleType::Float64},
      {volumeOfNumbers<std::uint32_t>(SampleType::UInt32, {0, 16777216, 4294967040u}), SampleType::Float32},
      {volumeOfNumbers<std::uint32_t>(SampleType::UInt32, {0, 16777217, 4294967295u}), SampleType::Float64},
      {volumeOfNumbers<std::int32_t>(SampleType::Int32, {-16777217, 5}), SampleType::Float64},
      {volumeOfNumbers<float>(SampleType::Float32, {0.1f, -7, float(kInf)}), SampleType::Float32},
      {scaled, SampleType::Float64},
  };
  for (const Case& c : cases) {
    EXPECT_TRUE(writeTo(c.v, folder / "a.vdb").empty());
    Volume back = read(folder / "a.vdb");
    EXPECT_EQ(back.type, c.type);
    EXPECT_TRUE(sameValues(c.v, back));
  }
}

TEST(VdbWriter, VoxelsThatAreNoNumbersStay) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  TempFolder folder;
  // Alone in a block of equal values, in a block of their own, and in all of the volume.
  for (std::size_t lone : {std::size_t(0), std::size_t(300)}) {
    Volume v = volumeOfNumbers<float>(SampleType::Float32, {5});
    reinterpret_cast<float*>(v.voxels.data())[lone] = kNan;
    writeTo(v, folder / "a.vdb");
    EXPECT_TRUE(sameValues(v, read(folder / "a.vdb"))) << lone;
  }
  Volume mixed = volumeOfNumbers<float>(SampleType::Float32, {5, kNan, 7});
  writeTo(mixed, folder / "a.vdb");
  EXPECT_TRUE(sameValues(mixed, read(folder / "a.vdb")));
  Volume none = volumeOfNumbers<double>(SampleType::Float64, {double(kNan)});
  writeTo(none, folder / "a.vdb");
  EXPECT_TRUE(sameValues(none, read(folder / "a.vdb")));
}

LabelVolume someLabels() {
  LabelVolume labels({4, 4, 4}, glm::dmat4(1.0));
  labels.write({0, 0, 0}, {2, 1, 1}, std::vector<std::uint16_t>{3, 7});
  labels.table = {{3, "liver", {0.25f, 0.5f, 0.75f}, 0.5f}, {7, "spleen", {1, 0, 0}, 1.0f}};
  labels.name = "a";
  return labels;
}

TEST(Losses, LabelsKeepNamesColoursAndOpacities) {
  TempFolder folder;
  Progress progress;
  for (const char* name : {"a.seg.nrrd", "a.nrrd", "a.nii", "a.nii.gz"}) {
    Lines lines = writeLabels(someLabels(), folder / name, progress);
    EXPECT_TRUE(lines.empty()) << name << ": " << lines[0];
    EXPECT_EQ(readLabelsOf(folder / name).table, someLabels().table) << name;
  }
}

TEST(Losses, NamesOfLabelsThatDoNotFitAreSaid) {
  TempFolder folder;
  Progress progress;
  LabelVolume labels = someLabels();
  labels.table[0].name = "left]]>liver";
  EXPECT_TRUE(says(writeLabels(labels, folder / "a.nii", progress), "1 name of a structure is"));
  EXPECT_TRUE(writeLabels(labels, folder / "a.seg.nrrd", progress).empty());
  EXPECT_EQ(readLabelsOf(folder / "a.seg.nrrd").table[0].name, "left]]>liver");
  labels.table[1].name = "two\nlines";
  EXPECT_TRUE(says(writeLabels(labels, folder / "a.seg.nrrd", progress), "1 name of a structure is"));
  labels.name = "of somebody";
  EXPECT_TRUE(says(writeLabels(labels, folder / "a.nii", progress), "of somebody"));
}

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (glm::vec3 p : mesh.positions) mesh.normals.push_back(glm::normalize(p - 0.25f));
  mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  mesh.name = "sheet\nof mine";
  return mesh;
}

TEST(Losses, SurfacesSayWhatHappensToTheirNormals) {
  TempFolder folder;
  Mesh mesh = tetrahedron();
  Progress progress;
  for (const char* name : {"a.obj", "a.ply", "a.vtp", "a.stl"}) {
    Lines lines = writeMesh(mesh, folder / name);
    Mesh back = readMesh(folder / name, progress);
    EXPECT_EQ(back.indices.size(), mesh.indices.size()) << name;
    bool isKept = back.normals.size() == mesh.normals.size();
    for (std::size_t i = 0; isKept && i < back.normals.size(); ++i)
      isKept = glm::distance(back.normals[i], mesh.normals[i]) < 1e-6f;
    EXPECT_TRUE(isKept || says(lines, "normals")) << name;
    // Of .vtp the text itself is coded.
    const char* wanted = std::string_view(name) == "a.vtp" ? "Name=\"name\"" : "sheet of mine";
    EXPECT_NE(bytesOf(folder / name).find(wanted), std::string::npos) << name << " holds the name";
  }
  mesh.normals.clear();
  EXPECT_TRUE(writeMesh(mesh, folder / "a.stl").empty());
}

scene::TransferFunction someTransfer() {
  scene::TransferFunction transfer;
  transfer.colors = {{-100, {0.1f, 0.2f, 0.3f}}, {300.5, {1, 0.5f, 0}}};
  transfer.opacities = {{-50, 0}, {120.123456789, 1.0 / 3}, {900, 1}};
  return transfer;
}

scene::Lighting slicersLight() {
  scene::Lighting light;
  light.shadow = light.occlusion = 0;
  light.keyDirection = scene::Lighting().keyDirection;
  return light;
}

TEST(Losses, LooksOfSlicerSayWhatTheyHaveNoPlaceFor) {
  for (TransferKind kind : {TransferKind::SlicerText, TransferKind::SlicerJson}) {
    auto losses = [&](const scene::TransferFunction& transfer, const scene::Lighting& light) {
      return transferText(transfer, kind, light, 1.0).losses;
    };
    EXPECT_TRUE(losses(someTransfer(), slicersLight()).empty());
    EXPECT_EQ(parseTransfer(transferText(someTransfer(), kind, slicersLight(), 1.0).text, kind).transfer,
              someTransfer());
    auto transfer = someTransfer();
    transfer.preset = "ct-bone";
    EXPECT_TRUE(says(losses(transfer, slicersLight()), "ct-bone"));
    scene::Lighting light = slicersLight();
    light.ambient = 1.5;
    EXPECT_TRUE(says(losses(someTransfer(), light), "ambient light of 1.5"));
    light = slicersLight();
    light.shadow = 0.5;
    EXPECT_TRUE(says(losses(someTransfer(), light), "shadows"));
    light.shaded = false;
    EXPECT_TRUE(losses(someTransfer(), light).empty());
    light = slicersLight();
    light.keyDirection = {0, 0, 1};
    EXPECT_TRUE(says(losses(someTransfer(), light), "direction"));
  }
  auto thick = someTransfer();
  thick.unitDistance = 2;
  EXPECT_TRUE(says(transferText(thick, TransferKind::SlicerText, slicersLight(), 1.0).losses, "1 mm"));
  EXPECT_TRUE(transferText(thick, TransferKind::SlicerJson, slicersLight(), 1.0).losses.empty());
  for (int i = 0; i < 50; ++i) thick.opacities.push_back({1000 + i / 3.0, 0.5});
  EXPECT_TRUE(says(transferText(thick, TransferKind::SlicerText, slicersLight(), 1.0).losses, "six digits"));
  EXPECT_TRUE(transferText(someTransfer(), TransferKind::Velum, {}, 1.0).losses.empty());
}

TEST(Losses, LooksOfSlicerSayWhatIsNotTakenOver) {
  auto file = parseTransfer(
      R"({"volumeProperties": [{"components": [{"lighting": {"ambient": 1}, "scalarOpacity": {"points": [
      {"x": 0, "y": 0, "midpoint": 0.3, "sharpness": 0.5}, {"x": 1, "y": 1}]}}, {}]}, {}]})",
      TransferKind::SlicerJson);
  for (const char* word : {"2 properties", "2 components", "1 bent", "light"})
    EXPECT_TRUE(says(file.warnings, word)) << word;
}

}  // namespace
}  // namespace velum::io
