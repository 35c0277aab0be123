#include "VtkScene.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

#include "Worker.h"

namespace velum::bench {

namespace {

int vtkTypeOf(SampleType type) {
  switch (type) {
    case SampleType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case SampleType::Int8:
      return VTK_SIGNED_CHAR;
    case SampleType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case SampleType::Int16:
      return VTK_SHORT;
    case SampleType::UInt32:
      return VTK_UNSIGNED_INT;
    case SampleType::Int32:
      return VTK_INT;
    case SampleType::Float32:
      return VTK_FLOAT;
    case SampleType::Float64:
      break;
  }
  return VTK_DOUBLE;
}

/// The volume as VTK holds it; its box must be axis-aligned (see makeCube()).
vtkSmartPointer<vtkImageData> makeImage(const Volume& volume) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  glm::dvec3 spacing = spacingOf(volume), origin(volume.worldFromVoxel[3]);
  image->SetDimensions(volume.dims.x, volume.dims.y, volume.dims.z);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetOrigin(origin.x, origin.y, origin.z);
  image->AllocateScalars(vtkTypeOf(volume.type), 1);
  std::memcpy(image->GetScalarPointer(), volume.voxels.data(), timeStepBytes(volume));
  return image;
}

/// Colour and opacity over raw values, light that answers as ours does.
void setProperty(vtkVolumeProperty& property, const scene::Scene& scene) {
  const Volume& volume = *scene.volume.data;
  auto raw = [&](double value) { return (value - volume.offset) / volume.scale; };
  vtkNew<vtkColorTransferFunction> color;
  for (const auto& p : scene.volume.transfer.colors) color->AddRGBPoint(raw(p.value), p.color.r, p.color.g, p.color.b);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& p : scene.volume.transfer.opacities) opacity->AddPoint(raw(p.value), p.opacity);
  property.SetColor(color);
  property.SetScalarOpacity(opacity);
  property.SetScalarOpacityUnitDistance(scene.volume.transfer.unitDistance);
  property.SetInterpolationTypeToLinear();
  property.SetShade(scene.lighting.shaded);
  // Our light from everywhere is 0.7 + 0.3 up; VTK's is the same all round.
  property.SetAmbient(0.7 * scene.lighting.ambient);
  property.SetDiffuse(scene.lighting.diffuse);
  property.SetSpecular(scene.lighting.specular);
  property.SetSpecularPower(scene.lighting.shininess);
}

/// Switches that both mappers have, under the same names but without a common base.
template <class AnyMapper>
void setSteps(AnyMapper& mapper, double step) {
  mapper.SetAutoAdjustSampleDistances(0);
  mapper.SetLockSampleDistanceToInputSpacing(0);
  mapper.SetSampleDistance(float(step));
  mapper.SetImageSampleDistance(1.0f);
}

vtkSmartPointer<vtkVolumeMapper> makeMapper(VtkScene::Mapper kind, double step) {
  if (kind == VtkScene::Mapper::Gpu) {
    auto mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    setSteps(*mapper, step);
    mapper->SetUseJittering(0);
    return mapper;
  }
  auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
  setSteps(*mapper, step);
  mapper->SetInteractiveSampleDistance(float(step));
  mapper->SetIntermixIntersectingGeometry(0);
  mapper->SetNumberOfThreads(int(std::max(1u, std::thread::hardware_concurrency())));
  return mapper;
}

}  // namespace

bool hasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

struct VtkScene::Impl {
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLight> light;
  vtkNew<vtkVolume> volume;

  Impl(const scene::Scene& scene, Mapper kind, glm::ivec2 size);
  double render(const scene::Camera& camera);
  Image read();
  std::string glRenderer() const;
};

VtkScene::Impl::Impl(const scene::Scene& scene, Mapper kind, glm::ivec2 size) {
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(size.x, size.y);
  window->AddRenderer(renderer);
  renderer->SetBackground(0, 0, 0);
  renderer->AutomaticLightCreationOff();
  light->SetLightTypeToHeadlight();
  renderer->AddLight(light);
  glm::dvec3 spacing = spacingOf(*scene.volume.data);
  auto mapper = makeMapper(kind, scene.rayCast.stepVoxels * std::min({spacing.x, spacing.y, spacing.z}));
  mapper->SetInputDataObject(makeImage(*scene.volume.data));
  volume->SetMapper(mapper);
  setProperty(*volume->GetProperty(), scene);
  renderer->AddVolume(volume);
}

double VtkScene::Impl::render(const scene::Camera& camera) {
  vtkCamera& eye = *renderer->GetActiveCamera();
  eye.SetPosition(camera.eye.x, camera.eye.y, camera.eye.z);
  eye.SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  eye.SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  eye.SetParallelProjection(camera.projection == scene::Projection::Orthographic);
  eye.SetViewAngle(camera.fieldOfViewDeg);
  eye.SetParallelScale(0.5 * camera.height);
  renderer->ResetCameraClippingRange();
  auto start = std::chrono::steady_clock::now();
  window->Render();
  window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Image VtkScene::Impl::read() {
  const int* size = window->GetSize();
  Image image{size[0], size[1], {"R", "G", "B"}, {}};
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetPixelData(0, 0, image.width - 1, image.height - 1, /*front=*/0, bytes);
  image.pixels.resize(std::size_t(bytes->GetNumberOfValues()));
  std::size_t row = std::size_t(image.width) * 3, height = std::size_t(image.height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t i = 0; i < row; ++i)
      image.pixels[(height - 1 - y) * row + i] = float(bytes->GetValue(vtkIdType(y * row + i))) / 255.0f;
  return image;
}

std::string VtkScene::Impl::glRenderer() const {
  std::istringstream text(window->ReportCapabilities());
  constexpr std::string_view kKey = "OpenGL renderer string:";
  for (std::string line; std::getline(text, line);)
    if (auto at = line.find(kKey); at != std::string::npos)
      return line.substr(line.find_first_not_of(' ', at + kKey.size()));
  return "unknown";
}

VtkScene::VtkScene(const scene::Scene& scene, Mapper mapper, glm::ivec2 size) : mWorker(std::make_unique<Worker>()) {
  mWorker->run([&] { mImpl = std::make_unique<Impl>(scene, mapper, size); });
}

VtkScene::~VtkScene() {
  mWorker->run([this] { mImpl.reset(); });
}

double VtkScene::render(const scene::Camera& camera) {
  double ms = 0;
  mWorker->run([&] { ms = mImpl->render(camera); });
  return ms;
}

Image VtkScene::read() {
  Image image;
  mWorker->run([&] { image = mImpl->read(); });
  return image;
}

std::string VtkScene::renderer() {
  std::string name;
  mWorker->run([&] { name = mImpl->glRenderer(); });
  return name;
}

}  // namespace velum::bench
