// Bundles: kBundle instances each, neighbours in space, and those of them that are listed because something of them may show.
#include "shared/bindings.h"
#include "shared/instance.h"

layout(binding = kOrderUnit) uniform usamplerBuffer orderTexture;  // instances, bundle by bundle
layout(binding = kBundleUnit) uniform samplerBuffer bundleTexture; // the sphere around each, in the first copy
layout(std430, binding = kBundleBinding) buffer BundleBlock {
  uint copyCount;    // that are listed
  uint bundleCount;
  uint padding0, padding1;
  BundleRow bundles[];
};
