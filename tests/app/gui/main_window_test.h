#pragma once
// What the window's tests share: widgets found by name and clicked, and a main window that is shown, with two threads for its jobs
// and a recovery folder of its own.

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>

#include "app/gui/main_window.h"
#include "app/jobs/thread_job_runner.h"
#include "small_case.h"
#include "wait.h"

namespace glisson::test {

/// Tests that drive one window, which they make themselves.
template <class Window>
class DrivenWindow : public testing::Test {
 protected:
  std::unique_ptr<Window> window;

  template <class T>
  T* find(const QString& name) {
    T* found = window->template findChild<T*>(name);
    EXPECT_NE(found, nullptr) << name.toStdString();
    return found;
  }
  void click(const QString& name) { QTest::mouseClick(find<QWidget>(name), Qt::LeftButton); }
};

class MainWindowTest : public DrivenWindow<MainWindow> {
 protected:
  QTemporaryDir folder;
  Language language;
  std::unique_ptr<ThreadJobRunner> jobs = std::make_unique<ThreadJobRunner>(2);

  void SetUp() override {
    language.use("en");
    window = std::make_unique<MainWindow>(*jobs, language, folder.filePath("recovery").toStdString());
    window->resize(1024, 700);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  void TearDown() override {
    jobs.reset();
    window.reset();
  }
  Document& document() { return window->document(); }

  /// Opens the small case by way of the opener's signal, as after reading, and waits for the whole model.
  void openSmall() {
    emit window->opener().opened(smallCase(), nullptr, {});
    ASSERT_TRUE(settle());
    ASSERT_EQ(window->builder().missing(), 0);
  }
  bool settle() {
    return waitFor([this] { return jobs->idle() && document().freshness() == Freshness::All; });
  }
};

}  // namespace glisson::test
