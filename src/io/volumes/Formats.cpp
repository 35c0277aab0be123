#include "io/volumes/Formats.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/stores/OpenStore.h"

#include "io/volumes/FormatTable.h"
#include "io/volumes/OpenTiff.h"
#include "io/volumes/RawSource.h"

namespace velum::io {

namespace {

bool holds(const FileHead& head, std::size_t at, std::string_view text) {
  return head.bytes.size() >= at + text.size() && std::string_view(head.bytes).substr(at, text.size()) == text;
}
bool contains(const FileHead& head, std::string_view text) { return head.bytes.find(text) != std::string::npos; }

bool isNifti(const FileHead& h) {
  return holds(h, 344, std::string_view("n+1\0", 4)) || holds(h, 344, std::string_view("ni1\0", 4)) ||
         holds(h, 4, std::string_view("n+2\0", 4)) || holds(h, 4, std::string_view("ni2\0", 4));
}
bool isNrrd(const FileHead& h) { return holds(h, 0, "NRRD000"); }
bool isMetaImage(const FileHead& h) {
  return contains(h, "NDims") && contains(h, "DimSize") && contains(h, "ElementType");
}
bool isMrc(const FileHead& h) { return holds(h, 208, "MAP ") && h.bytes.size() >= 1024; }
bool isVti(const FileHead& h) { return contains(h, "<VTKFile") && contains(h, "ImageData"); }
bool isVtkLegacy(const FileHead& h) { return holds(h, 0, "# vtk DataFile"); }
bool isTiff(const FileHead& h) {
  return holds(h, 0, std::string_view("II*\0", 4)) || holds(h, 0, std::string_view("MM\0*", 4)) ||
         holds(h, 0, std::string_view("II+\0", 4)) || holds(h, 0, std::string_view("MM\0+", 4));
}
bool isZarr(const FileHead& h) { return storeKindOfFile(h.path, h.bytes) == StoreKind::Zarr; }
bool isBigDataViewer(const FileHead& h) {
  StoreKind kind = storeKindOfFile(h.path, h.bytes);
  return kind == StoreKind::Hdf5 || kind == StoreKind::SpimData;
}
bool isVdb(const FileHead& h) { return holds(h, 0, " BDV"); }
bool isOtherThanDicom(const FileHead& head);

/// With its preamble, or, as some old files, starting with an element of group 2 or 8. The sizes at the start of other
/// binary headers may look like such an element.
bool isDicom(const FileHead& head) {
  if (holds(head, 128, "DICM")) return true;
  if (isOtherThanDicom(head)) return false;
  if (head.bytes.size() < 16) return false;
  auto b = [&](std::size_t i) { return static_cast<unsigned char>(head.bytes[i]); };
  bool isElement = (b(0) == 2 || b(0) == 8) && b(1) == 0 && b(2) <= 0x70 && b(3) == 0;
  bool isExplicit = b(4) >= 'A' && b(4) <= 'Z' && b(5) >= 'A' && b(5) <= 'Z';
  bool isShortImplicit = b(0) == 8 && b(5) == 0 && b(6) == 0 && b(7) == 0 && b(4) <= 64 && b(4) % 2 == 0;
  return isElement && (isExplicit || isShortImplicit);
}

template <UnreadVolume (*describe)(const scene::Source&)>
std::unique_ptr<VoxelSource> openDescribed(const scene::Source& source) {
  return openSamples(describe(source), source);
}

// First all contents are tried, in this order, then all extensions. A new format is one row.
constexpr FormatRow kTable[] = {
    {{"DICOM", ".dcm .ima .dicom DICOMDIR", true, ""}, isDicom, readDicom, nullptr},
    {{"NIfTI", ".nii .nii.gz .hdr .hdr.gz .img .img.gz", true, ".nii.gz .nii"},
     isNifti,
     readNifti,
     writeNifti,
     nullptr,
     openDescribed<describeNifti>},
    {{"NRRD", ".nrrd .nhdr", true, ".nrrd"}, isNrrd, readNrrd, writeNrrd, nullptr, openDescribed<describeNrrd>},
    {{"MetaImage", ".mha .mhd", true, ""},
     isMetaImage,
     readMetaImage,
     nullptr,
     nullptr,
     openDescribed<describeMetaImage>},
    {{"MRC", ".mrc .map .rec .ccp4", true, ""}, isMrc, readMrc, nullptr, nullptr, openDescribed<describeMrc>},
    {{"VTK image data", ".vti", true, ".vti"}, isVti, readVti, writeVti},
    {{"VTK legacy structured points", ".vtk", true, ""}, isVtkLegacy, readVtkLegacy, nullptr},
    {{"SEG-Y", ".sgy .segy", true, ""}, nullptr, readSegy, nullptr},
    {{"TIFF", ".tif .tiff", true, ""}, isTiff, readTiff, nullptr, nullptr, openTiff},
    {{"OpenVDB", ".vdb", true, ".vdb"}, isVdb, readVdb, writeVdb},
    {{"OME-Zarr", ".zarr .ozx .zarr.zip", true, ".zarr .ozx"}, isZarr, readStore, nullptr, writeZarr},
    {{"Imaris", ".ims", true, ""}, nullptr, readStore, nullptr},
    {{"BigDataViewer", ".xml .h5 .hdf5", true, ""}, isBigDataViewer, readStore, nullptr},
    {{"N5", ".n5", true, ""}, nullptr, readStore, nullptr},
    {{"InVesalius project", ".inv3", true, ""}, nullptr, readInvesalius, nullptr},
    {{"Raw", ".raw .bin .img .den .dat .vol .data .raw.gz", true, ""}, nullptr, readRaw, nullptr},
};

bool isOtherThanDicom(const FileHead& head) {
  return std::any_of(std::begin(kTable), std::end(kTable),
                     [&](const FormatRow& row) { return row.matches && row.matches != isDicom && row.matches(head); });
}

constexpr auto kFormats = [] {
  std::array<Format, std::size(kTable)> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = kTable[i].format;
  return formats;
}();

bool isAmong(std::string_view extensions, std::string_view extension) {
  if (extension.empty()) return false;
  std::string all = " " + lowerCase(extensions) + " ";
  return all.find(" " + std::string(extension) + " ") != std::string::npos;
}

}  // namespace

bool hasRawLayout(const scene::Source& source) {
  return source.raw.dims.x > 0 && source.raw.dims.y > 0 && source.raw.dims.z > 0;
}

std::span<const Format> formats() { return kFormats; }
std::span<const FormatRow> formatTable() { return kTable; }

FileHead readFileHead(const Path& path) {
  sizeOfFile(path);
  return {path, lowerExtension(path), readHead(path, 4096)};
}

const FormatRow* chooseReader(const FileHead& head) {
  for (const FormatRow& row : kTable)
    if (row.matches && row.matches(head)) return &row;
  std::string extension = lowerCase(head.path.filename().string()) == "dicomdir" ? "dicomdir" : head.extension;
  for (const FormatRow& row : kTable)
    if (isAmong(row.format.extensions, extension)) return &row;
  return nullptr;
}

const FormatRow* chooseWriter(const Path& path) {
  for (const FormatRow& row : kTable)
    if (row.isWritten() && isAmong(row.format.written, lowerExtension(path))) return &row;
  return nullptr;
}

}  // namespace velum::io
