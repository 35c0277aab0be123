// fuzz-seeds FOLDER: sound files for each fuzz target to begin with, in a folder of its name: corners of phantoms.
#include <cstdio>
#include <fstream>

#include "../io/BinaryCifParts.h"
#include "../io/SegyBytes.h"
#include "../support/DicomParts.h"
#include "SourceSeeds.h"
#include "StoreSeeds.h"
#include "core/Error.h"
#include "core/ModelBuilder.h"
#include "io/images/ImageFile.h"
#include "io/labels/WriteLabels.h"
#include "io/looks/TransferFile.h"
#include "io/meshes/WriteMesh.h"
#include "io/models/WriteModel.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "scene/Presets.h"
#include "scene/json/ChangeLog.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"

namespace velum::io {
namespace {

using Path = std::filesystem::path;
constexpr glm::ivec3 kDims{5, 4, 3};

Path root;

/// Makes room for a target's file.
Path seed(const std::string& target, const std::string& name) {
  std::filesystem::create_directories(root / target);
  return root / target / name;
}

std::string bytesOf(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& target, const std::string& name, const std::string& bytes) {
  std::ofstream(seed(target, name), std::ios::binary) << bytes;
}

/// Bytes of a number, as the machine has them or the other way round.
template <class T>
std::string bytesOf(T number, bool isTurned = false) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof(T));
  if (isTurned) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Voxels from the middle.
Volume middleOf(Volume v) {
  std::size_t voxel = sampleSize(v.type) * std::size_t(v.channels);
  glm::ivec3 dims = glm::min(v.dims, kDims), at = (v.dims - dims) / 2;
  Bytes kept;
  for (int t = 0; t < v.timeSteps; ++t)
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y) {
        auto row = (std::size_t(at.z + z) * std::size_t(v.dims.y) + std::size_t(at.y + y)) * std::size_t(v.dims.x);
        auto from =
            v.voxels.begin() + std::ptrdiff_t(timeStepBytes(v) * std::size_t(t) + (row + std::size_t(at.x)) * voxel);
        kept.insert(kept.end(), from, from + std::ptrdiff_t(voxel * std::size_t(dims.x)));
      }
  v.voxels = std::move(kept);
  v.dims = dims;
  return v;
}

LabelVolume middleOf(const LabelVolume& from) {
  glm::ivec3 dims = glm::min(from.dims(), kDims);
  std::vector<std::uint16_t> ids(std::size_t(dims.x * dims.y * dims.z));
  from.read((from.dims() - dims) / 2, dims, ids);
  LabelVolume labels(dims, from.worldFromVoxel());
  labels.write(glm::ivec3(0), dims, ids);
  labels.table = from.table;
  return labels;
}

std::string samplesOf(const Volume& v) { return {reinterpret_cast<const char*>(v.voxels.data()), v.voxels.size()}; }

// Formats without a writer of ours.

std::string metaImage(const Volume& v) {
  const char* types[] = {"MET_UCHAR", "MET_CHAR", "MET_USHORT", "MET_SHORT",
                         "MET_UINT",  "MET_INT",  "MET_FLOAT",  "MET_DOUBLE"};
  return fmt::format(
             "ObjectType = Image\nNDims = 3\nDimSize = {} {} {}\nElementSpacing = 1 2 3\nOffset = 4 5 6\n"
             "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nElementNumberOfChannels = {}\nBinaryDataByteOrderMSB = False\n"
             "ElementType = {}\nElementDataFile = LOCAL\n",
             v.dims.x, v.dims.y, v.dims.z, v.channels, types[static_cast<int>(v.type)]) +
         samplesOf(v);
}

std::string vtkLegacy(const Volume& v, bool isText) {
  const char* types[] = {"unsigned_char", "char", "unsigned_short", "short", "unsigned_int", "int", "float", "double"};
  std::string head = fmt::format(
      "# vtk DataFile Version 3.0\na phantom\n{}\nDATASET STRUCTURED_POINTS\nDIMENSIONS {} {} {}\nORIGIN 1 2 3\n"
      "SPACING 0.5 1 2\nPOINT_DATA {}\nSCALARS s {} {}\nLOOKUP_TABLE default\n",
      isText ? "ASCII" : "BINARY", v.dims.x, v.dims.y, v.dims.z, voxelCount(v), types[static_cast<int>(v.type)],
      v.channels);
  if (!isText) return head + samplesOf(v);
  for (std::size_t i = 0; i < voxelCount(v) * std::size_t(v.channels); ++i) head += std::to_string(i % 100) + " ";
  return head;
}

