#include "io/models/RotationSense.h"

namespace velum::io {

double outwardAgreement(std::span<const Instance> instances, glm::vec3 middle, bool isInverse) {
  glm::dvec3 sum(0.0);
  for (const Instance& instance : instances) {
    glm::quat back = isInverse ? instance.rotation : glm::conjugate(instance.rotation);
    glm::vec3 outward = instance.position - middle;
    float length = glm::length(outward);
    if (length > 0.0f) sum += glm::dvec3(back * (outward / length));
  }
  return instances.empty() ? 0.0 : glm::length(sum) / double(instances.size());
}

}  // namespace velum::io
