#include "io/Plugins.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "core/Error.h"
#include "io/images/ImageFormat.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/DicomSoundness.h"
#include "io/volumes/OpenTiff.h"
#include "io/volumes/ReadLevel.h"
#include "io/volumes/StoreSeries.h"

namespace velum::io {

namespace {

using Path = std::filesystem::path;

/// Plug-ins lie in a folder beside the library that this is in.
Path folderOfPlugins() {
  Dl_info here{};
  dladdr(reinterpret_cast<const void*>(&loadPlugin), &here);
  return Path(here.dli_fname ? here.dli_fname : "").parent_path() / "velum";
}

const GdcmPlugin& gdcmPlugin() { return loaded<GdcmPlugin>(); }
const Hdf5Plugin& hdf5Plugin() { return loaded<Hdf5Plugin>(); }
const OiioPlugin& oiioPlugin() { return loaded<OiioPlugin>(); }
const TiffPlugin& tiffPlugin() { return loaded<TiffPlugin>(); }
const VdbPlugin& vdbPlugin() { return loaded<VdbPlugin>(); }
const VtkPlugin& vtkPlugin() { return loaded<VtkPlugin>(); }

/// So that nothing is loaded for a file of another kind.
bool isDicomFile(const Path& path) { return std::filesystem::is_regular_file(path) && mayBeDicom(path); }

}  // namespace

const void* loadPlugin(const std::string& name, const std::string& what) {
  Path path = folderOfPlugins() / fmt::format("libvelum-io-{}.so", name);
  if (!std::filesystem::exists(path))
    throw InputError(fmt::format("cannot read or write {}: {} was not found in {}", what, path.filename().string(),
                                 path.parent_path().string()));
  void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  const void* table = library ? dlsym(library, "velumPlugin") : nullptr;
  if (!table) throw InputError(fmt::format("cannot read or write {}: {}", what, dlerror()));
  return table;
}

Volume readDicom(const scene::Source& source, Progress& progress) { return gdcmPlugin().readDicom(source, progress); }
LabelVolume readRtStruct(const scene::Source& source, Progress& progress) {
  return gdcmPlugin().readRtStruct(source, progress);
}
LabelVolume readDicomSeg(const scene::Source& source, Progress& progress) {
  return gdcmPlugin().readDicomSeg(source, progress);
}
std::vector<std::string> writeDicomSeg(const LabelVolume& labels, ReplaceFile& file, Progress& progress) {
  return gdcmPlugin().writeDicomSeg(labels, file, progress);
}
bool holdsDicom(const Path& folder, Depth depth, Progress& progress) {
  return gdcmPlugin().holdsDicom(folder, depth, progress);
}
std::vector<DicomFile> labelsWithoutImages(const Path& folder, Progress& progress) {
  return gdcmPlugin().labelsWithoutImages(folder, progress);
}
bool isDicomIndex(const Path& path) { return isDicomFile(path) && gdcmPlugin().isDicomIndex(path); }
bool isDicomSeg(const Path& path) { return isDicomFile(path) && gdcmPlugin().isDicomSeg(path); }
bool isRtStruct(const Path& path) { return isDicomFile(path) && gdcmPlugin().isRtStruct(path); }
std::vector<SeriesInfo> listSeries(const Path& path, Progress& progress) {
  if (isStore(path)) return seriesInStore(path, progress);
  // What lies beside a file of another format is none of its business.
  if (std::filesystem::exists(path) && !std::filesystem::is_directory(path) && !mayBeDicom(path)) return {};
  return gdcmPlugin().listSeries(path, progress);
}
Volume readSeriesImage(const SeriesInfo& series, Progress& progress) {
  if (auto place = placeInStore(series.middleFile)) return readStorePicture(*place, progress);
  return gdcmPlugin().readSeriesImage(series, progress);
}

std::unique_ptr<Hdf5File> openHdf5(const Path& path) { return hdf5Plugin().openHdf5(path); }

void writeImage(const Image& image, const Path& path, const std::string& description, double dpi,
                const std::vector<ImageAttribute>& attributes, int bits) {
  oiioPlugin().writeImage(image, path, description, dpi, attributes, bits);
}
Image readImage(const Path& path) { return oiioPlugin().readImage(path); }
std::string readImageDescription(const Path& path) {
  return isTiffWithoutScene(path) ? std::string() : oiioPlugin().readImageDescription(path);
}
Volume readTiff(const scene::Source& source, Progress& progress) {
  // What needs no conversion needs no library of pictures; OpenImageIO's tiles of doubles are rounded to floats, too.
  auto opened = std::filesystem::is_directory(source.path) ? nullptr : openTiff(source);
  if (!opened) return oiioPlugin().readTiff(source, progress);
  if (opened->levels().size() == 1) return readLevel(*opened, 0, progress);
  constexpr bool kIsAlignedByBorders = true;
  return readFitting(std::move(opened), source, kIsAlignedByBorders, progress);
}

std::unique_ptr<TiffDecoder> openTiffDecoder(std::shared_ptr<const FileBytes> file) {
  return tiffPlugin().openTiffDecoder(std::move(file));
}

Volume readVdb(const scene::Source& source, Progress& progress) { return vdbPlugin().readVdb(source, progress); }
std::vector<std::string> writeVdb(const Volume& volume, ReplaceFile& file, Progress& progress) {
  return vdbPlugin().writeVdb(volume, file, progress);
}

Mesh extractSurface(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                    double smoothness, Progress& progress) {
  return vtkPlugin().extractSurface(field, structure, low, high, smoothness, progress);
}
std::vector<std::string> writeVti(const Volume& volume, ReplaceFile& file, Progress& progress) {
  return vtkPlugin().writeVti(volume, file, progress);
}
void writeVtp(const Mesh& mesh, ReplaceFile& file) { vtkPlugin().writeVtp(mesh, file); }
std::size_t unpackByVtk(VtkPacking packing, std::span<const std::byte> from, std::span<std::byte> to) {
  return vtkPlugin().unpackByVtk(packing, from, to);
}

}  // namespace velum::io