std::string mrc(const Volume& v, bool isTurned) {
  std::string bytes;
  for (int value : {v.dims.x, v.dims.y, v.dims.z, 1, 0, 0, 0, v.dims.x, v.dims.y, v.dims.z})
    bytes += bytesOf(std::int32_t(value), isTurned);
  for (float value : {4.0f, 9.0f, 20.0f, 90.0f, 90.0f, 90.0f}) bytes += bytesOf(value, isTurned);
  for (int value : {1, 2, 3}) bytes += bytesOf(std::int32_t(value), isTurned);
  bytes.resize(1024);
  bytes.replace(208, 4, "MAP ");
  bytes[212] = bytes[213] = isTurned ? '\x11' : '\x44';
  return bytes + std::string(voxelCount(v) * 2, '\x07');
}

std::string invesalius(const Volume& v) {
  auto member = [](const std::string& name, const std::string& bytes) {
    std::string header(512, '\0');
    header.replace(0, name.size(), name);
    header.replace(124, 11, fmt::format("{:011o}", bytes.size()));
    header[156] = '0';
    header.replace(257, 5, "ustar");
    return header + bytes + std::string((512 - bytes.size() % 512) % 512, '\0');
  };
  std::string plist = fmt::format(
      "<?xml version=\"1.0\"?><plist version=\"1.0\"><dict><key>modality</key><string>CT</string>"
      "<key>orientation</key><integer>1</integer><key>spacing</key><array><real>0.5</real><real>2</real><real>1.5</"
      "real>"
      "</array><key>matrix</key><dict><key>dtype</key><string>{}</string><key>filename</key>"
      "<string>matrix.dat</string><key>shape</key><array><integer>{}</integer><integer>{}</integer>"
      "<integer>{}</integer></array></dict></dict></plist>",
      enumName(v.type), v.dims.z, v.dims.y, v.dims.x);
  return member("a/main.plist", plist) + member("a/matrix.dat", samplesOf(v)) + std::string(1024, '\0');
}

/// As DicomFuzz.cpp takes them: each behind its size.
std::string setOf(const std::vector<Path>& files) {
  std::string set;
  for (const Path& file : files) set += bytesOf(std::uint32_t(std::filesystem::file_size(file))) + bytesOf(file);
  return set;
}

void putDicom(const Volume& v, const std::string& name) {
  if (v.channels > 1 || v.type != SampleType::Int16) return;
  std::vector<Path> files;
  std::size_t plane = timeStepBytes(v) / std::size_t(v.dims.z);
  for (int z = 0; z < v.dims.z; ++z) {
    DicomImage image;
    image.columns = v.dims.x, image.rows = v.dims.y;
    image.isSigned = true;
    image.pixels = samplesOf(v).substr(plane * std::size_t(z), plane);
    putPlace(image.set, 2.0 * z);
    putRescale(image.set, "1", "0", "HU");
    files.push_back(root / fmt::format("{}.dcm", z));
    if (!writeDicom(files.back(), image)) throw InputError(files.back().string() + ": cannot be written");
  }
  put("dicom", name, setOf(files));
  // All planes in one file, with functional groups.
  DicomImage frames;
  frames.columns = v.dims.x, frames.rows = v.dims.y, frames.frames = v.dims.z;
  frames.isSigned = true;
  frames.pixels = samplesOf(v).substr(0, timeStepBytes(v));
  std::vector<double> places;
  for (int z = 0; z < v.dims.z; ++z) places.push_back(3.0 * z);
  putGroups(frames.set, places);
  frames.sopClass = "1.2.840.10008.5.1.4.1.1.2.1";
  if (!writeDicom(files[0], frames)) throw InputError(files[0].string() + ": cannot be written");
  put("dicom", name + "-frames", setOf({files[0]}));
  for (const Path& file : files) std::filesystem::remove(file);
}

