#pragma once
#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "core/Clock.h"
#include "core/Volume.h"

namespace velum {

/// What ITK grows, a byte a voxel, and how long its filter alone took.
struct ItkGrown {
  std::vector<std::uint8_t> voxels;
  double ms = 0.0;
};

template <class T>
ItkGrown growSamplesByItk(const Volume& volume, const T* samples, glm::ivec3 seed, double low, double high) {
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
  filter->SetLower(T((low - volume.offset) / volume.scale));
  filter->SetUpper(T((high - volume.offset) / volume.scale));
  filter->AddSeed({{seed.x, seed.y, seed.z}});
  auto start = Clock::now();
  filter->Update();
  double ms = msSince(start);
  const std::uint8_t* out = filter->GetOutput()->GetBufferPointer();
  return {{out, out + voxelCount(volume)}, ms};
}

/// itk::ConnectedThresholdImageFilter from a seed in the first time step. One channel of 8 or 16 bit or float.
inline ItkGrown growByItk(const Volume& volume, glm::ivec3 seed, double low, double high) {
  if (volume.channels != 1) throw std::runtime_error("ITK compares one channel");
  return visitSamples(volume, [&](auto* samples) -> ItkGrown {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(samples)>>;
    if constexpr (sizeof(T) <= 2 || std::is_same_v<T, float>)
      return growSamplesByItk(volume, samples, seed, low, high);
    else
      throw std::runtime_error("no such samples are compared");
  });
}

}  // namespace velum
