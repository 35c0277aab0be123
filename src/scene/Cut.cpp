#include "scene/Cut.h"

namespace velum::scene {

Cut::Cut() = default;
Cut::Cut(const Cut&) = default;
Cut::Cut(Cut&&) noexcept = default;
Cut& Cut::operator=(const Cut&) = default;
Cut& Cut::operator=(Cut&&) noexcept = default;
Cut::~Cut() = default;
bool Cut::operator==(const Cut&) const = default;

}  // namespace velum::scene