void putDicomSegments(const LabelVolume& labels) {
  glm::ivec3 dims = labels.dims();
  for (const char* type : {"BINARY", "FRACTIONAL", "LABELMAP"}) {
    bool isMap = std::string_view(type) == "LABELMAP", isBits = std::string_view(type) == "BINARY";
    DicomImage image;
    image.sopClass = isMap ? "1.2.840.10008.5.1.4.1.1.66.7" : "1.2.840.10008.5.1.4.1.1.66.4";
    image.modality = "SEG";
    image.columns = dims.x, image.rows = dims.y, image.frames = dims.z;
    image.bits = image.stored = isBits ? 1 : 8;
    std::vector<double> places;
    for (int z = 0; z < dims.z; ++z) places.push_back(10.0 * z);
    putGroups(image.set, places, std::vector<std::uint16_t>(places.size(), 1));
    putText(image.set, gdcm::Tag(0x0062, 0x0001), gdcm::VR::CS, type);
    if (!isMap && !isBits) putShort(image.set, gdcm::Tag(0x0062, 0x000e), 200);
    auto voxels = std::size_t(dims.x * dims.y * dims.z);
    image.pixels = std::string(isBits ? (voxels + 15) / 16 * 2 : voxels + voxels % 2, '\x01');
    if (!writeDicom(seed("dicom-seg", type), image)) throw InputError("a segmentation cannot be written");
  }
}

void putVolume(const Volume& v, const std::string& name) {
  Progress progress;
  auto save = [&](const char* target, const char* ending) {
    Path named = seed(target, name + ending);
    writeVolume(v, named, progress);
  };
  save("nifti", ".nii"), save("nifti", ".nii.gz"), save("nrrd", ".nrrd");
  if (v.timeSteps == 1) save("vti", ".vti");
  if (v.channels == 1 && v.timeSteps == 1) save("vdb", ".vdb");
  put("meta-image", name, metaImage(v));
  put("vtk-legacy", name, vtkLegacy(v, false));
  put("vtk-legacy", name + "-text", vtkLegacy(v, true));
  put("mrc", name, mrc(v, false));
  put("mrc", name + "-turned", mrc(v, true));
  put("invesalius", name, invesalius(v));
  put("raw", name,
      std::string{char(v.dims.x), char(v.dims.y), char(v.dims.z), char(v.type), char(v.channels), '\0'} + samplesOf(v));
  putDicom(v, name);
}

