#pragma once
// Waiting for facts, not for time: runs the event loop until a condition holds.

#include <QTest>

namespace glisson::test {

template <class Condition>
bool waitFor(Condition condition, int milliseconds = 30000) {
  return QTest::qWaitFor(condition, milliseconds);
}

}  // namespace glisson::test
