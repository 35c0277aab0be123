#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <stdexcept>
#include <vector>

#include "Child.h"

namespace velum::bench {

namespace {

itk::ImageIOBase::Pointer readerFor(const std::string& path) {
  auto endsWith = [&](std::string_view end) { return std::string_view(path).ends_with(end); };
  if (endsWith(".nrrd")) return itk::NrrdImageIO::New().GetPointer();
  if (endsWith(".nii") || endsWith(".nii.gz")) return itk::NiftiImageIO::New().GetPointer();
  if (endsWith(".mha")) return itk::MetaImageIO::New().GetPointer();
  throw std::runtime_error("no ITK reader for " + path);
}

}  // namespace

/// The ImageIO alone: what itk::ImageFileReader calls, without its pipeline and copies.
std::size_t readWithItk(const std::string& path) {
  auto reader = readerFor(path);
  reader->SetFileName(path);
  reader->ReadImageInformation();
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned axis = 0; axis < reader->GetNumberOfDimensions(); ++axis)
    region.SetSize(axis, reader->GetDimensions(axis));
  reader->SetIORegion(region);
  std::vector<char> voxels(std::size_t(reader->GetImageSizeInBytes()));
  reader->Read(voxels.data());
  return voxels.size();
}

}  // namespace velum::bench