void putMeshes() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  mesh.color = glm::vec3(1, 0.5, 0);
  for (const char* format : {"ply", "obj", "stl", "vtp"}) writeMesh(mesh, seed(format, std::string("a.") + format));
  put("ply", "text",
      "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n1 1 1 0 0 9\n"
      "3 0 1 2\n4 0 1 3 2\n");
  std::string points;
  for (float x : {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) points += bytesOf(x, true);
  put("ply", "big-endian",
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
          points + '\3' + bytesOf(std::int32_t(0), true) + bytesOf(std::int32_t(1), true) +
          bytesOf(std::int32_t(2), true));
  put("stl", "text",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid a\n");
  put("obj", "text",
      "mtllib a.mtl\no a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvt 0 0\nusemtl b\n"
      "f 1/1/1 2//1 3\nf -4 -3 -2 -1\n");
  put("vtp", "text",
      "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
      "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\" NumberOfStrips=\"1\"><Points><DataArray type=\"Float32\" "
      "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 1</DataArray></Points><Polys><DataArray "
      "type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int64\" "
      "Name=\"offsets\" format=\"ascii\">3</DataArray></Polys><Strips><DataArray type=\"Int32\" Name=\"connectivity\" "
      "format=\"ascii\">0 1 2 3"
      "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
      "format=\"ascii\">4</DataArray></Strips></Piece></PolyData>"
      "</VTKFile>");
}

void putPictures(const std::string& scene) {
  Image image{3, 2, {"R", "G", "B", "A"}, std::vector<float>(24, 0.5f)};
  writeImage(image, seed("png", "scene.png"), scene, 300);
  writeImage(image, seed("exr", "scene.exr"), scene);
  writeImage(image, seed("tiff", "scene.tif"), scene);
  Image layers{3, 2, {"R", "G", "B", "A", "Z", "id"}, std::vector<float>(36, 0.5f)};
  writeImage(layers, seed("exr", "layers.exr"), scene);
  Image grey{4, 4, {"Y"}, std::vector<float>(16, 0.25f)};
  for (const char* name : {"png", "exr", "tiff"}) {
    Path as = seed(name, std::string("grey.") + (std::string_view(name) == "tiff" ? "tif" : name));
    writeImage(grey, as);
  }
  std::string ome =
      "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"XYZCT\" Type=\"uint8\" SizeX=\"4\" SizeY=\"4\" "
      "SizeZ=\"1\" SizeC=\"1\" SizeT=\"1\" PhysicalSizeX=\"0.5\" PhysicalSizeXUnit=\"µm\"><Channel Name=\"DAPI\"/>"
      "<TiffData IFD=\"0\" PlaneCount=\"1\"/></Pixels></Image></OME>";
  put("tiff-description", "ome", ome);
  put("tiff-description", "imagej",
      "ImageJ=1.52p\nimages=6\nchannels=2\nslices=3\nunit=micron\nspacing=0.5\nloop=false\n");
  put("tiff-description", "file", bytesOf(root / "tiff" / "grey.tif"));
}

void putLooks(const scene::Scene& scene) {
  const auto& transfer = scene.volume.transfer;
  for (auto [kind, name] : {std::pair{TransferKind::Velum, "velum"},
                            {TransferKind::SlicerText, "text"},
                            {TransferKind::SlicerJson, "json"}})
    put("transfer", fmt::format("{}-{}", transfer.preset, name),
        transferText(transfer, kind, scene.lighting, 1.0).text);
}

/// A scene with something of everything, and journals that lead to it.
void putScenes(scene::Scene scene) {
  scene::SceneMirror mirror;
  std::string journal;
  std::int64_t number = 0;
  auto step = [&] {
    scene::ChangeLine line{++number, 1.0, "a step", "a title", "", mirror.follow(scene)};
    journal += scene::encodeLine(line);
  };
  step();
  for (const char* cut :
       {R"({"shape": "box"})", R"({"shape": "membrane", "membrane": {}})", R"({"shape": "sphere"})"}) {
    scene::setField(scene, "cuts.+", cut);
    step();
  }
  scene::setField(scene, "labels.source.path", "a.nrrd");
  scene::setField(scene, "labels.structures.+", R"({"id": 1, "name": "a"})");
  scene::setField(scene, "surfaces.+", R"({"source": {"path": "a.stl"}})");
  scene::setField(scene, "cuts.0.spares.+", R"({"structure": 1, "distance": 2})");
  step();
  put("scene", "whole", scene::toJson(scene));
  put("scene", "empty", scene::toJson(scene::Scene{}));
  put("scene", "field", "camera.eye=1,2,3");
  put("change-log", "journal", journal);
}

/// Steps of growing, in the corner of the world where growth-fuzz has its volume.
void putGrowths() {
  scene::Scene scene;
  scene::setField(scene, "labels.growths.+",
                  R"({"structure": 1, "seeds": [[3, 3, 2]], "low": 100, "high": 255, "centre": [0, 0, 1],
                      "axis": [0, 0, 1], "distance": 2})");
  put("growth", "plane", scene::toJson(scene));
  scene::setField(scene, "labels.growths.+",
                  R"({"structure": 7, "seeds": [[0, 0, 0], [6, 5, 4]], "low": 0, "high": 100, "steepest": 90,
                      "barriers": [{"path": [[1, 1, 1], [4, 1, 1]], "radius": 1}], "closing": 2, "fillHoles": true})");
  scene::setField(scene, "labels.growths.+", R"({"structure": 9, "seeds": [[3, 3, 2]], "high": 255, "within": 1})");
  put("growth", "barrier", scene::toJson(scene));
  put("scene", "growths", scene::toJson(scene));
}

void putLabels(const LabelVolume& labels, const std::string& name) {
  Progress progress;
  writeLabels(labels, seed("nrrd", name + ".seg.nrrd"), progress);
  writeLabels(labels, seed("nifti", name + "-labels.nii"), progress);
  std::string text = "# a table\n", pairs;
  for (const LabelInfo& info : labels.table) {
    text += fmt::format("{} {} 255 0 0 255\n", info.id, info.name);
    pairs +=
        fmt::format("Segment{0}_ID:=s{0}\nSegment{0}_Name:={1}\nSegment{0}_LabelValue:={0}\nSegment{0}_Color:=1 0 0\n",
                    info.id, info.name);
  }
  put("label-table", name, text);
  put("label-table", name + "-pairs", pairs);
}

