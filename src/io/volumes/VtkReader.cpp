#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "Readers.h"
#include "VtiHeader.h"
#include "VtiNotes.h"
#include "read/FileBytes.h"
#include "read/VtkQuiet.h"
#include "velum/core/Error.h"

/// VTK image data in XML. VTK has no patient axes of its own; its world is taken as ours, millimetres in LPS, which is
/// what ITK-based programs write. A file without a Direction matrix says nothing of the patient.
namespace velum::io {

namespace {

SampleType sampleTypeOf(int vtkType, const Path& path) {
  switch (vtkType) {
    case VTK_UNSIGNED_CHAR:
      return SampleType::UInt8;
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return SampleType::Int8;
    case VTK_UNSIGNED_SHORT:
      return SampleType::UInt16;
    case VTK_SHORT:
      return SampleType::Int16;
    case VTK_UNSIGNED_INT:
      return SampleType::UInt32;
    case VTK_INT:
      return SampleType::Int32;
    case VTK_FLOAT:
      return SampleType::Float32;
    case VTK_DOUBLE:
      return SampleType::Float64;
    default:
      refuse(path, fmt::format("samples of VTK type {} are not read", vtkType));
  }
}

/// 64-bit integers have no place in Volume; doubles hold them to 2^53.
void copySamples(vtkDataArray& from, Volume& v, const Path& path) {
  int type = from.GetDataType();
  auto count = std::size_t(from.GetNumberOfTuples()) * std::size_t(from.GetNumberOfComponents());
  bool isWide = sizeof(long long) == std::size_t(from.GetDataTypeSize()) && type != VTK_DOUBLE;
  if (!isWide) {
    v.type = sampleTypeOf(type, path);
    v.voxels.resize(count * sampleSize(v.type));
    std::memcpy(v.voxels.data(), from.GetVoidPointer(0), v.voxels.size());
    return;
  }
  v.type = SampleType::Float64;
  v.voxels.resize(count * sizeof(double));
  bool isSigned = from.GetDataTypeMin() < 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t raw;
    std::memcpy(&raw, static_cast<const std::byte*>(from.GetVoidPointer(0)) + i * 8, 8);
    double value = isSigned ? double(raw) : double(std::uint64_t(raw));
    std::memcpy(v.voxels.data() + i * 8, &value, 8);
  }
  v.warnings.push_back("64-bit integers are read as doubles");
}

/// VTK allocates on the word of the header, so the header is compared with the file first.
VtiHeader checkHeader(const Path& path) {
  FileBytes file(path);
  VtiHeader header = parseVtiHeader(file, path.string());
  // Text holds at least two characters a number, base64 three bytes in four characters; deflate 1032 to one, LZ4 255,
  // LZMA thousands.
  double expansion = header.isCompressed ? (header.isLzma ? 20000.0 : 1100.0) : 1.0;
  double bytesPerSample = header.isCompressed || !header.isAscii ? double(sampleSize(header.type)) : 2.0;
  double samples = header.dims.x * header.dims.y * header.dims.z * header.components;
  if (!(samples >= 1) || samples * bytesPerSample > expansion * double(file.size()) || samples > 1e12)
    refuse(path, fmt::format("the header promises {:.0f} x {:.0f} x {:.0f} voxels of {} components, more than a file "
                             "of {} bytes can hold",
                             header.dims.x, header.dims.y, header.dims.z, header.components, file.size()));
  return header;
}

double noteOf(vtkImageData& image, const char* name, double otherwise) {
  auto* array = image.GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() < 1) return otherwise;
  double value = array->GetTuple1(0);
  return std::isfinite(value) ? value : otherwise;
}

/// World from voxel; `shift` is where voxel 0 lies in VTK's index space (the extent's start; plus a half for cells).
glm::dmat4 matrixOf(vtkImageData& image, glm::dvec3 shift, Volume& v) {
  const double *spacing = image.GetSpacing(), *origin = image.GetOrigin();
  glm::dmat4 m(1.0);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      m[column][row] = image.GetDirectionMatrix()->GetElement(row, column) * spacing[column];
  bool isSane = true;
  for (int i = 0; i < 3; ++i)
    isSane = isSane && std::isfinite(spacing[i]) && spacing[i] != 0 && std::isfinite(origin[i]);
  if (!isSane || !(std::abs(glm::determinant(glm::dmat3(m))) > 0)) {
    v.warnings.push_back("the file's spacing or direction makes no sense and is left out");
    v.isSpacingKnown = v.isOrientationKnown = false;
    return glm::dmat4(1.0);
  }
  m[3] = glm::dvec4(glm::dvec3(origin[0], origin[1], origin[2]) + glm::dmat3(m) * shift, 1.0);
  return m;
}

/// Only the array that becomes the volume is read.
void selectOnly(vtkDataArraySelection* selection, const std::string& name) {
  for (int i = 0; i < selection->GetNumberOfArrays() && !name.empty(); ++i)
    if (name != selection->GetArrayName(i)) selection->DisableArray(selection->GetArrayName(i));
}

}  // namespace

Volume readVti(const scene::Source& source, Progress& progress) try {
  const Path path = source.path;
  progress.report(0, "reading VTK image");
  // VTK believes a header, so it is checked before; then only the array that is wanted is read.
  VtiHeader header = checkHeader(path);
  VtkQuiet quiet;
  vtkNew<vtkXMLImageDataReader> reader;
  quiet.listen(*reader, &progress);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  if (header.isCellData)
    reader->GetPointDataArraySelection()->DisableAllArrays();
  else
    reader->GetCellDataArraySelection()->DisableAllArrays();
  selectOnly(header.isCellData ? reader->GetCellDataArraySelection() : reader->GetPointDataArraySelection(),
             header.arrayName);
  reader->Update();
  progress.throwIfCancelled();
  if (!quiet.error().empty()) refuse(path, fmt::format("is damaged ({})", quiet.error()));

  // What has come is checked again.
  vtkImageData* image = reader->GetOutput();
  auto* attributes =
      header.isCellData ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  vtkDataArray* array = attributes->GetArray(0);
  if (!array) refuse(path, "its voxels cannot be read; the file is damaged or cut short");
  // The volume: cells are voxels half a step further on.
  Volume v;
  glm::dvec3 shift(image->GetExtent()[0], image->GetExtent()[2], image->GetExtent()[4]);
  v.dims = glm::ivec3(image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2]);
  if (header.isCellData) {
    v.dims = glm::max(v.dims - 1, glm::ivec3(1));
    shift += 0.5;
    v.warnings.push_back("the values stand in cells; each cell is taken as a voxel");
  }
  v.channels = array->GetNumberOfComponents();
  if (std::size_t(array->GetNumberOfTuples()) != voxelCount(v))
    refuse(path, fmt::format("has {} values for {} voxels", array->GetNumberOfTuples(), voxelCount(v)));
  copySamples(*array, v, path);
  v.isColor = (v.channels == 3 || v.channels == 4) && v.type == SampleType::UInt8;
  v.isOrientationKnown = header.hasDirection && noteOf(*image, vti::kOriented, 1.0) != 0.0;
  v.worldFromVoxel = matrixOf(*image, shift, v);
  v.scale = noteOf(*image, vti::kScale, 1.0);
  v.offset = noteOf(*image, vti::kOffset, 0.0);
  if (v.scale == 0.0) v.scale = 1.0;
  return v;
} catch (const std::bad_alloc&) {
  refuse(source.path, "needs more memory than there is");
} catch (const std::length_error&) {
  refuse(source.path, "is damaged (a length in it makes no sense)");
}

}  // namespace velum::io
