# What most files read, of other people's: parsed once for a library or for all of them, not once a file. Our own headers
# change too often to be here. Every file still names what it needs: the presets asan and tidy build without.
set(VELUM_STANDARD_HEADERS <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <optional> <span> <string> <string_view> <type_traits> <utility> <variant> <vector> <glm/glm.hpp>)
set(VELUM_QT_HEADERS <QAction> <QApplication> <QBoxLayout> <QComboBox> <QDoubleSpinBox> <QFileDialog> <QGridLayout> <QIcon>
  <QLabel> <QLineEdit> <QListWidget> <QMainWindow> <QMenu> <QMessageBox> <QMouseEvent> <QOpenGLWidget> <QPainter>
  <QPainterPath> <QPushButton> <QSignalBlocker> <QTimer> <QToolButton> <QWidget>)

# velum_precompile(<target> [OF <first>] [headers ...]): the headers above and these, parsed for the target alone; or those
# that were parsed for the target <first>, where the two are compiled alike.
function(velum_precompile target)
  cmake_parse_arguments(P "" "OF" "" ${ARGN})
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    # GCC forgets that such headers are the system's, and then warns of what is not wrong within std::string.
    target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
  if(P_OF AND NOT P_OF STREQUAL target)
    target_precompile_headers(${target} REUSE_FROM ${P_OF})
  else()
    target_precompile_headers(${target} PRIVATE ${VELUM_STANDARD_HEADERS} ${P_UNPARSED_ARGUMENTS})
  endif()
endfunction()