/// One ingredient on a surface, one strand; a chain with an assembly; two numbers of a packing.
void putModels() {
  put("cell-pack-results", "small",
      R"({"recipe": {"name": "a"}, "cytoplasme": {"ingredients": {}}, "compartments": {"envelope": {"surface": {"ingredients":
        {"S": {"name": "S", "source": {"pdb": "p", "transform": {"center": true}}, "results": [[[1,2,3],[1,0,0,0]],[[9,2,3],[0,1,0,0]]],
        "positions": [[[0,0,0]]], "radii": [[5]]}}}, "interior": {"ingredients":
        {"DNA": {"name": "DNA", "source": {"pdb": null}, "results": [], "nbCurve": 1, "curve0": [[0,0,0],[0,9,0],[9,9,0]]}}}}}})");
  std::string atom = "ATOM      1  N   ALA A   1       1.000   2.000   3.000  1.00  0.00           N\n";
  std::string oper;
  for (int row = 1; row <= 3; ++row)
    oper += fmt::format("REMARK 350   BIOMT{}   1 {:9.6f} {:9.6f} {:9.6f}        5.00000\n", row, double(row == 1),
                        double(row == 2), double(row == 3));
  put("pdb-model", "small",
      "TITLE     A\nCOMPND    MOL_ID: 1; MOLECULE: P; CHAIN: A;\nREMARK 350 BIOMOLECULE: 1\n"
      "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n" +
          oper + atom);
  ModelBuilder builder("a");
  std::uint32_t molecule =
      builder.addMolecule(builder.addType({.name = "P"}), {{.position = {1, 2, 3}}, {.element = 7}});
  for (int i = 0; i < 3; ++i) builder.addInstance(molecule, glm::vec3(float(i)), {1, 0, 0, 0});
  Progress progress;
  Path text = seed("cif", "small.cif");
  writeModel(builder.build(), text, progress);
  std::string bytes;
  for (float v : {1.0f, 2.0f, 3.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}) bytes += bytesOf(v);
  put("binary-cif", "small", binaryCif::packed(binaryCif::small()));
  put("cell-pack-binary", "bare", bytes);
  put("cell-pack-binary", "headed", bytesOf(std::int32_t(1)) + bytesOf(std::int32_t(0)) + bytes);
}

void putAll() {
  putGrowths();
  putModels();
  for (const SampleInfo& info : samples()) {
    Progress progress;
    Sample sample = makeSample(info.name, 16, progress);
    std::string name(info.name);
    putVolume(middleOf(sample.volume), name);
    putLabels(middleOf(sample.labels), name);
    putDicomSegments(middleOf(sample.labels));
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(std::move(sample.volume));
    scene::applyPreset(scene, scene::choosePreset(*scene.volume.data));
    putLooks(scene);
    if (info.name == "torso") {
      putScenes(scene);
      putPictures(scene::toJson(scene));
    }
  }
  for (int code : {1, 2, 3, 5, 8}) put("segy", fmt::format("format{}", code), makeSegy(code, false, cube(2, 2), 3));
  put("label-table", "itk-snap", "0 0 0 0 0 0 0 \"Clear Label\"\n1 255 0 0 1 1 1 \"a b\"\n");
  put("label-table", "caret",
      "<CaretExtension><LabelTable><Label Key=\"1\" Red=\"1\" Green=\"0\" Blue=\"0\" Alpha=\"1\">"
      "<![CDATA[a]]></Label></LabelTable></CaretExtension>");
  for (auto& [target, name, bytes] : storeSeeds(root)) put(target, name, bytes);
  putMeshes();
}

}  // namespace
}  // namespace velum::io

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: fuzz-seeds FOLDER\n", stderr);
    return 1;
  }
  try {
    velum::io::root = words[1];
    velum::io::putAll();
    velum::io::writeSourceSeeds(words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz-seeds: %s\n", error.what());
    return 2;
  }
}
