#pragma once

namespace velum::gui {

/// Milliseconds after which a test takes something for hung. Work beside the window has a tenth of a busy core, so what
/// takes seconds alone may take minutes while other tests run: a limit, never a measure.
constexpr int kPatience = 300000;

}  // namespace velum::gui
