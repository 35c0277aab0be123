#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "core/Mesh.h"
#include "core/ReplaceFile.h"
#include "io/images/ImageFile.h"
#include "io/labels/DicomSegWriter.h"
#include "io/meshes/ExtractSurface.h"
#include "io/meshes/VtpWriter.h"
#include "io/read/TiffDecoder.h"
#include "io/read/VtkXml.h"
#include "io/stores/Hdf5File.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/Readers.h"

/// Code that needs a heavy third-party library is in a shared library of our own, a plug-in, which is loaded when one
/// of its functions is first called, so that a program starts without it. Each function here does what the function of
/// the same name in io is documented to do; Plugins.cpp forwards io's calls to these.
namespace velum::io {

namespace plugin {

decltype(io::readDicom) readDicom;
decltype(io::readRtStruct) readRtStruct;
decltype(io::readDicomSeg) readDicomSeg;
decltype(io::writeDicomSeg) writeDicomSeg;
decltype(io::holdsDicom) holdsDicom;
decltype(io::labelsWithoutImages) labelsWithoutImages;
decltype(io::isDicomIndex) isDicomIndex;
decltype(io::isDicomSeg) isDicomSeg;
decltype(io::isRtStruct) isRtStruct;
decltype(io::listSeries) listSeries;
decltype(io::readSeriesImage) readSeriesImage;

decltype(io::writeImage) writeImage;
decltype(io::readImage) readImage;
decltype(io::readImageDescription) readImageDescription;
decltype(io::readTiff) readTiff;

decltype(io::openHdf5) openHdf5;

decltype(io::openTiffDecoder) openTiffDecoder;

decltype(io::readVdb) readVdb;
decltype(io::writeVdb) writeVdb;

decltype(io::extractSurface) extractSurface;
decltype(io::writeVti) writeVti;
decltype(io::writeVtp) writeVtp;
decltype(io::unpackByVtk) unpackByVtk;

}  // namespace plugin

/// The table of functions that libvelum-io-gdcm.so exports under the name velumPlugin; the tables below are those of
/// the other plug-ins.
struct GdcmPlugin {
  static constexpr const char *kName = "gdcm", *kWhat = "DICOM";
  decltype(&plugin::readDicom) readDicom = nullptr;
  decltype(&plugin::readRtStruct) readRtStruct = nullptr;
  decltype(&plugin::readDicomSeg) readDicomSeg = nullptr;
  decltype(&plugin::writeDicomSeg) writeDicomSeg = nullptr;
  decltype(&plugin::holdsDicom) holdsDicom = nullptr;
  decltype(&plugin::labelsWithoutImages) labelsWithoutImages = nullptr;
  decltype(&plugin::isDicomIndex) isDicomIndex = nullptr;
  decltype(&plugin::isDicomSeg) isDicomSeg = nullptr;
  decltype(&plugin::isRtStruct) isRtStruct = nullptr;
  decltype(&plugin::listSeries) listSeries = nullptr;
  decltype(&plugin::readSeriesImage) readSeriesImage = nullptr;
};
struct Hdf5Plugin {
  static constexpr const char *kName = "hdf5", *kWhat = "HDF5";
  decltype(&plugin::openHdf5) openHdf5 = nullptr;
};
struct OiioPlugin {
  static constexpr const char *kName = "oiio", *kWhat = "pictures";
  decltype(&plugin::writeImage) writeImage = nullptr;
  decltype(&plugin::readImage) readImage = nullptr;
  decltype(&plugin::readImageDescription) readImageDescription = nullptr;
  decltype(&plugin::readTiff) readTiff = nullptr;
};
struct TiffPlugin {
  static constexpr const char *kName = "tiff", *kWhat = "packed pages of TIFF files";
  decltype(&plugin::openTiffDecoder) openTiffDecoder = nullptr;
};
struct VdbPlugin {
  static constexpr const char *kName = "vdb", *kWhat = "OpenVDB";
  decltype(&plugin::readVdb) readVdb = nullptr;
  decltype(&plugin::writeVdb) writeVdb = nullptr;
};
struct VtkPlugin {
  static constexpr const char *kName = "vtk", *kWhat = "surfaces and files of VTK";
  decltype(&plugin::extractSurface) extractSurface = nullptr;
  decltype(&plugin::writeVti) writeVti = nullptr;
  decltype(&plugin::writeVtp) writeVtp = nullptr;
  decltype(&plugin::unpackByVtk) unpackByVtk = nullptr;
};

/// Loads a plug-in, which stays loaded, and returns its table of functions. @param what  what the plug-in is for, in
/// words for people
/// @throw InputError when the plug-in, or a library that it links, is missing. Any thread.
const void* loadPlugin(const std::string& name, const std::string& what);

/// The table of a plug-in, which is loaded when its table is first asked for. @throw InputError
template <class Plugin>
const Plugin& loaded() {
  static const void* const table = loadPlugin(Plugin::kName, Plugin::kWhat);
  return *static_cast<const Plugin*>(table);
}

}  // namespace velum::io
