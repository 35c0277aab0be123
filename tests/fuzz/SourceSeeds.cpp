#include "SourceSeeds.h"

#include <fstream>
#include <string>

#include "../support/TiffFiles.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "vector/WritePdf.h"
#include "vector/WriteSvg.h"

namespace velum::io {

namespace {

void writePyramids(const std::filesystem::path& folder) {
  const std::string pixels =
      "<OME><Pixels DimensionOrder=\"XYZCT\" SizeX=\"20\" SizeY=\"17\" SizeZ=\"2\" SizeC=\"1\" SizeT=\"1\" "
      "PhysicalSizeX=\"0.5\"><TiffData/></Pixels></OME>";
  for (int tile : {0, 16})
    for (bool isChained : {false, true})
      for (int packing :
           {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_ZSTD}) {
        TiffMaking how;
        how.mode = isChained ? "wb" : "w8";
        how.tile = tile;
        how.levels = 2;
        how.isChained = isChained;
        how.packing = std::uint16_t(packing);
        how.description = pixels;
        std::string name = std::to_string(tile) + "-" + std::to_string(packing) + (isChained ? "-chain" : "") + ".tif";
        writeTiff(folder / name, {20, 17}, 2, SampleType::UInt16, how, anySamples(SampleType::UInt16, 1));
      }
  TiffMaking planar;
  planar.samples = 3;
  planar.isPlanar = true;
  planar.photometric = PHOTOMETRIC_RGB;
  writeTiff(folder / "planar.tif", {9, 8}, 2, SampleType::UInt8, planar, anySamples(SampleType::UInt8, 3));
}

void writeRaw(const std::filesystem::path& folder) {
  std::string samples(5 * 4 * 3 * 2, 'a');
  std::ofstream(folder / "a.nrrd", std::ios::binary)
      << "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 4 3\nspacings: 1 2 3\nencoding: raw\nendian: big\n\n"
      << samples;
  std::ofstream(folder / "a.mha", std::ios::binary)
      << "ObjectType = Image\nNDims = 3\nDimSize = 5 4 3\nElementType = MET_SHORT\nElementSpacing = 1 2 3\n"
         "ElementDataFile = LOCAL\n"
      << samples;
}

}  // namespace

void writeSourceSeeds(const std::filesystem::path& root) {
  for (const char* target : {"svg", "pdf"}) std::filesystem::create_directories(root / target);
  const vector::Drawing drawing{{3, 2}, 300.0, "a", {}};
  vector::writeSvg(drawing, root / "svg" / "scene.svg", scene::toJson(scene::Scene()));
  vector::writePdf(drawing, root / "pdf" / "scene.pdf", scene::toJson(scene::Scene()));
  for (const char* target : {"tiff-source", "raw-source"}) std::filesystem::create_directories(root / target);
  writePyramids(root / "tiff-source");
  writeRaw(root / "raw-source");
  for (const char* target : {"nifti", "mrc"})
    for (const auto& entry : std::filesystem::directory_iterator(root / target))
      std::filesystem::copy_file(entry.path(), root / "raw-source" / entry.path().filename(),
                                 std::filesystem::copy_options::overwrite_existing);
}

}  // namespace velum::io
