#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/Error.h"
#include "io/looks/TransferFile.h"

/// The same bytes as each kind of file that holds a transfer function: refused in words, or one that can be drawn and
/// written again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  auto before = [](const auto& a, const auto& b) { return a.value < b.value; };
  for (auto kind : {io::TransferKind::Velum, io::TransferKind::SlicerText, io::TransferKind::SlicerJson}) {
    try {
      scene::TransferFunction transfer = io::parseTransfer(text, kind).transfer;
      if (!std::is_sorted(transfer.opacities.begin(), transfer.opacities.end(), before)) std::abort();
      if (!std::is_sorted(transfer.colors.begin(), transfer.colors.end(), before)) std::abort();
      for (const auto& point : transfer.opacities)
        if (!(point.opacity >= 0 && point.opacity <= 1)) std::abort();
      for (const auto& stop : transfer.colors)
        for (int c = 0; c < 3; ++c)
          if (!(stop.color[c] >= 0 && stop.color[c] <= 1)) std::abort();
      if (!(transfer.unitDistance > 0)) std::abort();
      io::transferText(transfer, io::TransferKind::SlicerJson, {}, 1.0);
    } catch (const Error&) {
    }
  }
  return 0;
}
