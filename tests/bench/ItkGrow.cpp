#include "ItkGrow.h"

#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>

#include <algorithm>
#include <stdexcept>

#include "velum/core/Clock.h"

namespace velum::bench {

namespace {

template <class T>
Timing growAs(const Volume& volume, const T* samples, glm::ivec3 seed, double low, double high) {
  using In = itk::Image<T, 3>;
  using Out = itk::Image<std::uint8_t, 3>;
  auto import = itk::ImportImageFilter<T, 3>::New();
  typename In::SizeType size{
      {itk::SizeValueType(volume.dims.x), itk::SizeValueType(volume.dims.y), itk::SizeValueType(volume.dims.z)}};
  import->SetRegion(typename In::RegionType(size));
  import->SetImportPointer(const_cast<T*>(samples), voxelCount(volume), false);
  import->Update();
  auto filter = itk::ConnectedThresholdImageFilter<In, Out>::New();
  filter->SetInput(import->GetOutput());
  filter->SetLower(T(low));
  filter->SetUpper(T(high));
  filter->AddSeed({{seed.x, seed.y, seed.z}});
  auto start = Clock::now();
  filter->Update();
  Timing timing{msSince(start)};
  const std::uint8_t* out = filter->GetOutput()->GetBufferPointer();
  timing.voxels = std::size_t(std::count_if(out, out + voxelCount(volume), [](std::uint8_t v) { return v != 0; }));
  return timing;
}

}  // namespace

Timing growWithItk(const Volume& volume, glm::ivec3 seed, double low, double high) {
  if (volume.channels != 1 || volume.scale != 1.0 || volume.offset != 0.0)
    throw std::runtime_error("ITK compares raw samples of one channel");
  const void* samples = volume.voxels.data();
  switch (volume.type) {
    case SampleType::UInt8:
      return growAs(volume, static_cast<const std::uint8_t*>(samples), seed, low, high);
    case SampleType::UInt16:
      return growAs(volume, static_cast<const std::uint16_t*>(samples), seed, low, high);
    case SampleType::Int16:
      return growAs(volume, static_cast<const std::int16_t*>(samples), seed, low, high);
    case SampleType::Float32:
      return growAs(volume, static_cast<const float*>(samples), seed, low, high);
    default:
      throw std::runtime_error("no such samples are compared here");
  }
}

}  // namespace velum::bench
