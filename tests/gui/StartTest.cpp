// What is said before there is a window; start_test.py runs the program itself.
#include <gtest/gtest.h>

#include <QApplication>
#include <QMessageBox>
#include <QTimer>

#include "gpu/GpuError.h"
#include "gui/window/Start.h"

namespace velum::gui {

TEST(Start, WhatIsMissingIsSaidInADialogOnlyWhereSomebodyAsks) {
  QString shown;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      shown = box->text();
      box->accept();
    }
  });
  timer.start(20);
  gpu::GpuError error("no driver of 4.5");
  testing::internal::CaptureStderr();
  EXPECT_EQ(refuseStart(error, false), 3);
  EXPECT_TRUE(shown.isEmpty());
  EXPECT_EQ(refuseStart(error, true), 3);
  EXPECT_TRUE(shown.contains("no driver of 4.5")) << shown.toStdString();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "velum: no driver of 4.5\nvelum: no driver of 4.5\n");
}

TEST(Start, ADriverThatWillDoIsNotRefused) {
  testing::internal::CaptureStderr();
  {
    StartMessages messages;
    EXPECT_NO_THROW(EXPECT_EQ(chooseSurface().why, ""));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Start, WhatQtHasSaidMeanwhileIsToldOrDropped) {
  for (bool drops : {false, true}) {
    testing::internal::CaptureStderr();
    {
      StartMessages messages;
      qWarning("a word of Qt's");
      EXPECT_EQ(StartMessages::warnings().last(), "a word of Qt's");
      if (drops) messages.drop();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), drops ? "" : "a word of Qt's\n");
  }
}

}  // namespace velum::gui
