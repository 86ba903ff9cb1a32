#pragma once
// Purpose: the first frames of a 3D view in short turns. When a prop is first drawn in an OpenGL context, its programs are compiled
// and its buffers filled, and again when it is first drawn with depth peeling. With OpenGL in software all props at once would take
// longer than the window may be busy, so a frame draws only a few new ones and the next frames the rest.

#include <vtkRenderer.h>

#include <array>
#include <set>
#include <span>
#include <vector>

namespace glisson {

class FirstFrames {
 public:
  static constexpr std::size_t kNewProps = 3;  ///< in a frame; in the first of a context one

  struct Held {
    bool anyNew = false;  ///< something is drawn for the first time: what the frame takes says nothing about the next
    bool more = false;    ///< something is hidden: another frame is due
  };
  /// Hides all but the first of the visible props that were not drawn before, until release().
  Held hold(std::span<vtkRenderer* const> layers, bool peels);
  void release();

 private:
  std::array<std::set<const vtkProp*>, 2> drawn_;  ///< without depth peeling, with it
  std::vector<vtkProp*> held_;
};

}  // namespace glisson
